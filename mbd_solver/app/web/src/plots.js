// Plots of the history: any column, at most eight at once, one plot for each unit; zoom by dragging, back by a double
// click, values under the pointer.
import uPlot from "uplot";
import { kSeries } from "./colours.js";
import { scaleFor, short } from "./units.js";

const kMost = kSeries.length;

export class Plots {
  // Builds itself into `place`. seek(t): the user has clicked a time; null where there is nothing to move.
  constructor(place, history, chosen, seek) {
    this.history = history;
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
    });
    new ResizeObserver(() => this.resize()).observe(this.drawn);
    this.draw();
  }

  offer() {
    const words = this.input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const names = [...this.history.columns.keys()].filter((name) => name !== "time" && words.every((w) => name.toLowerCase().includes(w)));
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
    return kSeries[this.chosen.indexOf(name)];
  }

  draw() {
    this.list.replaceChildren(
      ...this.chosen.map((name) => {
        const item = document.createElement("li");
        item.innerHTML = `<span class="dot" style="background:${this.colour(name)}"></span><span></span><output></output><button>\u00d7</button>`;
        item.children[1].textContent = name;
        item.querySelector("button").setAttribute("aria-label", `remove ${name}`);
        item.querySelector("button").addEventListener("click", () => this.toggle(name));
        return item;
      }),
    );
    for (const { plot, box } of this.plots) {
      plot.destroy();
      box.remove();
    }
    const units = [...new Set(this.chosen.map((name) => this.history.columns.get(name).unit))];
    this.plots = units.map((unit) => this.plotOf(unit));
    this.resize();
    this.showTime(this.time);
  }

  plotOf(unit) {
    const names = this.chosen.filter((name) => this.history.columns.get(name).unit === unit);
    const columns = names.map((name) => this.history.columns.get(name).values);
    let largest = 0;
    for (const column of columns) for (const value of column) largest = Math.max(largest, Math.abs(value));
    const scale = scaleFor(unit, largest);
    const font = "12px sans-serif";
    const options = {
      width: 320,
      height: 200,
      legend: { show: false },
      cursor: { sync: { key: "footfall" }, drag: { x: true, y: false, setScale: true }, points: { size: 6 } },
      scales: { x: { time: false } },
      axes: [
        { font, labelFont: font, size: 34, stroke: "#333", grid: { stroke: "#e4e4e4", width: 1 }, values: (_, ticks) => ticks.map((v) => short(v)) },
        { font, labelFont: font, size: 58, stroke: "#333", grid: { stroke: "#e4e4e4", width: 1 }, values: (_, ticks) => ticks.map((v) => short(v)) },
      ],
      series: [{}, ...names.map((name) => ({ label: name, stroke: this.colour(name), width: 1.6, points: { show: false } }))],
      hooks: { setCursor: [(plot) => this.showValues(plot.cursor.idx)], setScale: [() => this.showTime(this.time)] },
    };
    const box = document.createElement("div");
    box.className = "plot";
    const heading = document.createElement("div");
    heading.className = "unit";
    heading.textContent = scale.unit ? `[${scale.unit}] over time [s]` : "[-] over time [s]";
    box.append(heading);
    this.drawn.append(box);
    const plot = new uPlot(options, [this.history.time, ...columns.map((c) => c.map((v) => v * scale.factor))], box);
    const line = document.createElement("div");
    line.className = "now";
    plot.over.append(line);
    let pressed = null;
    plot.over.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    plot.over.addEventListener("pointerup", (event) => {
      const still = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4;
      if (still && this.seek) this.seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
    });
    return { plot, line, box, names, scale };
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
    for (const { names, scale } of this.plots)
      for (const name of names) {
        const value = this.history.columns.get(name).values[row] * scale.factor;
        this.list.children[this.chosen.indexOf(name)].querySelector("output").textContent = `${short(value)} ${scale.unit}`;
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
