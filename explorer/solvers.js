"use strict";
/* The compiled solvers. Takes numbers without dimensions; returns plain objects of arrays. Page and worker share this. */

/** WebAssembly from base64 of what zlib packed. */
async function compileSolvers(text) {
  const packed = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

class Solvers {
  static async of(module) {
    const instance = await WebAssembly.instantiate(module, {});
    instance.exports._initialize();
    return new Solvers(instance.exports);
  }

  constructor(native) {
    const memory = native.memory.buffer;
    const most = native.capacity();
    this.native = native;
    this.input = new Float64Array(memory, native.input(), 18);
    this.density = new Float64Array(memory, native.density(), 2 * native.room_of_density());
    this.columns = [0, 1, 2, 3, 4].map((i) => new Float64Array(memory, native.column(i), most));
    this.flags = [0, 1, 2].map((i) => new Uint8Array(memory, native.flag(i), most));
    this.branches = new BigInt64Array(memory, native.branches(), most);
    const letters = new Uint8Array(memory);
    this.names = Array.from({ length: native.known_mechanisms() }, (_, i) => {
      const start = native.name_of(i);
      return new TextDecoder().decode(letters.slice(start, letters.indexOf(0, start)));
    });
  }

  column(i, n) {
    return this.columns[i].slice(0, n);
  }

  flag(i, n) {
    return this.flags[i].slice(0, n);
  }

  /** The oscillator that is asked from now on; its breakpoints, or null where a number is outside its domain. */
  choose(name, numbers, excitation) {
    this.mechanism = this.names.indexOf(name);
    this.input.set(numbers);
    const n = this.native.choose(this.mechanism, ["base", "unbalance"].includes(excitation) ? 1 : 0);
    return n < 0 ? null : Array.from(this.column(0, n));
  }

  /** The u at which the force passes from one piece to the next. */
  places() {
    return Array.from(this.column(0, this.native.places(this.mechanism)));
  }

  sticking() {
    return this.native.sticking();
  }

  reach() {
    return this.native.reach();
  }

  stiffnessAtRest() {
    return this.native.stiffness_at_rest();
  }

  respond(F_0, low, high, samples) {
    return this.points(this.native.respond(F_0, low, high, samples), true);
  }

  /** Every steady state at Omega, of the curve that was asked for last. */
  states(F_0, Omega) {
    return this.points(this.native.states(F_0, Omega), false);
  }

  points(n, onCurve) {
    const status = Math.max(0, -n);
    n = Math.max(0, n);
    return {
      status,
      n,
      Omega: this.column(0, n),
      A: this.column(1, n),
      phi: this.column(2, n),
      T: this.column(3, n),
      B: this.column(4, n),
      stable: this.flag(0, n),
      centred: this.flag(1, n),
      beyond: this.flag(2, n),
      branch: onCurve ? Array.from(this.branches.slice(0, n), Number) : null,
      undecided: n > 0 && this.native.is_undecided() !== 0,
    };
  }

  folds(F_0) {
    const found = this.native.folds(F_0);
    const n = Math.max(0, found);
    return {
      status: Math.max(0, -found),
      n,
      Omega: this.column(0, n),
      A: this.column(1, n),
      up: this.flag(0, n),
      corner: this.flag(1, n),
      undecided: n > 0 && this.native.is_undecided() !== 0,
    };
  }

  onset() {
    const status = this.native.onset();
    const [F_SN, Omega, A, kind, rest] = this.column(0, 5);
    return { status, F_SN, Omega, A, kind, rest };
  }

  detachment() {
    const status = this.native.detachment();
    const [F_cr, Omega, u_cr] = this.column(0, 3);
    return { status, F_cr, Omega, u_cr };
  }

  peak(F_0) {
    const status = this.native.peak(F_0);
    const [A, Omega, beyond] = this.column(0, 3);
    return { status, A, Omega, beyond: beyond !== 0 };
  }

  locus(A_max, samples) {
    const n = Math.max(0, this.native.locus(A_max, samples));
    return { n, Omega: this.column(0, n), A: this.column(1, n), branch: Array.from(this.branches.slice(0, n), Number) };
  }

  /** Intervals of Omega in which a state would be unstable, row by row of amplitudes. */
  unstable(A_max, high, rows) {
    const n = this.native.unstable(A_max, high, rows);
    return { n, A: this.column(0, n), low: this.column(1, n), high: this.column(2, n), step: A_max / rows };
  }

  backbone(A_max, n) {
    this.native.backbone(A_max, n);
    return { n, A: this.column(0, n), Omega: this.column(1, n) };
  }

  envelope(F_0, high, n) {
    this.native.envelope(F_0, high, n);
    return { n, Omega: this.column(0, n), A: this.column(1, n) };
  }

  /** Root mean squares of stationary motions, see `excitationOf`; n is -1 where they are not resolved, -2 where friction
   * holds the mass. */
  random({ power, points }) {
    this.density.set(points.flat());
    const n = this.native.random(power, points.length);
    return { n, u: this.column(0, Math.max(0, n)), v: this.column(1, Math.max(0, n)), k: this.column(2, Math.max(0, n)), friction: this.column(3, Math.max(0, n)) };
  }

  force(u_max, n) {
    this.native.force(this.mechanism, u_max, n);
    return { n, u: this.column(0, n), f: this.column(1, n) };
  }
}
