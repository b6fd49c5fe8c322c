/* The page. Takes moves of sliders, fields, pointers and keys; returns pictures and words. */

const SAMPLES = 800;
const ROWS = 160;
/* steps that a frequency is moved in, so that a jump is seen where it is */
const STEPS = 24;
const $ = (id) => document.getElementById(id);
const app = { state: null, answer: null, now: null, trail: [], sweep: 0, cycle: 0, dirty: true, fields: {} };

/* ==== Answers ====================================================================================================== */

function shownLayers() {
  return Object.fromEntries(["regions", "backbone", "envelope", "locus"].map((name) => [name, $(`show-${name}`).checked]));
}

/** All that is asked of the solvers for a state. */
function ask(solvers, state, shown) {
  const plain = dimensionless(state);
  const breaks = solvers.choose(state.mechanism, numbersOf(state, plain), state.excitation);
  if (breaks === null) return null;
  const about = DATA.mechanisms[state.mechanism];
  const friction = solvers.sticking();
  const answer = { state, plain, breaks, places: solvers.places(), friction, sticking: friction, reach: solvers.reach(), stiffnessAtRest: solvers.stiffnessAtRest() };
  /* a base or an unbalance moves the mass however small it is, from a frequency on */
  if (byInertia(state)) Object.assign(answer, { sticking: 0, sticksUpTo: Math.sqrt(friction / plain.F_0) });
  answer.onset = solvers.onset();
  answer.detachment = solvers.detachment();
  answer.peak = solvers.peak(plain.F_0);
  if (state.psd) answer.random = randomOf(solvers, state, plain);
  answer.folds = solvers.folds(plain.F_0);
  answer.curve = solvers.respond(plain.F_0, 0, state.high, SAMPLES);
  const { curve } = answer;
  const seen = curve.A.reduce((most, A, i) => (curve.Omega[i] > 0.02 * state.high ? Math.max(most, A) : most), 0);
  const top = roundUp(1.08 * Math.max(seen, curve.n ? 0 : 0.2 * plain.F_0, ...(answer.random?.u || [])));
  answer.window = { high: state.high, top };
  if (shown.backbone) answer.backbone = solvers.backbone(top, 200);
  if (shown.envelope && plain.zeta > 0 && plain.F_0 > answer.sticking) answer.envelope = solvers.envelope(plain.F_0, state.high, 200);
  if (shown.regions) answer.unstable = solvers.unstable(top, state.high, ROWS);
  if (shown.locus) answer.locus = solvers.locus(top, 400);
  const mean = curve.B.reduce((most, B) => Math.max(most, Math.abs(B)), 0);
  const wide = 1.35 * Math.max(breaks[0] || 0, Math.min(top, 1.5 * seen || top) + mean, about.odd ? 0 : Math.abs(answer.places[0]));
  answer.force = solvers.force(Math.min(0.999 * answer.reach, roundUp(wide)), 241);
  return answer;
}

/** Index of the stable state whose amplitude is next to A; -1 where there is none. */
function nearest(states, A) {
  let found = -1;
  for (let i = 0; i < states.n; i++)
    if (states.stable[i] && (found < 0 || Math.abs(states.A[i] - A) < Math.abs(states.A[found] - A))) found = i;
  return found;
}

/** Moves to a frequency in small steps along the branch; a jump is told. */
function moveTo(Omega) {
  const { answer, now } = app;
  if (answer.curve.status !== 0 || !answer.curve.n) {
    app.states = { n: 0, stable: [] };
    app.now = { Omega, A: 0, shown: 0 };
    return;
  }
  const start = now ? now.Omega : Omega;
  let A = now ? now.A : 0;
  let at = app.states;
  for (let k = 1; k <= STEPS; k++) {
    const here = k === STEPS ? Omega : start + ((Omega - start) * k) / STEPS;
    if (start === Omega && k < STEPS) continue;
    at = app.solvers.states(answer.plain.F_0, here);
    const i = nearest(at, A);
    const next = i < 0 ? 0 : at.A[i];
    const passed = answer.folds.Omega.some((fold) => (fold - here) * (fold - (start + ((Omega - start) * (k - 1)) / STEPS)) <= 0);
    if (passed && Math.abs(next - A) > 0.04 * answer.window.top && start !== Omega) jumped(here, A, next);
    A = next;
    if (app.sweep) app.trail.push({ Omega: here, A });
  }
  app.states = at;
  app.now = { Omega, A, shown: now && app.now.shown !== undefined ? app.now.shown : A };
}

function jumped(Omega, from, to) {
  const { state } = app.answer;
  const text = `Jumped ${to > from ? "up" : "down"} at ${nameIn(state, "Omega")} = ${told(state, "Omega", Omega, 5)}, from ${told(state, "A", from)} to ${told(state, "A", to)}.`;
  $("events").textContent = text;
  app.jumps = (app.jumps || 0) + 1;
}

/** The state as fields have it: asked again, drawn again. */
function refresh() {
  const { state } = app;
  const answer = ask(app.solvers, state, shownLayers());
  if (answer === null) return;
  app.answer = answer;
  const A = app.now ? app.now.A : state.level === undefined ? Infinity : state.level;
  app.now = { Omega: state.Omega, A: Number.isFinite(A) ? A : 1e9, shown: app.now ? app.now.shown : undefined };
  moveTo(state.Omega);
  if (app.now.shown === undefined || !Number.isFinite(app.now.shown) || app.now.shown > 1e8) app.now.shown = app.now.A;
  draw();
  say();
  map();
}

function draw() {
  const { answer, plots } = app;
  drawResponse(plots.response, answer, shownLayers());
  drawTransmissibility(plots.transmissibility, answer);
  drawForce(plots.force, answer, present());
  drawMoving();
}

/** The present motion with its mean. */
function present() {
  const { now, states } = app;
  const i = states.n ? nearest(states, now.A) : -1;
  return { ...now, B: i < 0 ? 0 : states.B[i] };
}

/** What moves from frame to frame. */
function drawMoving() {
  const { plots, now, answer, states } = app;
  drawPoint(plots.response, states, now, app.trail);
  const i = states.n ? nearest(states, now.A) : -1;
  const phi = i < 0 ? 0 : states.phi[i];
  const u = (i < 0 ? 0 : states.B[i]) + now.shown * Math.cos(app.cycle + phi);
  const push = answer.curve.status === 0 ? Math.cos(app.cycle) : 0;
  drawSchematic($("schematic-picture"), answer, present(), u, push);
  const T = i < 0 ? NaN : 20 * Math.log10(states.T[i]);
  const dot = (plot, x, y) => (Number.isFinite(y) ? `<circle class="now" cx="${plot.x(x).toFixed(1)}" cy="${plot.y(y).toFixed(1)}" r="5"/>` : "");
  plots.transmissibility.set("point", dot(plots.transmissibility, now.Omega, T));
  const { force } = answer;
  const at = ((u / force.u[force.n - 1] + 1) / 2) * (force.n - 1);
  const k = Math.floor(at);
  const f = k >= 0 && k + 1 < force.n ? force.f[k] + (force.f[k + 1] - force.f[k]) * (at - k) : NaN;
  plots.force.set("point", now.A > 0 ? dot(plots.force, u, f) : "");
}

/* ==== Words ======================================================================================================== */

function card(title, value, note, kind = "") {
  return `<div class="card ${kind}"><dt>${title}</dt><dd>${value}<small>${note}</small></dd></div>`;
}

/** The highest peak, its note, and both as part of a sentence; in words where no motion is that large. */
function peakIn(answer) {
  const { state, peak, reach } = answer;
  const at = `at ${nameIn(state, "Omega")} = ${told(state, "Omega", peak.Omega)}`;
  if (peak.beyond) return { value: "–", note: "none within the well", text: "no peak within the well" };
  if (peak.status !== DATA.status.OK) return { value: peak.status === DATA.status.UNBOUNDED ? "unbounded" : "–", note: "", text: "no peak" };
  if (peak.A > reach) return { value: "not reached", note: sentence(beyondReach(answer)), text: `peak above ${told(state, "A", reach)}, which is not reached` };
  return { value: told(state, "A", peak.A), note: at, text: `peak ${told(state, "A", peak.A)} ${at}` };
}

/** Root mean squares, and what they are those of. */
function randomCard({ state, random }) {
  const each = (text) => Array.from({ length: random.n }, (_, i) => text(i)).join("<br>");
  const friction = (i) => (random.friction[i] > 0 ? `, friction ${percent(random.friction[i])} of the damping` : "");
  return card(
    "<span>RMS under the PSD</span>",
    random.n ? each((i) => told(state, "A", random.u[i])) : "–",
    random.n ? each((i) => `equivalent natural frequency ${told(state, "Omega", Math.sqrt(random.k[i]))}${friction(i)}`) : random.word,
  );
}

function say() {
  const { answer } = app;
  const { state, onset, detachment, folds, breaks, plain, reach } = answer;
  const F = nameIn(state, "F_0");
  const frequency = nameIn(state, "Omega");
  const near = (name, value) => told(state, name, value);
  const reached = (value, A) => (A > reach ? "not reached" : value);
  const peak = peakIn(answer);
  const ok = DATA.status.OK;
  const u_cr = symbol(nameIn(state, "u_cr"));
  const jumps = folds.status === ok && folds.n > 0;
  /* no amplitude is lower at a higher frequency then, where it tends to F_0 */
  const tends = byInertia(state) && detachment.status !== ok && breaks.length > 0;
  $("answers").innerHTML =
    card(
      `${symbol(criticalIn(state, "SN"))} <span>jumps above</span>`,
      onset.status === ok ? reached(near("F_0", onset.F_SN), onset.A) : onset.status === DATA.status.UNBOUNDED ? `> ${near("F_0", answer.sticking)}` : "never",
      [
        onset.status === ok ? `at ${frequency} = ${near("Omega", onset.Omega)}, ${DATA.onset_kinds[onset.kind]}` : "",
        onset.rest < (onset.status === ok ? onset.F_SN : Infinity) ? `other folds, beginning at ${frequency} = 0, above ${near("F_0", onset.rest)}` : "",
      ].filter(Boolean).join("; "),
      onset.status === ok && plain.F_0 > onset.F_SN ? "passed" : "",
    ) +
    card(
      `${symbol(criticalIn(state, "cr"))} <span>${DATA.mechanisms[state.mechanism].rod ? "springs detach above" : `passes ${u_cr} above`}</span>`,
      detachment.status === ok ? near("F_0", detachment.F_cr) : tends ? near("F_0", breaks[0]) : "never",
      tends ? `as ${frequency} tends to ∞` : detachment.status === ok ? `at ${frequency} = ${near("Omega", detachment.Omega)}, ${u_cr} = ${near("A", detachment.u_cr)}` : "the force has no breakpoint",
      detachment.status === ok && plain.F_0 > detachment.F_cr ? "passed" : "",
    ) +
    (byInertia(state)
      ? card(`${frequency} <span>mass sticks up to</span>`, near("Omega", answer.sticksUpTo), "the inertia force does not overcome friction there")
      : card(`4${symbol(nameIn(state, "mu"))}/π <span>mass sticks up to</span>`, near("F_0", answer.sticking), plain.F_0 <= answer.sticking ? `${F} is below` : "", plain.F_0 <= answer.sticking ? "passed" : "")) +
    card(`<i>A</i> <span>peak</span>`, peak.value, peak.note) +
    card(
      `<span>jumps at</span> ${symbol(F)} <span>= ${near("F_0", plain.F_0)}</span>`,
      jumps ? Array.from(folds.Omega, (Omega, i) => `${folds.up[i] ? "↑" : "↓"} ${reached(near("Omega", Omega), folds.A[i])}`).join("<br>") : "none",
      jumps ? `${frequency} where a sweep jumps` : "one state at each frequency",
    ) +
    (answer.random ? randomCard(answer) : "");
  const said = remarksOf(answer);
  $("remarks").innerHTML = said.map((text) => `<li>${sentence(text)}</li>`).join("");
  sayStates();
  const summary = `Response at ${F} = ${near("F_0", plain.F_0)}: ${jumps ? `${folds.n} folds` : "no fold"}, ${peak.text}${breaks.length ? `, ${DATA.mechanisms[state.mechanism].rod ? "springs detach" : "the spring changes"} at ${near("A", breaks[0])}` : ""}.`;
  app.plots.response.title.textContent = summary;
  app.plots.force.title.textContent = "Restoring force over displacement, with the stroke of the selected motion.";
  app.plots.transmissibility.title.textContent = "Transmissibility in decibels over frequency.";
  app.map.plot.title.textContent = "Design map; a cross marks the selected design.";
}

/** The states at the present frequency as a table, and how far the present one may be off. */
function sayStates() {
  const { answer, states, now } = app;
  const { state, plain, breaks, reach } = answer;
  const i = states.n ? nearest(states, now.A) : -1;
  const about = DATA.mechanisms[state.mechanism];
  $("about-what").textContent = about.odd ? "about the centre" : "about the mean of the motion";
  const rows = Array.from({ length: states.n }, (_, k) => {
    const errors = errorsOf(state.mechanism, state.excitation, breaks, plain.mu, plain.F_0, states.Omega[k], states.A[k]);
    return `<tr${k === i ? ' class="here"' : ""}><td>${told(state, "A", states.A[k], 5)}${about.odd ? "" : ` about ${told(state, "A", states.B[k], 3)}`}</td><td>${states.A[k] > reach ? "not reached" : states.stable[k] ? "stable" : "unstable"}</td><td>${short((states.phi[k] * 180) / Math.PI, 3)}°</td><td>${short(20 * Math.log10(states.T[k]), 3)} dB</td><td>${errors ? `${short(100 * errors.error, 2)} %` : "–"}</td></tr>`;
  });
  $("at").textContent = `${nameIn(state, "Omega")} = ${told(state, "Omega", now.Omega, 5)}`;
  const held = byInertia(state) ? now.Omega <= answer.sticksUpTo : plain.F_0 <= answer.sticking;
  $("states").innerHTML = rows.join("") || `<tr><td colspan="5">${held ? "Held by friction: the amplitude is 0, the transmissibility 0 dB." : "No state."}</td></tr>`;
  $("error").textContent = i < 0 ? "" : errorInWords(errorsOf(state.mechanism, state.excitation, breaks, plain.mu, plain.F_0, now.Omega, now.A));
  const slider = $("frequency");
  slider.max = 1000;
  slider.value = (1000 * now.Omega) / state.high;
  slider.setAttribute("aria-valuetext", `${told(state, "Omega", now.Omega, 5)}, amplitude ${told(state, "A", now.A)}`);
}

/* ==== Controls ===================================================================================================== */

/** Ends of a slider, dimensionless, and how its share of the way is mapped: squared where numbers begin at 0. */
function rangeOf(domain, value) {
  const least = domain.above ?? domain.least;
  const most = domain.below ?? domain.most;
  if (least === undefined) return { low: -3 * Math.max(1, Math.abs(value)), high: 3 * Math.max(1, Math.abs(value)), curved: false };
  const rounded = roundUp(4 * (value > 0 ? value : 0.02));
  if (most !== undefined) return { low: least, high: Math.min(least + 0.95 * (most - least), Math.max(rounded, value)), curved: true };
  return { low: least, high: rounded, curved: true };
}

/** Ends of each number's slider; they grow when a field exceeds them, and begin anew with a preset. */
function ranges(state) {
  const plain = dimensionless(state);
  for (const domain of domains(state)) {
    const { name } = domain;
    const known = app.ranges[name];
    if (!known || plain[name] > known.high || plain[name] < known.low) app.ranges[name] = rangeOf(domain, plain[name]);
  }
}

function shareOf({ low, high, curved }, value) {
  const share = Math.min(1, Math.max(0, (value - low) / (high - low)));
  return 1000 * (curved ? Math.sqrt(share) : share);
}

function valueOf({ low, high, curved }, share, domain) {
  const part = share / 1000;
  const value = low + (high - low) * (curved ? part * part : part);
  const tidy = Number(value.toPrecision(4));
  return holds(domain, tidy) ? tidy : low + (high - low) * 1e-6;
}

function field(name, doc, label, unit) {
  return `<div class="field"><label for="number-${name}" title="${plainSymbol(doc)}">${label}</label>
<input id="number-${name}" type="text" inputmode="decimal" autocomplete="off" spellcheck="false"><span class="unit">${unit}</span>
<input id="range-${name}" type="range" min="0" max="1000" step="any" aria-label="${plainSymbol(doc)}"></div>`;
}

function excitationPicker(state) {
  const options = Object.entries(DATA.excitations).map(([name, one]) => `<option value="${name}"${name === state.excitation ? " selected" : ""}>${one.title}</option>`);
  return `<label class="picker wide"><span class="sr">Kind of excitation</span><select id="excitation">${options.join("")}</select></label>`;
}

/** Another excitation of the same amplitude without dimensions. */
function excite(excitation) {
  const { state } = app;
  const { F_0 } = dimensionless(state);
  state.excitation = excitation;
  state.values.F_0 = F_0 * measure(state, "F_0").size;
  delete app.ranges.F_0;
  app.now = null;
  changed();
  buildFields();
}

/** The fields of the mechanism and units that are chosen. */
function buildFields() {
  const { state } = app;
  const letter = (name) => symbol(nameIn(state, name));
  const of = (list) => list.map((one) => field(one.name, one.doc, letter(one.name), measure(state, one.name).unit)).join("");
  const about = DATA.mechanisms[state.mechanism];
  $("fields").innerHTML =
    `<fieldset><legend>Excitation</legend>${excitationPicker(state)}${of([DATA.excitations[state.excitation]])}</fieldset>` +
    `<fieldset><legend>Random vibration of the base</legend><div class="field"><label for="psd">PSD</label>
<input id="psd" type="text" autocomplete="off" spellcheck="false" placeholder="${state.si ? "1 1e-5; 100 1e-7" : "0.5 1e-4; 5 1e-5"}" title="points of a one-sided density: frequency and density; linear in log-log between them${state.si ? "" : ", or the density of white noise alone"}">
<span class="unit">${state.si ? "Hz g²/Hz; …" : `${letter("Omega")} G; …`}</span></div></fieldset>` +
    `<fieldset><legend>Spring</legend>${of(about.design)}</fieldset>` +
    `<fieldset><legend>Damping</legend>${of(DATA.damping)}</fieldset>` +
    (state.si ? `<fieldset><legend>Mass and scales</legend>${BASE.map((one) => field(one.name, one.doc, symbol(one.name), one.unit)).join("")}</fieldset>` : "") +
    `<fieldset><legend>Shown</legend>${field("high", "highest frequency shown", letter("Omega"), measure(state, "Omega").unit)}</fieldset>`;
  $("excitation").addEventListener("change", (event) => excite(event.target.value));
  $("psd").value = writeDensity(state.psd);
  $("psd").addEventListener("input", (event) => {
    const text = event.target.value.trim();
    const density = text ? readDensity(text, state.si) : undefined;
    event.target.setAttribute("aria-invalid", density === null ? "true" : "false");
    if (density === null) return;
    state.psd = density;
    changed("psd");
  });
  const bind = (name, fromRange, read, write) => {
    const [number, range] = [$(`number-${name}`), $(`range-${name}`)];
    range.addEventListener("input", () => write(fromRange(Number(range.value))));
    number.addEventListener("input", () => {
      const text = number.value.trim().replace("−", "-").replace(",", ".");
      const ok = text !== "" && write(Number(text) / read.shown());
      number.setAttribute("aria-invalid", ok ? "false" : "true");
    });
    number.addEventListener("blur", () => number.getAttribute("aria-invalid") === "true" && (number.setAttribute("aria-invalid", "false"), fillFields()));
  };
  for (const domain of domains(state)) {
    const { name } = domain;
    const write = (value) => {
      const { size } = measure(state, name);
      if (!holds(domain, value / size)) return false;
      state.values[name] = value;
      changed(name);
      return true;
    };
    const fromRange = (share) => {
      const { size, shown } = measure(state, name);
      const value = valueOf(app.ranges[name], share, domain) * size;
      const tidy = Number((value * shown).toPrecision(4)) / shown;
      return holds(domain, tidy / size) ? tidy : value;
    };
    bind(name, fromRange, { shown: () => measure(state, name).shown }, write);
  }
  if (state.si)
    for (const { name, shown } of BASE)
      bind(name, (share) => Number((DATA.mount.base[name] * 10 ** (share / 500 - 1)).toPrecision(4)), { shown: () => shown }, (value) => {
        if (!(value > 0 && Number.isFinite(value))) return false;
        state.base[name] = value;
        const plain = dimensionless(state);
        if (!domains(state).every((domain) => holds(domain, plain[domain.name]))) return false;
        changed(name);
        return true;
      });
  bind("high", (share) => Number((0.5 + (share / 1000) ** 2 * 9.5).toPrecision(3)) * measure(state, "Omega").size, { shown: () => 1 }, (value) => {
    const high = value / measure(state, "Omega").size;
    if (!(high > 1e-6 && high < 1e6)) return false;
    state.high = high;
    state.Omega = Math.min(state.Omega, high);
    changed("high");
    return true;
  });
  $("jump").textContent = `${criticalIn(state, "SN")}: jumps above`;
  $("leave").textContent = `${criticalIn(state, "cr")}: ${about.rod ? "springs detach above" : `passes ${nameIn(state, "u_cr")} above`}`;
  $("beyond").innerHTML = about.rod ? "springs detached" : `beyond ${symbol(nameIn(state, "u_cr"))}`;
  $("stops").innerHTML = inHTML(wordsIn(state).STOPS);
  const axes = [...about.design, ...DATA.damping];
  for (const id of ["map-x", "map-y"])
    $(id).innerHTML = axes.map((one) => `<option value="${one.name}">${nameIn(state, one.name)} – ${words(one.doc)}</option>`).join("");
  const before = app.axes || {};
  const has = (name) => axes.some((one) => one.name === name);
  $("map-x").value = has(before.x) ? before.x : axes[Math.min(1, axes.length - 3)].name;
  $("map-y").value = has(before.y) && before.y !== $("map-x").value ? before.y : axes[about.design.length - 1].name;
  if ($("map-x").value === $("map-y").value) $("map-y").value = "zeta";
}

/** Numbers into fields and sliders, but for the one that is being typed. */
function fillFields() {
  const { state } = app;
  const plain = dimensionless(state);
  const write = (name, text, share) => {
    const [number, range] = [$(`number-${name}`), $(`range-${name}`)];
    if (document.activeElement !== number) number.value = text;
    if (document.activeElement !== range) range.value = share;
    range.setAttribute("aria-valuetext", text);
  };
  const tidy = (value) => String(Number(value.toPrecision(12)));
  for (const { name } of domains(state))
    write(name, tidy(state.values[name] * measure(state, name).shown), shareOf(app.ranges[name], plain[name]));
  if (state.si)
    for (const { name, shown } of BASE)
      write(name, tidy(state.base[name] * shown), 500 * (Math.log10(state.base[name] / DATA.mount.base[name]) + 1));
  write("high", short(state.high * measure(state, "Omega").size, 4), 1000 * Math.sqrt(Math.max(0, (state.high - 0.5) / 9.5)));
  for (const option of $("excitation").options) option.disabled = byInertia({ excitation: option.value }) && !(state.values.zeta > 0 && DATA.mechanisms[state.mechanism].odd);
  $("units-si").checked = state.si;
  $("units-one").checked = !state.si;
  $("units-si").disabled = !DATA.mechanisms[state.mechanism].physical;
  $("mechanism").value = state.mechanism;
}

function changed(name) {
  /* a jump of another design */
  if (name) $("events").textContent = "";
  ranges(app.state);
  app.trail = [];
  app.dirty = true;
}

/** Another mechanism or preset. */
function open(state) {
  Object.assign(app, { state, ranges: {}, now: null, trail: [], sweep: 0 });
  $("events").textContent = "";
  ranges(state);
  buildFields();
  changed();
}

function map() {
  const { state } = app;
  const names = { x: $("map-x").value, y: $("map-y").value };
  app.axes = names;
  if (names.x === names.y || !app.map) return;
  const ends = (name) => [app.ranges[name].low, app.ranges[name].high];
  app.map.show(state, names, { x: ends(names.x), y: ends(names.y) }, $("map-quantity").value);
}

function sweepTo(direction) {
  app.sweep = app.sweep === direction ? 0 : direction;
  if (app.sweep) {
    app.trail = [];
    const { state } = app;
    if (direction > 0 && state.Omega > 0.97 * state.high) state.Omega = 0.05 * state.high;
    if (direction < 0 && state.Omega < 0.06 * state.high) state.Omega = state.high;
    app.now = null;
    refresh();
    app.now.shown = app.now.A;
  }
  for (const [id, which] of [["sweep-up", 1], ["sweep-down", -1]]) $(id).setAttribute("aria-pressed", String(app.sweep === which));
}

function setFrequency(Omega) {
  const { state } = app;
  state.Omega = Math.min(state.high, Math.max(1e-3 * state.high, Omega));
  moveTo(state.Omega);
  drawMoving();
  drawForce(app.plots.force, app.answer, present());
  sayStates();
  app.address = true;
}

function save(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** The response as a file of its own, in the light colours. */
function asSVG() {
  const copy = app.plots.response.svg.cloneNode(true);
  const { width, height } = app.plots.response;
  for (const [name, value] of Object.entries({ xmlns: SVG, width, height })) copy.setAttribute(name, value);
  const style = document.createElementNS(SVG, "style");
  style.textContent = $("picture-style").textContent;
  copy.prepend(style);
  return new XMLSerializer().serializeToString(copy);
}

function bindControls() {
  $("mechanism").innerHTML = [...new Set(DATA.presets.map((one) => one.mechanism))].map((name) => `<option value="${name}">${DATA.mechanisms[name].label}</option>`).join("");
  $("preset").innerHTML = '<option value="">Open a design…</option>' + [...DATA.presets, DATA.mount].map((one, i) => `<option value="${i}">${one.title}</option>`).join("");
  $("preset").addEventListener("change", (event) => {
    if (event.target.value !== "") open(fromPreset([...DATA.presets, DATA.mount][event.target.value]));
    event.target.value = "";
  });
  $("mechanism").addEventListener("change", (event) => {
    const preset = DATA.presets.find((one) => one.mechanism === event.target.value);
    const same = new Set(DATA.mechanisms[event.target.value].design.map((one) => one.name));
    const { state } = app;
    const { odd } = DATA.mechanisms[event.target.value];
    if (DATA.mechanisms[state.mechanism].design.every((one) => same.has(one.name)) && (odd || !byInertia(state))) open({ ...state, mechanism: event.target.value });
    else open(fromPreset(preset));
  });
  for (const [id, si] of [["units-si", true], ["units-one", false]])
    $(id).addEventListener("change", () => {
      convert(app.state, si);
      buildFields();
      changed();
    });
  for (const name of ["regions", "backbone", "envelope", "locus"]) $(`show-${name}`).addEventListener("change", () => changed());
  for (const id of ["map-x", "map-y", "map-quantity"])
    $(id).addEventListener("change", () => {
      if ($("map-x").value === $("map-y").value) {
        const other = [...$("map-x").options].map((one) => one.value).find((value) => value !== $(id).value);
        $(id === "map-x" ? "map-y" : "map-x").value = other;
      }
      map();
    });
  $("sweep-up").addEventListener("click", () => sweepTo(1));
  $("sweep-down").addEventListener("click", () => sweepTo(-1));
  $("frequency").addEventListener("input", (event) => {
    app.sweep && sweepTo(app.sweep);
    setFrequency((app.state.high * Number(event.target.value)) / 1000);
  });
  const response = $("response");
  const drag = (event) => setFrequency(app.plots.response.where(event).x);
  response.addEventListener("pointerdown", (event) => {
    app.sweep && sweepTo(app.sweep);
    response.setPointerCapture(event.pointerId);
    /* a press near another stable state starts from there */
    const at = app.plots.response.where(event);
    app.now = { Omega: at.x, A: at.y, shown: undefined };
    app.state.Omega = Math.min(app.state.high, Math.max(1e-3 * app.state.high, at.x));
    app.now.Omega = app.state.Omega;
    moveTo(app.state.Omega);
    app.now.shown = app.now.A;
    app.trail = [];
    setFrequency(app.state.Omega);
  });
  response.addEventListener("pointermove", (event) => event.buttons & 1 && drag(event));
  $("csv").addEventListener("click", () => save("response.csv", inCSV(app.answer), "text/csv"));
  $("svg").addEventListener("click", () => save("response.svg", asSVG(), "image/svg+xml"));
  const dialog = $("text");
  const show = (title, text) => {
    $("text-title").textContent = title;
    $("text-body").value = text;
    dialog.showModal();
    $("text-body").select();
  };
  $("python").addEventListener("click", () => show("The same in Python", inPython(app.state)));
  $("share").addEventListener("click", () => show("Link to this design", location.href.split("#")[0] + toAddress({ ...app.state, level: app.now.A })));
  $("copy").addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText($("text-body").value);
    } catch {
      $("text-body").select();
      document.execCommand("copy");
    }
    $("copy").textContent = "Copied";
    setTimeout(() => ($("copy").textContent = "Copy"), 1200);
  });
  $("close").addEventListener("click", () => dialog.close());
  $("theme").addEventListener("click", () => {
    const dark = getComputedStyle(document.documentElement).getPropertyValue("--dark").trim() === "1";
    document.documentElement.dataset.theme = dark ? "light" : "dark";
  });
  $("check").addEventListener("click", async () => ($("check-result").textContent = (await selfCheck()).text));
  addEventListener("hashchange", () => {
    if (location.hash === app.written) return;
    const state = fromAddress(location.hash);
    if (state) open(state);
  });
  new ResizeObserver(() => {
    for (const plot of [...Object.values(app.plots), app.map && app.map.plot]) plot && plot.resize();
    app.dirty = app.dirty || Boolean(app.answer);
  }).observe($("main"));
}

/* ==== Frames ======================================================================================================= */

let before = 0;

function tick(time) {
  const passed = Math.min(100, time - before);
  before = time;
  step(passed);
  requestAnimationFrame(tick);
}

/** One frame: what has changed is asked and drawn, what moves goes on. */
function step(passed) {
  if (app.dirty) {
    app.dirty = false;
    refresh();
    fillFields();
    app.address = true;
  }
  const { now, state } = app;
  if (!now) return;
  let moving = $("move").checked && now.A > 0;
  if (app.sweep) {
    const Omega = state.Omega + (app.sweep * state.high * passed) / 14000;
    if (Omega >= state.high || Omega <= 0.02 * state.high) sweepTo(app.sweep);
    else {
      state.Omega = Omega;
      moveTo(Omega);
      sayStates();
      drawForce(app.plots.force, app.answer, present());
    }
    moving = true;
  }
  /* the point falls to where it goes; how fast is not computed */
  const gap = app.now.A - app.now.shown;
  if (gap !== 0) {
    app.now.shown = Math.abs(gap) < 1e-4 * app.answer.window.top ? app.now.A : app.now.shown + gap * (1 - Math.exp(-passed / 90));
    moving = true;
  }
  if (moving) {
    if ($("move").checked) app.cycle = (app.cycle + passed * 0.0045 * Math.min(4, Math.max(0.2, now.Omega))) % (2 * Math.PI);
    drawMoving();
  }
  if (app.address && !(performance.now() - app.addressed < 400)) {
    app.address = false;
    app.addressed = performance.now();
    app.written = toAddress({ ...state, level: app.now.A });
    history.replaceState(null, "", app.written);
  }
}

/* ==== Self-check =================================================================================================== */

/** Numbers against those of the compiled Python package when the page was made, and the time that frames take. */
async function selfCheck() {
  let [same, compared, worst] = [0, 0, 0];
  const compare = (mine, theirs) => {
    compared++;
    if (Object.is(mine, theirs) || mine === theirs) same++;
    else worst = Math.max(worst, Math.abs(mine - theirs) / (Number.EPSILON * Math.abs(theirs)));
  };
  for (const one of DATA.references) {
    app.solvers.choose(one.mechanism, one.numbers, one.excitation);
    const onset = app.solvers.onset();
    [onset.F_SN, onset.Omega, onset.A].forEach((value, i) => one.onset && compare(value, one.onset[i]));
    const off = app.solvers.detachment();
    [off.F_cr, off.Omega].forEach((value, i) => one.detachment && compare(value, one.detachment[i]));
    const folds = app.solvers.folds(one.F_0);
    compare(folds.n, one.folds.Omega.length);
    one.folds.Omega.forEach((value, i) => compare(folds.Omega[i], value));
    one.folds.A.forEach((value, i) => compare(folds.A[i], value));
    const curve = app.solvers.respond(one.F_0, 0, one.high, one.samples);
    compare(curve.n, one.points);
    const states = app.solvers.states(one.F_0, one.Omega);
    compare(states.n, one.states.length);
    one.states.forEach((value, i) => compare(states.A[i], value));
  }
  const kept = { ...app.state.values };
  const domain = DATA.excitations[app.state.excitation];
  const range = app.ranges[domain.name];
  const times = [];
  for (let k = 0; k < 120; k++) {
    app.state.values.F_0 = valueOf(range, 1000 * (0.3 + 0.6 * Math.abs(Math.sin(k))), domain) * measure(app.state, "F_0").size;
    app.dirty = true;
    const began = performance.now();
    step(16);
    document.body.getBoundingClientRect();
    times.push(performance.now() - began);
    if (k % 20 === 19) await new Promise((resolve) => setTimeout(resolve));
  }
  app.state.values = kept;
  changed();
  times.sort((a, b) => a - b);
  const [median, most] = [times[60], times[114]];
  const text = `${same} of ${compared} numbers equal those of the compiled Python package to the last digit${same < compared ? ` (worst: ${short(worst, 2)} units in the last place)` : ""}. Drawing all plots takes ${short(median, 3)} ms (median), ${short(most, 3)} ms (95th percentile).`;
  return { same, compared, worst, median, most, text };
}

/** What tests and the console reach. */
globalThis.explorer = { app, ask, dimensionless, errorsOf, fromAddress, inCSV, inPython, numbersOf, open, randomOf, selfCheck, step, toAddress };

/* ==== Begin ======================================================================================================== */

async function begin() {
  const module = await compileSolvers($("wasm").textContent);
  app.solvers = await Solvers.of(module);
  app.plots = {
    response: new Plot($("response"), ["regions", "beside", "curve", "point"]),
    force: new Plot($("force"), ["beside", "curve", "point"]),
    transmissibility: new Plot($("transmissibility"), ["beside", "curve", "point"]),
  };
  app.ranges = {};
  $("move").checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  app.map = new DesignMap($("map"), module, (values) => {
    for (const [name, value] of Object.entries(values)) {
      const { size, shown } = measure(app.state, name);
      const tidy = Number((value * size * shown).toPrecision(4)) / shown;
      app.state.values[name] = tidy;
    }
    changed();
  });
  bindControls();
  $("version").textContent = `slowflow ${DATA.version}, sources ${DATA.digest}`;
  open(fromAddress(location.hash) || fromPreset(DATA.mount));
  step(0);
  document.body.dataset.ready = "yes";
  requestAnimationFrame(tick);
}

begin().catch((error) => {
  $("remarks").innerHTML = "<li>This browser does not run the solvers: it needs WebAssembly and DecompressionStream, as Chrome 80, Firefox 113 and Safari 16.4 have.</li>";
  console.error(error);
});
