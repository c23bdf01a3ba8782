// Plots of the history: any column, at most eight at once, one plot for each unit; zoom by dragging, back by a double
// click, values under the pointer.
import { newChart, nameOfCurve } from "./chart.js";
import { kSeries, seriesColour, whenInksChange } from "./colours.js";
import { valueAt } from "./page.js";
import { scaleFor, short } from "./units.js";

const kMost = kSeries.length;
const kRoundOff = 1e-12;  // of the largest value of a plot: shown as zero

// Edges of the band of a column that is the mean of samples: columns of their own, as mbd_solver/app/difference/samples.h names them.
const kEdges = [" 5 %", " 95 %"];
const isEdge = (columns, name) => kEdges.some((edge) => name.endsWith(edge) && columns.has(name.slice(0, -edge.length)));
const edgesOf = (columns, name) => (columns.has(name + kEdges[0]) ? kEdges.map((edge) => name + edge) : []);

// The history, with the times beyond its end at which a second one has rows; its columns hold their last value there.
function withTimesOf(history, second) {
  const end = history.time.at(-1), more = Array.from(second.time).filter((t) => t > end);
  const longer = (values) => Float32Array.from([...values.subarray(0, history.time.length), ...more.map(() => values[history.time.length - 1])]);
  const columns = new Map([...history.columns].map(([name, column]) => [name, { ...column, values: longer(column.values) }]));
  return { time: Float64Array.from([...history.time, ...more]), columns, end };
}

export class Plots {
  // Builds itself into `place`. seek(t): the user has clicked a time; null where there is nothing to move.
  // signal: ends what listens to the document. second: a second run (secondOf), or none: its curves are dashed, and their difference gets a
  // plot of its own.
  constructor(place, history, chosen, seek, signal, second = null) {
    this.history = second ? withTimesOf(history, second.history) : history;
    this.second = second;
    this.seek = seek;
    this.chosen = chosen.filter((name) => history.columns.has(name)).slice(0, kMost);
    this.plots = [];
    this.time = null;
    this.place = place;
    place.classList.add("plots");
    place.innerHTML = `
      <div class="chooser">
        <input type="search" placeholder="column of the history, for example energy" aria-label="find a column" />
        <ul class="found" hidden></ul>
        <ul class="chosen"></ul>
      </div>
      <div class="drawn"></div>`;
    this.input = place.querySelector("input");
    this.found = place.querySelector(".found");
    this.list = place.querySelector(".chosen");
    this.drawn = place.querySelector(".drawn");
    this.input.addEventListener("input", () => this.offer());
    this.input.addEventListener("focus", () => this.offer());
    this.input.addEventListener("keydown", (event) => {
      event.stopPropagation(); // letters are no commands here
      if (event.key === "Escape") this.input.blur();
      if (event.key === "Enter") this.found.querySelector("li[data-name]")?.click();
    });
    document.addEventListener("pointerdown", (event) => {
      if (!place.querySelector(".chooser").contains(event.target)) this.found.hidden = true;
    }, { signal });
    new ResizeObserver(() => this.resize()).observe(this.drawn);
    whenInksChange(() => {
      for (const item of this.list.children) item.recolour();
      for (const { plot } of this.plots) plot.redraw();
    }, signal);
    this.draw();
  }

  // Rows were added to the history.
  grow() {
    if (this.plots.some(({ names, scale }) => scaleFor(this.history.columns.get(names[0]).unit, this.largestOf(names)).unit !== scale.unit)) return this.draw();
    for (const { plot, names, scale } of this.plots) plot.setData(this.dataOf(names, scale.factor));
    this.showTime(this.time);
  }
  largestOf(names) {
    let largest = 0;
    for (const name of names.flatMap((name) => [name, ...edgesOf(this.history.columns, name)])) for (const value of this.history.columns.get(name).values) largest = Math.max(largest, Math.abs(value));
    return largest;
  }
  largestDifference(names) {
    let largest = 0;
    for (const name of names) for (const v of this.difference(name)) if (v !== null) largest = Math.max(largest, Math.abs(v));
    return largest;
  }
  // A column of the second run at the times of the first one; null outside of it.
  ofSecond(name) {
    const { history } = this.second, column = history.columns.get(name), [first, last] = [history.time[0], history.time.at(-1)];
    this.seconds ??= new Map();
    if (!this.seconds.has(name)) this.seconds.set(name, Array.from(this.history.time, (t) => (column && t >= first && t <= last ? valueAt(history, column.values, t) : null)));
    return this.seconds.get(name);
  }
  ofFirst(name) {
    const { time, columns, end } = this.history, { values } = columns.get(name);
    return Array.from(time, (t, k) => (t <= end ? values[k] : null));
  }
  difference(name) {
    const first = this.ofFirst(name);
    return this.ofSecond(name).map((v, k) => (v === null || first[k] === null ? null : v - first[k]));
  }
  dataOf(names, factor, differs = false) {
    const n = this.history.time.length, scaled = (values) => values.map((v) => (v === null ? null : v * factor));
    const edges = differs ? [] : this.bandsOf(names);
    if (this.second && differs) return [this.history.time, ...names.map((name) => scaled(this.difference(name)))];
    if (this.second) return [this.history.time, ...names.map((name) => scaled(this.ofFirst(name))), ...names.map((name) => scaled(this.ofSecond(name))), ...edges.map(({ edge, second }) => scaled(second ? this.ofSecond(edge) : this.ofFirst(edge)))];
    return [this.history.time, ...names.map((name) => this.history.columns.get(name).values.subarray(0, n).map((v) => v * factor))];
  }

  // The edges of all bands of these columns, two by two: of the first run, then of the second.
  bandsOf(names) {
    if (!this.second) return [];
    return [false, true].flatMap((second) => names.flatMap((name) =>
      edgesOf((second ? this.second.history : this.history).columns, name).map((edge) => ({ name, edge, second }))));
  }

  offer() {
    const words = this.input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const names = [...this.history.columns.keys()].filter((name) => name !== "time" && !isEdge(this.history.columns, name) && words.every((w) => name.toLowerCase().includes(w)));
    this.found.replaceChildren(
      ...names.slice(0, 200).map((name) => {
        const item = document.createElement("li");
        item.dataset.name = name;
        item.textContent = `${name} [${this.history.columns.get(name).unit}]`;
        item.classList.toggle("on", this.chosen.includes(name));
        item.addEventListener("click", () => this.toggle(name));
        return item;
      }),
    );
    if (names.length === 0) this.found.innerHTML = "<li>no column has these letters</li>";
    this.found.hidden = false;
  }

  toggle(name) {
    if (this.chosen.includes(name)) this.chosen = this.chosen.filter((n) => n !== name);
    else if (this.chosen.length < kMost) this.chosen.push(name);
    else {
      this.found.innerHTML = `<li>${kMost} columns are shown; remove one first</li>`;
      return;
    }
    this.draw();
    if (!this.found.hidden) this.offer();
  }

  colour(name) {
    return seriesColour(this.chosen.indexOf(name));
  }

  draw() {
    this.list.replaceChildren(
      ...this.chosen.map((name) => {
        const item = nameOfCurve(name, () => this.colour(name)), button = document.createElement("button");
        button.textContent = "\u00d7";
        button.setAttribute("aria-label", `remove ${name}`);
        button.addEventListener("click", () => this.toggle(name));
        item.append(button);
        return item;
      }),
    );
    for (const { plot, box } of this.plots) {
      plot.destroy();
      box.remove();
    }
    const units = [...new Set(this.chosen.map((name) => this.history.columns.get(name).unit))];
    this.plots = units.map((unit) => this.plotOf(unit));
    if (this.second) this.plots.push(...units.map((unit) => this.plotOf(unit, true)));
    this.resize();
    this.showTime(this.time);
  }

  // differs: of the second run minus the first.
  plotOf(unit, differs = false) {
    const names = this.chosen.filter((name) => this.history.columns.get(name).unit === unit);
    const largest = differs ? this.largestDifference(names) : this.largestOf(names), scale = scaleFor(unit, largest);
    const edges = differs ? [] : this.bandsOf(names);
    const firstEdge = 1 + 2 * names.length;  // behind the time and the curves of both runs
    const ink = (name, opacity = "") => () => this.colour(name) + opacity;
    const options = {
      series: [
        ...names.map((name) => ({ label: name, stroke: ink(name) })),
        ...(this.second && !differs ? names.map((name) => ({ label: name, stroke: ink(name), width: 1.4, dash: [6, 4] })) : []),
        ...edges.map(({ edge }) => ({ label: edge, stroke: "transparent", width: 0 })),
      ],
      bands: edges.flatMap(({ name, second }, k) => (k % 2 ? [] : [{ series: [firstEdge + k + 1, firstEdge + k], fill: ink(name, second ? "22" : "44") }])),
      hooks: { setCursor: [(plot) => this.showValues(plot.cursor.idx)], setScale: [() => this.showTime(this.time)] },
    };
    const box = document.createElement("div");
    box.className = "plot";
    const heading = document.createElement("div");
    heading.className = "unit";
    const what = !this.second ? "" : differs ? `${this.second.names[1]} \u2212 ${this.second.names[0]} ` : `${this.second.names[0]} \u2014, ${this.second.names[1]} - - `;
    heading.textContent = `${what}[${scale.unit || "-"}] over time [s]`;
    box.append(heading);
    this.drawn.append(box);
    const plot = newChart(box, this.dataOf(names, scale.factor, differs), options);
    const line = document.createElement("div");
    line.className = "now";
    plot.over.append(line);
    let pressed = null;
    plot.over.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    plot.over.addEventListener("pointerup", (event) => {
      const still = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4;
      if (still && this.seek) this.seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
    });
    return { plot, line, box, names, scale, differs, largest };
  }

  // The line of the picture's time; the values there, unless the pointer asks for others.
  showTime(t) {
    this.time = t;
    for (const { plot, line } of this.plots) {
      const at = t === null ? NaN : plot.valToPos(t, "x");
      line.hidden = !(at >= 0 && at <= plot.over.clientWidth);
      if (!line.hidden) line.style.transform = `translateX(${at}px)`;
    }
    if (this.pointed == null && t !== null) this.writeValues(this.rowAt(t));
  }
  showValues(index) {
    this.pointed = index;
    if (index != null) this.writeValues(index);
    else if (this.time !== null) this.writeValues(this.rowAt(this.time));
  }
  rowAt(t) {
    const { time } = this.history;
    let low = 0, high = time.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (time[middle] <= t) low = middle;
      else high = middle - 1;
    }
    return low + 1 < time.length && time[low + 1] - t < t - time[low] ? low + 1 : low;
  }
  writeValues(row) {
    for (const { names, scale, differs, largest } of this.plots)
      for (const name of names) {
        if (differs) continue;
        const word = (v) => (v === null ? "\u2013" : short(Math.abs(v) < kRoundOff * largest ? 0 : v * scale.factor)), value = this.history.columns.get(name).values[row];
        const text = this.second ? `${word(this.ofFirst(name)[row])} | ${word(this.ofSecond(name)[row])}` : word(value);
        this.list.children[this.chosen.indexOf(name)].querySelector("output").textContent = `${text} ${scale.unit}`;
      }
  }

  resize() {
    const width = this.drawn.clientWidth;
    if (!(width > 60)) return;
    const height = Math.max(150, Math.min(260, this.plots.length === 1 ? 260 : 190));
    for (const { plot } of this.plots) plot.setSize({ width, height });
    this.showTime(this.time);
  }
}
