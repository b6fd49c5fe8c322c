/* The design map. Takes a design and two of its parameters; returns a picture that a worker paints and that can be
clicked. */

const CELLS = 128;
/* cividis, from which others are interpolated: it reads the same with any colour vision */
const COLOURS = [[0, 34, 78], [37, 58, 109], [76, 85, 107], [106, 111, 114], [138, 134, 120], [172, 159, 116], [209, 187, 101], [254, 232, 56]];

function colourAt(share) {
  const at = Math.min(0.999999, Math.max(0, share || 0)) * (COLOURS.length - 1);
  const k = Math.floor(at);
  return COLOURS[k].map((part, i) => Math.round(part + (COLOURS[k + 1][i] - part) * (at - k)));
}

class DesignMap {
  /** `onPick` gets the numbers of the design that was clicked, by name. */
  constructor(element, module, onPick) {
    this.element = element;
    this.canvas = document.createElement("canvas");
    this.canvas.width = this.canvas.height = CELLS;
    this.plot = new Plot(element, ["point"]);
    element.prepend(this.canvas);
    this.values = new Float64Array(CELLS * CELLS);
    this.id = 0;
    this.ready = false;
    this.scale = document.getElementById("map-scale");
    const source = document.getElementById("solvers").textContent + document.getElementById("worker").textContent;
    this.worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    this.worker.onmessage = (event) => this.receive(event.data);
    this.worker.postMessage({ module });
    element.addEventListener("click", (event) => {
      if (!this.request) return;
      const at = this.plot.where(event);
      onPick({ [this.names.x]: at.x, [this.names.y]: at.y });
    });
    element.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!step || !this.request) return;
      event.preventDefault();
      const { x, y } = this.ends;
      const next = (at, ends, by) => Math.min(ends[1], Math.max(ends[0] + (ends[1] - ends[0]) / CELLS, at + ((ends[1] - ends[0]) / CELLS) * by));
      onPick({ [this.names.x]: next(this.at.x, x, step[0]), [this.names.y]: next(this.at.y, y, step[1]) });
    });
  }

  /** Asks for a map unless it is the one that is shown. */
  show(state, names, ends, quantity) {
    const plain = dimensionless(state);
    const order = [...DATA.mechanisms[state.mechanism].design, ...DATA.damping].map((one) => one.name);
    const numbers = numbersOf(state, plain);
    const [x, y] = [order.indexOf(names.x), order.indexOf(names.y)];
    const rest = numbers.filter((_, i) => i !== x && i !== y);
    const { mechanism, excitation } = state;
    const wanted = JSON.stringify([mechanism, excitation, names, ends, quantity, rest]);
    Object.assign(this, { names, ends, quantity, at: { x: plain[names.x], y: plain[names.y] }, state });
    this.axes();
    if (!this.ready || wanted === this.wanted) return;
    this.wanted = wanted;
    const centres = ([low, high]) => Float64Array.from({ length: CELLS }, (_, i) => low + ((high - low) * (i + 0.5)) / CELLS);
    this.request = { id: ++this.id, mechanism, excitation, numbers, x, y, xs: centres(ends.x), ys: centres(ends.y), quantity };
    this.values.fill(-1);
    this.element.dataset.whole = "no";
    this.worker.postMessage(this.request);
  }

  receive(message) {
    if (message.ready) {
      this.ready = true;
      if (this.state) this.show(this.state, this.names, this.ends, this.quantity);
      return;
    }
    if (message.id !== this.id) return;
    const { size, cells } = message;
    for (let k = 0; k < cells.length; k += 3)
      for (let j = cells[k + 1]; j < Math.min(CELLS, cells[k + 1] + size); j++)
        this.values.fill(cells[k + 2], j * CELLS + cells[k], j * CELLS + Math.min(CELLS, cells[k] + size));
    this.element.dataset.whole = message.whole ? "yes" : "no";
    this.paint();
  }

  paint() {
    const known = this.values.filter((value) => value >= 0 && value < Infinity);
    const [low, high] = [known.reduce((a, b) => Math.min(a, b), Infinity), known.reduce((a, b) => Math.max(a, b), 0)];
    const context = this.canvas.getContext("2d");
    const picture = context.createImageData(CELLS, CELLS);
    for (let j = 0; j < CELLS; j++)
      for (let i = 0; i < CELLS; i++) {
        const value = this.values[(CELLS - 1 - j) * CELLS + i];
        const rgb = !Number.isFinite(value) ? [150, 150, 150] : colourAt((value - low) / (high - low || 1));
        picture.data.set([...rgb, value === -1 ? 0 : 255], 4 * (j * CELLS + i));
      }
    context.putImageData(picture, 0, 0);
    const stops = COLOURS.map((rgb, k) => `rgb(${rgb}) ${(100 * k) / (COLOURS.length - 1)}%`).join(",");
    const ends = Number.isFinite(low) ? [low, high].map((value) => told(this.state, "F_0", value, 3)) : ["–", "–"];
    this.scale.innerHTML = `<span>${ends[0]}</span><i style="background:linear-gradient(90deg,${stops})"></i><span>${ends[1]}</span>`;
  }

  axes() {
    const { x, y } = this.names;
    const of = (name) => {
      const { size, unit, shown } = measure(this.state, name);
      return { scale: size * shown, label: unit ? `${nameIn(this.state, name)} / ${unit}` : nameIn(this.state, name) };
    };
    const [across, up] = [of(x), of(y)];
    this.plot.limits(this.ends.x, this.ends.y, { x: across.scale, y: up.scale }, { x: across.label, y: up.label });
    const { left, top, wide, high } = this.plot.box;
    Object.assign(this.canvas.style, { left: `${left}px`, top: `${top}px`, width: `${wide}px`, height: `${high}px` });
    const [px, py] = [this.plot.x(this.at.x).toFixed(1), this.plot.y(this.at.y).toFixed(1)];
    this.plot.set("point", `<path class="cross" d="M${px},${top}v${high}M${left},${py}h${wide}"/><circle class="now" cx="${px}" cy="${py}" r="6"/>`);
  }
}
