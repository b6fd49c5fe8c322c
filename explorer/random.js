/* Random vibration of the base. Takes points of a spectral density; returns what the solvers read for it. */

/** Rows of points as they are typed, "f G; f G", or the density of white noise alone; null for what is none. */
function readDensity(text, si) {
  const rows = text.split(/[;\n]/).filter((row) => row.trim()).map((row) => row.trim().split(/[\s,]+/).map(Number));
  if (!rows.flat().every((value) => value > 0 && Number.isFinite(value))) return null;
  if (rows.length === 1) return rows[0].length === 1 && !si ? rows : null;
  const rise = rows.every(([f], i) => i === 0 || f >= rows[i - 1][0]) && rows[rows.length - 1][0] > rows[0][0];
  return rows.every((row) => row.length === 2) && rise && rows.length <= DATA.density.most ? rows : null;
}

const writeDensity = (rows) => (rows || []).map((row) => row.join(" ")).join("; ");

/** What frequency and density of points are measured in: in SI units Hz and g²/Hz of the base's acceleration. */
function densityMeasure(state) {
  if (!state.si) return { Omega: 1, G: 1 };
  const Omega = measure(state, "Omega").size;
  const a = sizeOf(DATA.excitations.acceleration.scale, state.base) / DATA.density.g;
  return { Omega, G: a ** 2 / Omega };
}

/** The same points in the other units; white noise has none in SI units. */
function convertDensity(rows, from, to) {
  if (!rows || rows[0].length === 1) return undefined;
  return rows.map(([f, G]) => [(f / from.Omega) * to.Omega, (G / from.G) * to.G]);
}

/** The excitation as the solvers take it: the power of white noise, or points of frequency and density. */
function excitationOf(state) {
  if (state.psd[0].length === 1) return { power: (Math.PI * state.psd[0][0]) / 2, points: [] };
  const { Omega, G } = densityMeasure(state);
  return { power: 0, points: state.psd.map(([f, density]) => [f / Omega, density / G]) };
}

/** Root mean squares under the density of a state: rows by rising u, or a word where there are none. */
function randomOf(solvers, state, plain) {
  if (!DATA.mechanisms[state.mechanism].odd) return { n: 0, word: "for odd forces only" };
  if (plain.mu === 0 && plain.zeta === 0) return { n: 0, word: "unbounded without damping" };
  const words = { 0: "there is no equivalent linear oscillator", "-1": "not resolved", "-2": "friction holds the mass nearly all of the time" };
  const found = solvers.random(excitationOf(state));
  return found.n > 0 ? found : { n: 0, word: words[found.n] };
}
