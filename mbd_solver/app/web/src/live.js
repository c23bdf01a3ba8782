// A run in progress: events of its server (app/live) become frames of the page. What still fits into the boxes, scales and columns of the
// page is added to it; else the page is built anew, with room to spare.
import { SeriesDecoder, bytesOfBase64, inflate, joinPlanes } from "./decode.js";
import { given, takeNumbers } from "./page.js";

const kRoom = 0.3;           // of a box beyond what was seen, on each side
const kSpare = 0.25;         // of the grains that may still come
const kRows = 4200;          // of the history, for a run whose end is known
const kMostNumbers = 3e8;    // of all frames of grains; beyond that every second frame goes
const kSteps = 65534, kAbsent = 65535, kMostStress = 65535;
const kFirst = 400;          // what comes so soon after the first event is shown together with it [ms]
const kRested = 10, kLongest = 10000;  // times as long as it took to build the page anew, nothing is built anew; at most [ms]

const unpack = async (text) => inflate(bytesOfBase64(text));

function joined(boxes) {
  const low = [0, 1, 2].map((k) => Math.min(...boxes.map((b) => b.low[k]))), high = [0, 1, 2].map((k) => Math.max(...boxes.map((b) => b.low[k] + b.size[k])));
  return { low, size: high.map((h, k) => h - low[k]) };
}
function widened(box) {
  const all = Math.max(...box.size) || 1, room = box.size.map((s) => kRoom * Math.max(s, 0.3 * all));
  return { low: box.low.map((l, k) => l - room[k]), size: box.size.map((s, k) => s + 2 * room[k]) };
}
const holds = (outer, inner) => [0, 1, 2].every((k) => inner.low[k] >= outer.low[k] && inner.low[k] + inner.size[k] <= outer.low[k] + outer.size[k]);
// The number in `to` of a position that has the number q in `from`.
function changed(from, to, axis) {
  const scale = to.size[axis] > 0 ? from.size[axis] / to.size[axis] : 0, shift = to.size[axis] > 0 ? (kSteps * (from.low[axis] - to.low[axis])) / to.size[axis] : 0;
  return (q) => Math.round(q * scale + shift);
}

export class LiveRun {
  // head: run of the page. built(run, history, columns shown): the page is to be built anew. grown(end of the run so far): something was added.
  constructor(head, { rebuild, grown, told }) {
    Object.assign(this, { head, rebuild, grown, told });
    this.bodies = [];
    this.grains = [];
    this.end = 0;
    this.over = false;
    this.first = this.due = performance.now() + kFirst;
    this.queue = Promise.resolve();
    this.events = new EventSource("events");
    for (const kind of ["scene", "columns", "rows", "bodies", "grains", "state"]) this.events.addEventListener(kind, (event) => this.next(() => this[`take_${kind}`](JSON.parse(event.data))));
    this.events.onerror = () => this.over || this.told({ text: "no news from the run: the program that serves this page has ended, or is busy", lost: true });
  }

  // One after the other.
  next(work) {
    this.queue = this.queue.then(work).catch((error) => console.error(error));
  }

  async take_scene({ run, chunks }) {
    Object.assign(this.head, run);
    this.meshes = new Map();
    for (const [name, text] of Object.entries(chunks)) this.meshes.set(name, joinPlanes(await unpack(text), Float32Array));
    this.stale = true;
  }
  take_state(state) {
    this.over = state.over;
    if (state.over) this.events.close();
    this.told(state);
    if (this.stale) return this.renew();
  }
  take_columns({ names, units, shown }) {
    this.rows = 0;
    this.capacity = kRows;
    this.shown = shown;
    this.time = new Float64Array(kRows);
    this.history = { time: this.time.subarray(0, 0), columns: new Map(names.map((name, i) => [name, { name, unit: units[i], values: new Float32Array(kRows) }])) };
    this.stale = true;
  }
  async take_rows({ time, values }) {
    const packed = joinPlanes(await unpack(values), Float32Array), n = time.length;
    if (this.rows + n > this.capacity) this.widenHistory(this.rows + n);
    this.time.set(time, this.rows);
    [...this.history.columns.values()].forEach((column, i) => column.values.set(packed.subarray(i * n, (i + 1) * n), this.rows));
    this.rows += n;
    this.history.time = this.time.subarray(0, this.rows);
    this.end = Math.max(this.end, time[n - 1]);
    return this.stale && this.rows > 1 ? this.renew() : this.grown();
  }
  widenHistory(least) {
    while (this.capacity < least) this.capacity *= 2;
    const longer = (old) => {
      const all = new old.constructor(this.capacity);
      all.set(old.subarray(0, this.rows));
      return all;
    };
    this.time = longer(this.time);
    for (const column of this.history.columns.values()) column.values = longer(column.values);
    this.stale = true;
  }

  // ---- bodies and marks
  async take_bodies({ run, chunks }) {
    if (run.bodyNames) this.names = run.bodyNames;
    const raw = {};
    if (run.bodies) {
      const { points, cells, stress, stressed, box, times } = run.bodies;
      if (chunks["bodies-triangles"]) {
        this.fixed = new Map();
        for (const name of ["bodies-triangles", "bodies-lines", "bodies-cells", "bodies-radius"]) this.fixed.set(name, await unpack(chunks[name]));
      }
      const values = new SeriesDecoder(3 * points + (stress > 0 ? cells : 0)).next(await unpack(chunks["bodies-0"]));
      Object.assign(raw, { t: times[0], points, cells, stress, stressed, box, view: run.bodies.view, values });
    }
    if (run.marks) Object.assign(raw, { t: run.marks.times[0], list: run.marks.list, marksView: run.marks.view, marks: joinPlanes(await unpack(chunks.marks), Float32Array) });
    if (raw.t === undefined) return;
    this.bodies.push(raw);
    this.end = Math.max(this.end, raw.t);
    const spec = this.run?.bodies, has = this.stage?.bodies || this.stage?.marks;
    const fits = has && !this.stale && (!raw.box || (spec && holds(spec.box, raw.box) && raw.stressed.every((body) => spec.stressed.includes(body))));
    if (!fits) return this.renew(!has);
    const scaleEnds = raw.box && raw.stress > spec.stress;
    if (raw.box) {
      const values = this.bodyValues(raw, spec);
      spec.times.push(raw.t);
      this.stage.bodies.add(values);
    }
    if (raw.marks && this.stage.marks) {
      this.stage.marks.add(raw.t, raw.marks);
      this.stage.symbols.grow();
    }
    return scaleEnds ? this.renewSoon() : this.grown();
  }
  bodyValues(raw, spec) {
    const n = raw.points, values = new Uint16Array(3 * n + (spec.stress > 0 ? raw.cells : 0));
    for (let axis = 0; axis < 3; ++axis) {
      const change = changed(raw.box, spec.box, axis);
      for (let i = axis * n; i < (axis + 1) * n; ++i) values[i] = change(raw.values[i]);
    }
    if (raw.stress > 0) for (let i = 0; i < raw.cells; ++i) values[3 * n + i] = Math.min(kMostStress, Math.round((raw.values[3 * n + i] * raw.stress) / spec.stress));
    return values;
  }
  bodiesSpec() {
    const raws = this.bodies.filter((raw) => raw.box);
    if (raws.length === 0) return null;
    const stress = Math.max(...raws.map((raw) => raw.stress)), [{ points, cells, view }] = raws;
    const spec = { points, cells, view, times: raws.map((raw) => raw.t), stress: 1.5 * stress, stressed: [...new Set(raws.flatMap((raw) => raw.stressed))], box: widened(joined(raws.map((raw) => raw.box))) };
    for (const [name, bytes] of this.fixed) given.set(name, bytes);
    raws.forEach((raw, k) => given.set(`bodies-${k}`, this.bodyValues(raw, spec)));
    return spec;
  }
  marksSpec() {
    const raws = this.bodies.filter((raw) => raw.marks);
    if (raws.length === 0) return null;
    const each = raws[0].marks.length, all = new Float32Array(each * raws.length);
    raws.forEach((raw, k) => all.set(raw.marks, each * k));
    given.set("marks", all);
    return { times: raws.map((raw) => raw.t), list: raws[0].list, view: raws[0].marksView };
  }

  // ---- grains
  async take_grains({ run, chunks }) {
    const { count, times, box, view, numbers } = run.grains, values = new SeriesDecoder(count * (3 + numbers.length)).next(await unpack(chunks["grains-0"]));
    const ids = joinPlanes(await unpack(chunks["grains-ids"]), Uint32Array), radius = joinPlanes(await unpack(chunks["grains-radius"]), Float32Array);
    const raw = { t: times[0], count, box, view, numbers, values, ids, radius };
    if (count === 0) return;
    this.grains.push(raw);
    this.end = Math.max(this.end, raw.t);
    if (this.grains.length > 2 && this.grains.length * count * (3 + numbers.length) > kMostNumbers) {
      this.grains = this.grains.filter((_, k) => k % 2 === 0 || k === this.grains.length - 1);
      this.stale = true;
    }
    const spec = this.run?.grains, drawn = this.stage?.grains;
    const fits = drawn && !this.stale && holds(spec.box, box) && numbers.length === spec.numbers.length && this.placesFor(raw, drawn);
    if (!fits) return this.renew(!drawn);
    const scaleEnds = numbers.some((number, j) => number.largest > spec.numbers[j].largest);
    spec.times.push(raw.t);
    drawn.add(this.grainValues(raw, spec));
    numbers.forEach((number, j) => (spec.numbers[j].shown = Math.max(spec.numbers[j].shown, number.shown)));
    return scaleEnds ? this.renewSoon() : this.grown(true);
  }
  // Gives places to grains that are new; false where there are none left.
  placesFor({ ids, radius, count }, drawn) {
    for (let i = 0; i < count; ++i) {
      if (this.places.has(ids[i])) continue;
      const place = this.places.size;
      if (place >= this.run.grains.count) return false;
      this.places.set(ids[i], place);
      drawn.radius[place] = radius[i];
      drawn.geometry.attributes.radius.needsUpdate = true;
    }
    return true;
  }
  grainValues(raw, spec) {
    const n = spec.count, values = new Uint16Array(n * (3 + spec.numbers.length)), { ids, count } = raw, places = Uint32Array.from(ids, (id) => this.places.get(id));
    values.fill(kAbsent, 0, n);
    for (let axis = 0; axis < 3; ++axis) {
      const change = changed(raw.box, spec.box, axis);
      for (let i = 0; i < count; ++i) values[axis * n + places[i]] = change(raw.values[axis * count + i]);
    }
    spec.numbers.forEach((number, j) => {
      const scale = Math.sqrt(raw.numbers[j].largest / number.largest);
      for (let i = 0; i < count; ++i) values[(3 + j) * n + places[i]] = Math.min(255, Math.round(scale * raw.values[(3 + j) * count + i]));
    });
    this.measureWay(values, spec, n);
    return values;
  }
  // The largest displacement since the first frame, for its scale of colours.
  measureWay(values, spec, n) {
    if (!this.first) this.first = values;
    let most = 0;
    for (let i = 0; i < n; ++i) {
      if (values[i] === kAbsent || this.first[i] === kAbsent) continue;
      let way = 0;
      for (let axis = 0; axis < 3; ++axis) way += ((spec.box.size[axis] * (values[axis * n + i] - this.first[axis * n + i])) / kSteps) ** 2;
      most = Math.max(most, way);
    }
    spec.farthest = Math.max(spec.farthest, Math.sqrt(most));
  }
  grainsSpec() {
    const raws = this.grains;
    if (raws.length === 0) return null;
    this.places = new Map();
    for (const { ids } of raws) for (const id of ids) if (!this.places.has(id)) this.places.set(id, this.places.size);
    const known = this.places.size, count = known + (known > raws[0].count ? Math.ceil(kSpare * known) : 0), radius = new Float32Array(count);
    for (const raw of raws) raw.ids.forEach((id, i) => (radius[this.places.get(id)] = raw.radius[i]));
    const most = (key, j) => Math.max(...raws.map((raw) => raw.numbers[j]?.[key] ?? 0));
    const numbers = raws.at(-1).numbers.map(({ name, unit }, j) => ({ name, unit, largest: 2 * most("largest", j), shown: most("shown", j) }));
    const spec = { count, times: raws.map((raw) => raw.t), box: widened(joined(raws.map((raw) => raw.box))), view: raws[0].view, numbers, farthest: 0 };
    this.first = null;
    given.set("grains-radius", radius);
    raws.forEach((raw, k) => given.set(`grains-${k}`, this.grainValues(raw, spec)));
    return spec;
  }

  // What goes beyond the end of a scale has its last colour until then.
  renewSoon() {
    this.grown(true);
    if (this.over || performance.now() >= this.due) return this.renew();
    this.waitToRenew(this.due);
  }
  waitToRenew(due) {
    this.waiting ??= setTimeout(() => {
      this.waiting = undefined;
      this.next(() => this.renew());
    }, due - performance.now());
  }
  // The page anew, of all that is known, once it has rested; at once where it lacks bodies or grains.
  async renew(lacks = false) {
    this.stale = true;
    if (!this.history || this.rows < 2) return;
    const start = performance.now(), due = lacks ? this.first : this.due;
    if (start < due && !this.over) return this.waitToRenew(due);
    clearTimeout(this.waiting);
    this.waiting = undefined;
    this.stale = false;
    if (!this.meshes) {
      this.meshes = new Map();
      for (let k = 0; k < (this.head.meshes ?? []).length; ++k) this.meshes.set(`mesh-${k}`, await takeNumbers(`mesh-${k}`, Float32Array));
    }
    given.clear();
    for (const [name, corners] of this.meshes) given.set(name, corners);
    this.run = { ...this.head, bodyNames: this.names ?? [], grains: this.grainsSpec(), bodies: this.bodiesSpec(), marks: this.marksSpec(), history: true };
    this.stage = await this.rebuild(this.run, this.history, this.shown);
    this.due = performance.now() + Math.min(kLongest, kRested * (performance.now() - start));
  }
}
