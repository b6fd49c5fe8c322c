/* Paints a design map. Takes a request; returns cells, coarse ones first. A newer request ends an older one. */
let solvers = null;
let latest = 0;

/** F_SN or F_cr of one design; NaN where there is none. */
function critical(request, x, y) {
  const numbers = request.numbers.slice();
  numbers[request.x] = x;
  numbers[request.y] = y;
  if (solvers.choose(request.mechanism, numbers, request.excitation) === null) return NaN;
  const found = request.quantity === "F_SN" ? solvers.onset() : solvers.detachment();
  return found.status === 0 ? found[request.quantity] : NaN;
}

async function paint(request) {
  const { xs, ys, id } = request;
  const n = xs.length;
  const done = new Uint8Array(n * n);
  for (let size = 16; size >= 1; size /= 2) {
    let cells = [];
    let began = performance.now();
    for (let j = 0; j < n; j += size)
      for (let i = 0; i < n; i += size) {
        if (done[j * n + i]) continue;
        done[j * n + i] = 1;
        cells.push(i, j, critical(request, xs[i], ys[j]));
        if (performance.now() - began > 12) {
          postMessage({ id, size, cells, whole: false });
          cells = [];
          await new Promise((resolve) => setTimeout(resolve));
          if (id !== latest) return;
          began = performance.now();
        }
      }
    postMessage({ id, size, cells, whole: size === 1 });
  }
}

onmessage = async (event) => {
  if (event.data.module) {
    solvers = await Solvers.of(event.data.module);
    postMessage({ ready: true });
  } else {
    latest = event.data.id;
    paint(event.data);
  }
};
