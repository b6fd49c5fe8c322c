/* The design and what is shown of it. Takes an address; returns a state, and back. */

const PHYSICAL = DATA.physical_names;

/** What a number is called in the units that are shown. */
function nameIn(state, name) {
  if (!state.si) return plainSymbol(name);
  const own = scalesOf(state)[name];
  return plainSymbol(DATA.names[name] || (own ? own.letter : name));
}

/** A critical amplitude of what excites: "F_SN", of a base in SI units "Y_SN". */
const criticalIn = (state, below) => `${state.si ? nameIn(state, "F_0") : "F"}_${below}`;

/** The package's words in the units that are shown, by name. */
const wordsIn = (state) => (state.si ? DATA.words.si[state.excitation] : DATA.words.plain);

/** The domain of each number, by name, in the order in which they are shown. */
function domains(state) {
  return [...DATA.mechanisms[state.mechanism].design, ...dampingOf(state), DATA.excitations[state.excitation]];
}

/** Damping has to be viscous too where F_0 Ω² excites. */
function dampingOf(state) {
  return DATA.damping.map((one) => (byInertia(state) && one.name === "zeta" ? { ...one, above: 0 } : one));
}

/** Whether a dimensionless number is allowed, as `slowflow.support.record.Parameter.holds`. */
function holds(domain, value) {
  return (
    Number.isFinite(value) &&
    !(value <= domain.above) &&
    !(value < domain.least) &&
    !(value >= domain.below) &&
    !(value > domain.most)
  );
}

function fromPreset(preset) {
  const si = Boolean(preset.base);
  const state = {
    mechanism: preset.mechanism,
    excitation: preset.excitation || "force",
    si,
    base: { ...(si ? preset.base : DATA.mount.base) },
    values: { ...preset.values },
    high: preset.shown || 2,
    Omega: 0,
    up: true,
  };
  state.Omega = 0.35 * state.high;
  return state;
}

/** The state as an address has it. Numbers are written so that they are read back as the same doubles. */
function toAddress(state) {
  const parts = { mechanism: state.mechanism, ...state.values, shown: state.high, at: state.Omega, level: state.level };
  if (state.excitation !== "force") parts.excitation = state.excitation;
  if (state.psd) parts.psd = writeDensity(state.psd);
  if (state.si) Object.assign(parts, { units: "si" }, state.base);
  return `#${new URLSearchParams(Object.entries(parts).filter(([, value]) => value !== undefined))}`;
}

/** Null where the address has no mechanism, another excitation, or a number that is not allowed: a force that is not odd is
 * asked under a force only, as in Python. */
function fromAddress(address) {
  const parts = new URLSearchParams(address.replace(/^#/, ""));
  const mechanism = parts.get("mechanism");
  if (!Object.hasOwn(DATA.mechanisms, mechanism || "")) return null;
  const number = (name, other) => (parts.has(name) ? Number(parts.get(name)) : other);
  const excitation = parts.get("excitation") || "force";
  if (!Object.hasOwn(DATA.excitations, excitation) || (byInertia({ excitation }) && !DATA.mechanisms[mechanism].odd)) return null;
  const state = fromPreset({ mechanism, excitation, values: {}, shown: number("shown", 2) });
  if (!(state.high > 0 && state.high < 1e6)) return null;
  state.si = parts.get("units") === "si" && DATA.mechanisms[mechanism].physical;
  if (state.si) for (const { name } of BASE) state.base[name] = number(name, NaN);
  for (const { name } of domains(state)) state.values[name] = number(name, NaN);
  if (state.si && !BASE.every(({ name }) => state.base[name] > 0 && Number.isFinite(state.base[name]))) return null;
  const plain = dimensionless(state);
  if (!domains(state).every((domain) => holds(domain, plain[domain.name]))) return null;
  state.Omega = Math.min(state.high, Math.max(1e-3 * state.high, number("at", 0.35 * state.high)));
  state.psd = parts.has("psd") ? readDensity(parts.get("psd"), state.si) : undefined;
  if (state.psd === null) return null;
  state.level = parts.has("level") ? number("level") : undefined;
  return state;
}

/** Lines of Python that give the same curve. */
function inPython(state) {
  const about = DATA.mechanisms[state.mechanism];
  const said = { ...about.words, ...(state.si && about.truncated ? { force: "truncated" } : {}), ...((state.si ? state.excitation !== "force" : byInertia(state)) ? { excitation: state.excitation } : {}) };
  const words = Object.entries(said).map(([name, value]) => `${name}="${value}"`);
  const names = [...about.design, ...DATA.damping].map((one) => one.name);
  const python = (value) => (Number.isInteger(value) && Math.abs(value) < 1e15 ? `${value}.0` : String(value));
  const given = (rename) => names.map((name) => `${rename[name] || name}=${name === "lam" && rename.lam && Number.isInteger(state.values[name]) ? state.values[name] : python(state.values[name])}`);
  const plain = dimensionless(state);
  const lines = [`from slowflow import ${about.constructor.split(".")[0]}`, ""];
  if (state.si) {
    const base = BASE.map(({ name }) => `${name}=${python(state.base[name])}`);
    lines.push(`mount = ${about.constructor}.physical(${[...base, ...given(PHYSICAL), ...words].join(", ")})`);
    const F = python(state.values.F_0);
    const top = python(state.high * measure(state, "Omega").size);
    lines.push(`print(mount.saddle_node_onset())`, `print(mount.detachment())`, `print(mount.saddle_nodes(${F}))`);
    lines.push(`curve = mount.frequency_response(${F}, f=(0.0, ${top}), samples=${SAMPLES})`);
  } else {
    lines.push(`oscillator = ${about.constructor}(${[...given({}), ...words].join(", ")})`);
    const F = `F_0=${python(plain.F_0)}`;
    lines.push(`print(oscillator.saddle_node_onset())`, `print(oscillator.detachment())`, `print(oscillator.saddle_nodes(${F}))`);
    lines.push(`curve = oscillator.frequency_response(${F}, Omega=(0.0, ${python(state.high)}), samples=${SAMPLES})`);
  }
  if (state.psd) {
    const [f, G] = [0, 1].map((k) => `[${state.psd.map((row) => python(row[k])).join(", ")}]`);
    const density = state.psd[0].length === 1 ? `S_0=${python(state.psd[0][0] / 2)}` : `psd=(${f}, ${G})`;
    lines.push(`print(${state.si ? "mount" : "oscillator"}.random(${density}))`);
  }
  return lines.join("\n") + "\n";
}

/** The curve as a table, in the units that are shown as SI's or without dimensions. */
function inCSV(answer) {
  const { state, curve } = answer;
  const [omega, length] = [measure(state, "Omega"), measure(state, "A")];
  const head = state.si ? "f/Hz,A/m" : "Omega,A";
  const { odd } = DATA.mechanisms[state.mechanism];
  const rows = [`${head},phi/rad,stable,transmissibility,branch${odd ? "" : ",B"}`];
  for (let i = 0; i < curve.n; i++)
    rows.push([curve.Omega[i] * omega.size, curve.A[i] * length.size, curve.phi[i], curve.stable[i], curve.T[i], curve.branch[i], ...(odd ? [] : [curve.B[i] * length.size])].join());
  return rows.join("\n") + "\n";
}
