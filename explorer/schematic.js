/* The mechanism as it moves. Takes a displacement and where pieces end; returns an SVG picture.

A mechanism with a push-rod is drawn to scale, L being 84 units; any other as a mass on a spring. */

function zigzag(x1, y1, x2, y2, turns = 7, width = 7) {
  const [dx, dy] = [x2 - x1, y2 - y1];
  const length = Math.hypot(dx, dy) || 1;
  const [nx, ny] = [-dy / length, dx / length];
  let d = `M${x1.toFixed(1)},${y1.toFixed(1)}`;
  for (let i = 0; i < turns; i++) {
    const s = (i + 0.5) / turns;
    const side = i % 2 ? width : -width;
    d += `L${(x1 + dx * s + nx * side).toFixed(1)},${(y1 + dy * s + ny * side).toFixed(1)}`;
  }
  return `${d}L${x2.toFixed(1)},${y2.toFixed(1)}`;
}

const CENTRE = { x: 170, y: 104 };

/** Ground, vertical spring, damper and mass. */
function frame(y) {
  const x = CENTRE.x;
  const ground = 216;
  const cup = Math.min(ground - 22, y + 70);
  return (
    `<path class="ground" d="M${x - 60},${ground}h120"/>` +
    line("spring", zigzag(x - 22, y + 16, x - 22, ground, 9, 7)) +
    `<path class="spring" d="M${x + 22},${y + 16}V${cup}m-8,0h16M${x + 12},${cup - 14}V${cup + 12}h20V${cup - 14}M${x + 22},${cup + 12}V${ground}"/>` +
    `<rect class="mass" x="${x - 38}" y="${y - 16}" width="76" height="32" rx="4"/>`
  );
}

/** A rod at each side, and the spring that it may leave; u and delta_h in rod lengths. */
function rods(u, delta_h, breaks) {
  const L = 84;
  const y = CENTRE.y - u * L;
  const drawn = Math.sqrt(Math.max(0, 1 - u * u));
  const off = breaks.length > 0 && Math.abs(u) > breaks[0];
  const tip = off ? 1 - delta_h : drawn;
  let text = "";
  for (const side of [-1, 1]) {
    const at = (share) => CENTRE.x + side * L * share;
    text += `<path class="ground" d="M${CENTRE.x + side * 160},${CENTRE.y - 22}v44"/>`;
    text += `<path class="guide" d="M${CENTRE.x + side * 160},${CENTRE.y}H${at(0.55)}"/>`;
    text += `<path class="spring${off ? " off" : ""}" d="${zigzag(at(tip), CENTRE.y, CENTRE.x + side * 160, CENTRE.y, 7, 8)}M${at(tip).toFixed(1)},${CENTRE.y - 12}v24"/>`;
    text += `<path class="rod" d="M${CENTRE.x},${y.toFixed(1)}L${at(drawn).toFixed(1)},${CENTRE.y}"/>`;
    text += `<circle class="pin" cx="${at(drawn).toFixed(1)}" cy="${CENTRE.y}" r="4.5"/>`;
  }
  return { text, y };
}

/** The picture at displacement u; force is its share of F_0 just now. */
function drawSchematic(svg, answer, now, u, force) {
  const { state, plain, breaks, places } = answer;
  let text;
  let y;
  if (DATA.mechanisms[state.mechanism].rod) {
    ({ text, y } = rods(Math.max(-1, Math.min(1, u)), plain.delta_h, breaks));
  } else {
    const scale = 56 / Math.max(now ? now.A + Math.abs(now.B) : 0, ...places.map(Math.abs), 1e-12);
    y = CENTRE.y - u * scale;
    text = places
      .map((at) => `<path class="guide" d="M${CENTRE.x - 90},${CENTRE.y - at * scale}h180"/>`)
      .join("");
  }
  const arrow = 34 * force;
  const pull = `<path class="push" d="M${CENTRE.x},${y.toFixed(1)}v${(-arrow).toFixed(1)}l-4,${Math.sign(arrow) * 6}h8l-4,${-Math.sign(arrow) * 6}"/>`;
  svg.innerHTML = `<g class="schematic">${frame(y)}${text}${pull}<circle class="pin" cx="${CENTRE.x}" cy="${y.toFixed(1)}" r="4.5"/></g>`;
}
