/* Numbers with and without dimensions. Takes what a user gives; returns numbers for the solvers, and back. */

const DATA = JSON.parse(document.getElementById("data").textContent);
const GREEK = { lam: "λ", mu: "μ", zeta: "ζ", Omega: "Ω", alpha: "α", beta: "β", gamma: "γ", delta: "δ", Delta: "Δ", kappa: "κ", rho: "ρ", ell: "ℓ", pi: "π", omega: "ω" };

/** A name as it is written in a text. */
function plainSymbol(name) {
  return name.replace(/[A-Za-z]+/g, (word) => GREEK[word] || word);
}

/** A name as HTML, with what follows "_" below the line. */
function symbol(name) {
  const [head, ...below] = plainSymbol(name).split("_");
  return `<i>${head}</i>` + (below.length ? `<sub>${below.join(" ")}</sub>` : "");
}

/** Python's words as HTML. */
const inHTML = (text) => plainSymbol(text).replace(/(\p{L})_(\w+)/gu, "<i>$1</i><sub>$2</sub>").replaceAll("^2", "²");

/** The same as a sentence; a letter that it begins with stays as it is. */
const sentence = (text) => inHTML(text).replace(/^[a-z]{2}/, (start) => start[0].toUpperCase() + start[1]);

/** What a number is, in few words: without remarks, as lists have no room for these. */
function words(doc) {
  return plainSymbol(doc.split(/;|, <| whose /)[0]);
}

/** A text of a drawing, with what follows "_" below the line. */
function lowered(text) {
  return text.replace(/_(\w+)(.*)$/, '<tspan class="below" dy="3">$1</tspan><tspan dy="-3">$2</tspan>');
}

function power(base, exponent) {
  const whole = Math.abs(exponent) === 0.5 ? Math.sqrt(base) : base ** Math.abs(exponent);
  return exponent < 0 ? 1 / whole : whole;
}

/** What a number with this scale is measured in, in SI units (4). */
function sizeOf(scale, base) {
  const [k_v, L, m] = scale.powers;
  return scale.factor * (power(base.k_v, k_v) * power(base.L, L) * power(base.m, m));
}

/** Units by the powers of k_v, L and m: as they are shown, and how many of them make the SI unit. */
const UNITS = { "1,0,0": ["N/m", 1], "0,1,0": ["mm", 1000], "1,1,0": ["N", 1], "0,1,1": ["kg mm", 1000], "1,1,-1": ["m/s²", 1] };
const BASE = [
  { name: "m", doc: "mass that moves", unit: "kg", shown: 1 },
  { name: "k_v", doc: "stiffness of the vertical spring", unit: "N/m", shown: 1 },
  { name: "L", doc: "length of the push-rod", unit: "mm", shown: 1000 },
];

/** Whether a base's displacement or an unbalance excites it: with F_0 Ω². */
const byInertia = ({ excitation }) => DATA.excitations[excitation].solved_as !== "force";

/** The scale of each number of a state, by name; F_0 is the amplitude of whatever excites, "force" a force. */
function scalesOf(state) {
  const { design, scales } = DATA.mechanisms[state.mechanism];
  const own = Object.fromEntries(scales.map((scale, i) => [design[i].name, scale]));
  const { mu, F_0, Omega, u } = DATA.scales;
  return { ...own, mu, F_0: DATA.excitations[state.excitation].scale, force: F_0, Omega, A: u };
}

/** What a number is measured in: SI's size of it, the unit that is shown, and how many of these make SI's. */
function measure(state, name) {
  const scale = state.si && scalesOf(state)[name];
  if (!scale || scale.powers.every((one) => one === 0)) return { size: 1, unit: "", shown: 1 };
  const size = sizeOf(scale, state.base);
  if (name === "Omega") return { size: size / (2 * Math.PI), unit: "Hz", shown: 1 };
  const [unit, shown] = UNITS[scale.powers.join()];
  return { size, unit, shown };
}

/** All numbers without dimensions, by name. */
function dimensionless(state) {
  const found = {};
  for (const name of Object.keys(state.values)) found[name] = state.values[name] / measure(state, name).size;
  return found;
}

/** Numbers of the design, then mu and zeta, as the solvers take them. */
function numbersOf(state, values = dimensionless(state)) {
  return [...DATA.mechanisms[state.mechanism].design, ...DATA.damping].map((one) => values[one.name]);
}

/** The same design in the other units. */
function convert(state, si) {
  const plain = dimensionless(state);
  const density = densityMeasure(state);
  state.si = si;
  state.psd = convertDensity(state.psd, density, densityMeasure(state));
  for (const name of Object.keys(plain)) state.values[name] = plain[name] * measure(state, name).size;
}

/** A number in few letters; `digits` that count. */
function short(value, digits = 4) {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e6)) return value.toExponential(digits - 1).replace("-", "−");
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** A dimensionless number in the units that are shown. */
function told(state, name, value, digits) {
  const { size, unit, shown } = measure(state, name);
  return short(value * size * shown, digits) + (unit && ` ${unit}`);
}
