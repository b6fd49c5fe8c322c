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

/** The excitation as the solvers take it: the power of white noise, or a table as `random_vibration.excitation` makes it;
 * null where friction, `dry` at a velocity of 1, holds the mass. */
function excitationOf(state, plain, dry) {
  if (state.psd[0].length === 1) return { power: (Math.PI * state.psd[0][0]) / 2, rows: [], bands: 0 };
  const { Omega, G } = densityMeasure(state);
  const { nodes, weights, widest, margin } = DATA.density;
  const points = state.psd.map(([f, density]) => [Math.log(f / Omega), Math.log(density / G)]);
  const bands = [];
  for (let i = 0; i + 1 < points.length; i++) {
    const [[a, y], [b, end]] = [points[i], points[i + 1]];
    const parts = Math.ceil((b - a) / widest);
    for (let k = 0; k < parts; k++) bands.push([a + ((b - a) * k) / parts, k + 1 < parts ? a + ((b - a) * (k + 1)) / parts : b, a, y, (end - y) / (b - a)]);
  }
  let [whole, over] = [0, 0];
  for (const [low, high, x, y, slope] of bands)
    for (const sign of [-1, 1])
      nodes.forEach((node, j) => {
        const at = 0.5 * (low + high) + 0.5 * sign * node * (high - low);
        const term = 0.5 * (high - low) * weights[j] * Math.exp(y + slope * (at - x));
        whole += term * Math.exp(at);
        over += term;
      });
  if (!(dry < Math.sqrt(whole))) return null;
  const strength = Math.PI * Math.exp(Math.max(...points.map(([, y]) => y)));
  const least = Math.max(2 * plain.zeta, dry ** 2 / strength);
  const most = (strength + 0.5 * over) / least;
  return { power: 0, rows: [most, least / margin, plain.mu, plain.zeta, 0, ...nodes, ...weights, ...bands.flat()], bands: bands.length };
}

/** Root mean squares under the density of a state: rows by rising u, or a word where there are none. */
function randomOf(solvers, state, plain) {
  if (!DATA.mechanisms[state.mechanism].odd) return { n: 0, word: "of forces that are odd only" };
  if (plain.mu === 0 && plain.zeta === 0) return { n: 0, word: "without damping unbounded" };
  const excitation = excitationOf(state, plain, solvers.dry());
  if (excitation === null) return { n: 0, word: "friction holds the mass nearly all of the time" };
  const found = solvers.random(excitation);
  return found.n > 0 ? found : { n: 0, word: found.n < 0 ? "not resolved" : "no linear oscillator is equivalent" };
}
