/* Pictures as SVG. Takes numbers; returns axes and paths. Signs are those of `slowflow.answers.pictures`. */

const SVG = "http://www.w3.org/2000/svg";

/** Steps of 1, 2 or 5 times a power of ten: about `count` between low and high. */
function ticks(low, high, count) {
  const rough = (high - low) / count;
  const ten = 10 ** Math.floor(Math.log10(rough));
  const step = ten * ([1, 2, 5, 10].find((k) => k * ten >= rough) || 10);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return { step, at: found };
}

/** The next larger of a few round numbers, so that an axis stands still while a slider moves. */
function roundUp(value) {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const ten = 10 ** Math.floor(Math.log10(value));
  return ten * [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10].find((k) => k * ten >= value * 0.999999) || value;
}

class Plot {
  /** Axes in an element; layers are drawn in the order of their names. */
  constructor(element, layers) {
    this.element = element;
    this.svg = document.createElementNS(SVG, "svg");
    this.svg.setAttribute("role", "img");
    element.append(this.svg);
    const clip = `clip-${element.id}`;
    this.svg.innerHTML =
      `<title></title><defs><clipPath id="${clip}"><rect/></clipPath></defs><g class="grid"></g>` +
      `<g clip-path="url(#${clip})">${layers.map((name) => `<g class="${name}"></g>`).join("")}</g><g class="axes"></g>`;
    this.clip = this.svg.querySelector("clipPath rect");
    this.layer = Object.fromEntries(["grid", "axes", ...layers].map((name) => [name, this.svg.querySelector(`g.${name}`)]));
    this.title = this.svg.querySelector("title");
    this.resize();
  }

  resize() {
    this.width = Math.max(240, this.element.clientWidth);
    this.height = Math.max(160, this.element.clientHeight);
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.drawn = "";
  }

  /** Limits in what is shown (`scale` times what is plotted), and labels. */
  limits(x, y, scale, labels) {
    const room = { left: 54, right: 14, top: 10, bottom: 40 };
    const wide = this.width - room.left - room.right;
    const high = this.height - room.top - room.bottom;
    this.room = room;
    this.box = { left: room.left, top: room.top, wide, high };
    this.x = (value) => room.left + ((value - x[0]) / (x[1] - x[0])) * wide;
    this.y = (value) => room.top + (1 - (value - y[0]) / (y[1] - y[0])) * high;
    this.xOf = (pixel) => x[0] + ((pixel - room.left) / wide) * (x[1] - x[0]);
    this.yOf = (pixel) => y[0] + (1 - (pixel - room.top) / high) * (y[1] - y[0]);
    const now = JSON.stringify([x, y, scale, labels, this.width, this.height]);
    if (now === this.drawn) return;
    this.drawn = now;
    for (const [name, value] of Object.entries({ x: room.left, y: room.top, width: wide, height: high }))
      this.clip.setAttribute(name, value);
    const across = ticks(x[0] * scale.x, x[1] * scale.x, Math.max(4, wide / 70));
    const up = ticks(y[0] * scale.y, y[1] * scale.y, Math.max(4, high / 40));
    const digits = (step) => Math.min(8, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
    const text = (value, step) =>
      step < 1e-4 || step >= 1e5 ? short(value, 2) : value.toFixed(digits(step)).replace("-", "−");
    let grid = "";
    let axes = `<rect class="frame" x="${room.left}" y="${room.top}" width="${wide}" height="${high}"/>`;
    for (const value of across.at) {
      const at = this.x(value / scale.x).toFixed(1);
      grid += `<path d="M${at},${room.top}v${high}"/>`;
      axes += `<text x="${at}" y="${room.top + high + 16}" text-anchor="middle">${text(value, across.step)}</text>`;
    }
    for (const value of up.at) {
      const at = this.y(value / scale.y).toFixed(1);
      grid += `<path d="M${room.left},${at}h${wide}"/>`;
      axes += `<text x="${room.left - 7}" y="${Number(at) + 4}" text-anchor="end">${text(value, up.step)}</text>`;
    }
    axes += `<text class="label" x="${room.left + wide / 2}" y="${this.height - 6}" text-anchor="middle">${lowered(labels.x)}</text>`;
    axes += `<text class="label" transform="translate(13 ${room.top + high / 2}) rotate(-90)" text-anchor="middle">${lowered(labels.y)}</text>`;
    this.layer.grid.innerHTML = grid;
    this.layer.axes.innerHTML = axes;
  }

  /** A polyline's path; a gap where a number is none or the branch changes. Points far outside are drawn at the rim. */
  path(xs, ys, n, branch) {
    let text = "";
    let pen = "M";
    const least = this.y(this.yOf(0)) - 4000;
    for (let i = 0; i < n; i++) {
      const x = this.x(xs[i]);
      const y = Math.min(8000, Math.max(least, this.y(ys[i])));
      if (branch && i > 0 && branch[i] !== branch[i - 1]) pen = "M";
      if (!(Math.abs(x) < 20000) || Number.isNaN(y)) {
        pen = "M";
        continue;
      }
      text += `${pen}${x.toFixed(1)},${y.toFixed(1)}`;
      pen = "L";
    }
    return text;
  }

  /** Stable stretches and unstable ones, as two paths; neighbours share the point between them. */
  stretches(xs, ys, stable, branch) {
    const parts = { stable: "", unstable: "" };
    for (let start = 0; start < xs.length; ) {
      let stop = start + 1;
      while (stop < xs.length && stable[stop] === stable[start] && branch[stop] === branch[start]) stop++;
      const joined = start > 0 && branch[start - 1] === branch[start] ? 1 : 0;
      const part = this.path(xs.subarray(start - joined, stop), ys.subarray(start - joined, stop), stop - start + joined);
      parts[stable[start] ? "stable" : "unstable"] += part;
      start = stop;
    }
    return parts;
  }

  set(layer, text) {
    this.layer[layer].innerHTML = text;
  }

  /** Where an event of a pointer is, in what is plotted. */
  where(event) {
    const box = this.svg.getBoundingClientRect();
    return {
      x: this.xOf(((event.clientX - box.left) / box.width) * this.width),
      y: this.yOf(((event.clientY - box.top) / box.height) * this.height),
    };
  }
}

/** A path, unless one of its numbers is none. */
const line = (name, d) => (d && !/NaN|Infinity/.test(d) ? `<path class="${name}" d="${d}"/>` : "");
const rectangle = (name, x, y, wide, high) =>
  wide > 0 && high > 0 && Math.abs(x) + Math.abs(y) + wide + high < 1e5 ? `<rect class="${name}" x="${x.toFixed(1)}" y="${y.toFixed(1)}" width="${wide.toFixed(1)}" height="${high.toFixed(1)}"/>` : "";

function triangle(x, y, up) {
  if (!(Math.abs(x) + Math.abs(y) < 1e5)) return "";
  const tip = up ? -6 : 6;
  return `<path class="jump" d="M${(x - 5.5).toFixed(1)},${y - tip / 1.4}h11l-5.5,${tip * 1.7}z"/>`;
}

/** What an answer says, as the response plane has it. */
function drawResponse(plot, answer, shown) {
  const { state, curve, folds, breaks, plain, reach } = answer;
  const { high, top } = answer.window;
  const omega = measure(state, "Omega");
  const length = measure(state, "A");
  const unit = (of, name) => `${plainSymbol(name)}${of.unit && ` / ${of.unit}`}`;
  plot.limits([0, high], [0, top], { x: omega.size, y: length.size * length.shown }, {
    x: `frequency ${state.si ? unit(omega, "f") : "Ω"}`,
    y: `amplitude ${unit(length, "A")}`,
  });
  const { left, wide } = plot.box;
  let regions = "";
  if (shown.regions) {
    if (breaks.length && breaks[0] < top) regions += rectangle("detached", left, plot.box.top, wide, plot.y(breaks[0]) - plot.box.top);
    if (answer.unstable) {
      const { A, low, high: ends, step, n } = answer.unstable;
      let d = "";
      for (let i = 0; i < n; i++) {
        const y = plot.y(A[i] + step / 2);
        d += `M${plot.x(low[i]).toFixed(1)},${y.toFixed(1)}H${plot.x(ends[i]).toFixed(1)}V${(plot.y(A[i] - step / 2) + 0.3).toFixed(1)}H${plot.x(low[i]).toFixed(1)}z`;
      }
      regions += line("unstable-region", d);
    }
    if (plain.mu > 0) {
      const xs = Float64Array.from({ length: 120 }, (_, i) => (high * (i + 1)) / 120);
      const ys = xs.map((Omega) => Math.min(plain.mu / (Omega * Omega), 2 * top));
      regions += line("stopping", `${plot.path(xs, ys, 120)}V${plot.y(0)}H${plot.x(0)}V${plot.y(2 * top)}z`);
    }
  }
  for (const [i, b] of breaks.entries())
    if (b < top)
      regions += line("break", `M${left},${plot.y(b).toFixed(1)}h${wide}`) + `<text class="name" x="${left + wide - 4}" y="${(plot.y(b) - 5).toFixed(1)}" text-anchor="end">${lowered(`${DATA.mechanisms[state.mechanism].odd ? "" : "to "}${nameIn(state, "u_cr")}${breaks.length > 1 ? ` ${i + 1}` : ""}`)}</text>`;
  if (reach < top)
    regions += line("break", `M${left},${plot.y(reach).toFixed(1)}h${wide}`) + `<text class="name" x="${left + wide - 4}" y="${(plot.y(reach) - 5).toFixed(1)}" text-anchor="end">not reached above</text>`;
  plot.set("regions", regions);
  let beside = "";
  const { backbone, envelope, locus } = answer;
  if (backbone) beside += line("backbone", plot.path(backbone.Omega, backbone.A, backbone.n));
  if (envelope) beside += line("envelope", plot.path(envelope.Omega, envelope.A, envelope.n));
  if (answer.random)
    for (const u of answer.random.u || [])
      if (u < top) beside += line("rms", `M${left},${plot.y(u).toFixed(1)}h${wide}`) + `<text class="name" x="${left + 4}" y="${(plot.y(u) - 5).toFixed(1)}">rms</text>`;
  if (locus) beside += line("locus", plot.path(locus.Omega, locus.A, locus.n, locus.branch));
  plot.set("beside", beside);
  const parts = plot.stretches(curve.Omega, curve.A, curve.stable, curve.branch);
  let text = line("unstable", parts.unstable) + line("stable", parts.stable);
  for (let i = 0; i < folds.n; i++) text += triangle(plot.x(folds.Omega[i]), plot.y(folds.A[i]), folds.up[i]);
  plot.set("curve", text);
}

/** Where the oscillator is now, the other states at its frequency, and the way it came. */
function drawPoint(plot, states, now, trail) {
  let text = "";
  if (now) {
    const x = plot.x(now.Omega).toFixed(1);
    text += `<path class="cursor" d="M${x},${plot.box.top}v${plot.box.high}"/>`;
    if (trail.length > 1)
      text += line("trail", plot.path(trail.map((at) => at.Omega), trail.map((at) => at.A), trail.length));
    for (let i = 0; i < states.n; i++)
      text += `<circle class="${states.stable[i] ? "other" : "other loose"}" cx="${x}" cy="${plot.y(states.A[i]).toFixed(1)}" r="4"/>`;
    if (now.shown > 0) text += `<circle class="now" cx="${x}" cy="${plot.y(now.shown).toFixed(1)}" r="6.5"/>`;
  }
  plot.set("point", text);
}

/** Transmissibility in decibels. */
function drawTransmissibility(plot, answer) {
  const { state, curve } = answer;
  const omega = measure(state, "Omega");
  const dB = curve.T.map((T) => 20 * Math.log10(T));
  const most = Math.max(10, Math.ceil(dB.reduce((a, b) => Math.max(a, b), 0) / 10) * 10);
  plot.limits([0, answer.window.high], [-40, most], { x: omega.size, y: 1 }, {
    x: `frequency ${state.si ? "f / Hz" : "Ω"}`,
    y: "transmissibility / dB",
  });
  const parts = plot.stretches(curve.Omega, dB, curve.stable, curve.branch);
  plot.set("beside", line("break", `M${plot.box.left},${plot.y(0).toFixed(1)}h${plot.box.wide}`));
  plot.set("curve", line("unstable", parts.unstable) + line("stable", parts.stable));
}

/** The force, the present amplitude, and where pieces end. */
function drawForce(plot, answer, now) {
  const { state, places, force } = answer;
  const length = measure(state, "A");
  const newton = measure(state, "force");
  const reach = force.u[force.n - 1];
  const most = roundUp(force.f.reduce((top, f) => Math.max(top, Math.abs(f)), 1e-12));
  plot.limits([-reach, reach], [-most, most], { x: length.size * length.shown, y: newton.size * newton.shown }, {
    x: `displacement ${state.si ? "x / mm" : "u"}`,
    y: `spring force ${state.si ? "/ N" : "f(u)"}`,
  });
  let text = "";
  if (now && now.A > 0) {
    const [low, high] = [Math.max(now.B - now.A, -reach), Math.min(now.B + now.A, reach)];
    text += rectangle("stroke", plot.x(low), plot.box.top, plot.x(high) - plot.x(low), plot.box.high);
  }
  for (const at of places)
    if (Math.abs(at) < reach) text += line("break", `M${plot.x(at).toFixed(1)},${plot.box.top}v${plot.box.high}`);
  text += line("break", `M${plot.box.left},${plot.y(0).toFixed(1)}h${plot.box.wide}`);
  plot.set("beside", text);
  plot.set("curve", line("stable", plot.path(force.u, force.f, force.n)));
}
