// The data of the page: one JSON with all that is small, and chunks of packed numbers.
import { bytesOfBase64, inflate, joinPlanes } from "./decode.js";

export function runOfPage() {
  return JSON.parse(document.getElementById("footfall-run").textContent);
}

const kWait = 5;  // before it is looked whether more of the page has come [ms]

// The element, once the browser has read all of it: something follows it, or the page is at its end.
async function wholeElement(id) {
  for (;;) {
    const ended = document.readyState !== "loading", element = document.getElementById(id);
    if (ended || element?.nextElementSibling) return element;
    await new Promise((resolve) => setTimeout(resolve, kWait));
  }
}

// Of a run in progress: chunks that came as events, by name, already unpacked.
export const given = new Map();

// The chunk is taken out of the page: it is needed once.
export async function takeChunk(name) {
  if (given.has(name)) return given.get(name);
  const element = await wholeElement(`footfall-${name}`);
  if (!element) throw new Error(`the page lacks its part "${name}"; was the file cut off?`);
  const text = element.textContent;
  element.remove();
  return inflate(bytesOfBase64(text));
}

export async function takeNumbers(name, Kind) {
  return joinPlanes(await takeChunk(name), Kind);
}

// The history as plain columns: time is exact, the others have single precision.
// prefix: of the chunk, for a second run.
export async function takeHistory(run, prefix = "") {
  const { names, units, rows } = run.history;
  const values = await takeNumbers(`${prefix}history`, Float32Array);
  const columns = new Map();
  names.forEach((name, i) => columns.set(name, { name, unit: units[i], values: values.subarray(i * rows, (i + 1) * rows) }));
  return { time: Float64Array.from(run.history.time), columns };
}

// The second run of a page: its history, and the names of both; null without one.
export async function secondOf(run) {
  if (!run.other) return null;
  return { history: await takeHistory(run.other, "other-"), names: [run.name, run.other.name] };
}

// The last index k with times[k] <= t, at least 0.
export function indexBefore(times, t) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

// Value of a column at time t, straight between its rows.
export function valueAt(history, values, t) {
  const k = indexBefore(history.time, t);
  if (k + 1 >= history.time.length || t <= history.time[k]) return values[k];
  const span = history.time[k + 1] - history.time[k];
  const share = span > 0 ? (t - history.time[k]) / span : 1;
  return values[k] + share * (values[k + 1] - values[k]);
}
