// What stands in the page: one JSON with all that is small, and chunks of packed numbers.
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

// The chunk is taken out of the page: it is needed once.
export async function takeChunk(name) {
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
export async function takeHistory(run) {
  const { names, units, rows } = run.history;
  const values = await takeNumbers("history", Float32Array);
  const columns = new Map();
  names.forEach((name, i) => columns.set(name, { name, unit: units[i], values: values.subarray(i * rows, (i + 1) * rows) }));
  return { time: Float64Array.from(run.history.time), columns };
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
