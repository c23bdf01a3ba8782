// view_read_back.mjs RUN: the data of RUN/view.html, unpacked by the viewer's own code, equal the run's files: places and speeds of
// the grains, points of the bodies, columns of the history.
import { readFileSync, readdirSync } from "node:fs";
import { SeriesDecoder, bytesOfBase64, inflate, joinPlanes } from "../../mbd_solver/app/web/src/decode.js";

const folder = process.argv[2];
const page = readFileSync(`${folder}/view.html`, "utf8");
const text = (name) => new RegExp(`id="footfall-${name}">([^<]*)</script>`).exec(page)[1];
const run = JSON.parse(text("run"));
const chunk = (name) => inflate(bytesOfBase64(text(name)));
let compared = 0;
function near(found, expected, tolerance, what) {
  ++compared;
  if (!(Math.abs(found - expected) <= tolerance)) throw new Error(`${what}: the page says ${found}, the run ${expected}`);
}
const half = (box, axis) => (0.51 * box.size[axis]) / 65534 + 1e-6;  // half a step, and the single precision on the way

// Dumps: ITEM: ATOMS id x y z vx vy vz radius, then a row per grain.
function readDump(file) {
  const rows = readFileSync(file, "utf8").split("ITEM: ATOMS id x y z vx vy vz radius")[1].trim().split("\n").map((l) => l.trim().split(/\s+/).map(Number));
  return rows.filter((row) => row.length === 8).sort((p, q) => p[0] - q[0]);
}
const step = (file) => Number(/_(\d+)\.txt$/.exec(file)[1]);
const dumps = readdirSync(folder).filter((f) => /^grains_\d+\.txt$/.test(f)).sort((p, q) => step(p) - step(q));
const { grains, bodies } = run;
if (dumps.length !== grains.times.length) throw new Error(`${dumps.length} dumps, ${grains.times.length} frames`);
let decoder = new SeriesDecoder(4 * grains.count);
for (let k = 0; k < dumps.length; ++k) {
  const values = decoder.next(await chunk(`grains-${k}`));
  readDump(`${folder}/${dumps[k]}`).forEach(([id, ...numbers], place) => {
    for (let axis = 0; axis < 3; ++axis)
      near(grains.box.low[axis] + (grains.box.size[axis] * values[axis * grains.count + place]) / 65534, numbers[axis], half(grains.box, axis), `${dumps[k]}, grain ${id}`);
    const share = Math.hypot(...numbers.slice(3, 6)) / grains.numbers[0].largest;
    near(values[3 * grains.count + place], 255 * Math.sqrt(share), 0.51, `${dumps[k]}, speed of grain ${id}`);
  });
}

const files = [...readFileSync(`${folder}/bodies.pvd`, "utf8").matchAll(/timestep="([^"]*)" file="([^"]*)"/g)];
decoder = new SeriesDecoder(3 * bodies.points + (bodies.stress > 0 ? bodies.cells : 0));
for (let k = 0; k < files.length; ++k) {
  near(bodies.times[k], Number(files[k][1]), 0, "time of a drawing");
  const values = decoder.next(await chunk(`bodies-${k}`));
  const points = /Name="Points"[^>]*>([^<]*)</.exec(readFileSync(`${folder}/${files[k][2]}`, "utf8"))[1].trim().split(/\s+/).map(Number);
  points.forEach((x, i) => near(bodies.box.low[i % 3] + (bodies.box.size[i % 3] * values[(i % 3) * bodies.points + Math.floor(i / 3)]) / 65534, x, half(bodies.box, i % 3), files[k][2]));
}

// Marks: four vectors each, in single precision.
const marks = joinPlanes(await chunk("marks"), Float32Array);
if (marks.length !== 12 * run.marks.list.length * files.length) throw new Error(`${marks.length} numbers of marks`);
files.forEach(([, , name], k) => {
  const vectors = /type="Float64" Name="marks"[^>]*>([^<]*)</.exec(readFileSync(`${folder}/${name}`, "utf8"))[1].trim().split(/\s+/).map(Number);
  vectors.forEach((x, i) => near(marks[k * vectors.length + i], x, 1e-7 * Math.abs(x) + 1e-38, `${name}, marks`));
});

const lines = readFileSync(`${folder}/history.csv`, "utf8").trim().split("\n").filter((l) => !l.startsWith("#"));
const names = lines[0].split(",");
const rows = lines.slice(1).map((l) => l.split(",").map(Number));
const columns = joinPlanes(await chunk("history"), Float32Array);
run.history.names.forEach((name, c) => {
  const from = names.indexOf(name);
  rows.forEach((row, r) => near(columns[c * run.history.rows + r], row[from], 1e-7 * Math.abs(row[from]) + 1e-44, `${name}, row ${r}`));
});
console.log(`${compared} numbers equal the run's`);
