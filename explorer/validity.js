/* What is to be said beside an answer, and how far averaging is off. Takes states; returns words and measured errors.

The errors are those that `slowflow.measured` has, looked up as it looks them up. */

function binOf(edges, value) {
  let i = edges.length - 1;
  while (i > 0 && !(value >= edges[i])) i--;
  return i;
}

function interpolate(x, xs, ys) {
  if (x <= xs[0]) return ys[0];
  for (let i = 1; i < xs.length; i++)
    if (x <= xs[i]) return ys[i - 1] + ((ys[i] - ys[i - 1]) / (xs[i] - xs[i - 1])) * (x - xs[i - 1]);
  return ys[ys.length - 1];
}

/** Relative errors of one state's amplitude: of half and of 95 in 100 measured ones, and what truncation adds; or null. */
function errorsOf(mechanism, excitation, breaks, mu, F_0, Omega, A) {
  const known = DATA.measured;
  if (!known.MECHANISMS.includes(mechanism) || byInertia({ excitation })) return null;
  const rest = mu > 0 ? mu / (A * Omega * Omega) : 0;
  const row = binOf(known.RATIOS, mu / F_0);
  const column = binOf(known.STOPPING, rest);
  let truncation = 0;
  if (DATA.mechanisms[mechanism].truncated && breaks.length) {
    const sizes = known.TRUNCATION[0].map((_, k) => interpolate(breaks[0], known.U_CRS, known.TRUNCATION.map((of) => of[k])));
    truncation = interpolate(A / breaks[0], [0, ...known.LEVELS], [0, ...sizes]);
  }
  return { typical: known.TYPICAL[row][column], error: known.ERROR[row][column], truncation, rest };
}

/** Python's words with the numbers put in, in their order or by name. */
function fill(text, ...values) {
  let next = 0;
  return text.replace(/\{(\w*)[^}]*\}/g, (_, name) => (name ? values[0][name] : values[next++]));
}

const percent = (share) => `${Math.round(100 * share)}%`;

/** Why no amplitude above the reach makes sense. */
const beyondReach = ({ state, reach }) => fill(wordsIn(state).BEYOND_REACH, { reach: told(state, "A", reach), reason: DATA.mechanisms[state.mechanism].reach_reason });

/** Remarks on a response, a list of sentences. */
function remarksOf(answer) {
  const { state, plain, curve, folds } = answer;
  const about = DATA.mechanisms[state.mechanism];
  const words = wordsIn(state);
  const said = [];
  if (curve.status === DATA.status.STICKS) return [fill(words.STICKS, told(state, "F_0", plain.F_0), told(state, "force", answer.friction))];
  if (curve.status !== 0) return ["The response is not resolved here: numbers are too large, or branches coincide within rounding."];
  const highest = curve.A.reduce((most, A) => Math.max(most, A), 0);
  if (plain.zeta === 0) said.push("Unbounded without viscous damping: the curve is cut.");
  if (highest > answer.reach) said.push(beyondReach(answer));
  if (answer.stiffnessAtRest < 0) said.push(words.NEGATIVE_STIFFNESS);
  if (curve.centred.includes(0)) said.push(words.LEAVES_CENTRE);
  if (curve.beyond.includes(1)) said.push(words.BEYOND_WELL);
  if (curve.undecided || folds.undecided) said.push(words.UNDECIDED);
  if (about.truncated && folds.corner.includes(1)) said.push(words.OF_TRUNCATION);
  if (byInertia(state)) {
    if (plain.mu > 0) said.push(fill(words.STICKS_BELOW, told(state, "Omega", answer.sticksUpTo), told(state, "force", answer.friction)));
    if (curve.Omega.some((Omega) => plain.mu > DATA.measured.NEAR * plain.F_0 * Omega * Omega)) said.push(words.NEAR_STICKING_BELOW);
    return said;
  }
  const ratio = plain.mu / plain.F_0;
  if (ratio > DATA.measured.NEAR) {
    const known = DATA.measured.MECHANISMS.includes(state.mechanism);
    const size = DATA.measured.BY_RATIO[binOf(DATA.measured.RATIOS, ratio)];
    said.push(fill(words.NEAR_STICKING, short(ratio, 3)) + (known ? fill(words.OFF_BY, percent(size)) : words.OFF_UNKNOWN));
  }
  return said;
}

/** The error of one state, in words. */
function errorInWords(errors) {
  if (errors === null) return "The error of averaging was measured for isolators under a force only.";
  const parts = [`Averaging is typically off by ${short(100 * errors.typical, 2)} % here, by less than ${short(100 * errors.error, 2)} % in 95 % of the measured cases.`];
  if (errors.rest >= DATA.measured.STOPS_FROM) parts.push("The mass stops within the cycle, or nearly so.");
  if (errors.truncation >= DATA.worth.truncation) parts.push(`The truncated force (6) adds ${short(100 * errors.truncation, 2)} %.`);
  return parts.join(" ");
}
