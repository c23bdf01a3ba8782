// Figures of a report: curves over time with touchdown, peak and limits; or bands, each the part of a sum.
import uPlot from "uplot";
import { newChart, nameOfCurve } from "./chart.js";
import { inks, seriesColour, whenInksChange } from "./colours.js";
import { short } from "./units.js";

const kRoom = 16;  // above a plot, for the words of times [pixels of the page]

class Figure {
  // spec: as figure_parts.cpp writes it; curves: values of each, in the unit of the axis.
  constructor(place, spec, time, curves) {
    Object.assign(this, { spec, time, curves });
    place.classList.add("plots");
    const caption = document.createElement("figcaption"), unit = document.createElement("div"), list = document.createElement("ul");
    caption.textContent = spec.title;
    unit.className = "unit";
    unit.textContent = [`${spec.axis} over time [s]`, ...spec.peaks.map(({ text }) => `peak ${text}`)].join(", ");
    list.className = "chosen";
    this.names = spec.curves.map((curve) => nameOfCurve(curve.title, () => this.ink(curve)));
    list.append(...this.names);
    place.append(caption, unit, list);
    // Later curves are thinner, so that equal ones are seen on each other. The uppermost band first, so that each is painted over those above it.
    const order = spec.curves.map((_, i) => (spec.stacked ? spec.curves.length - 1 - i : i));
    const ink = (i) => () => this.ink(spec.curves[i]), last = spec.curves.length - 1;
    this.plot = newChart(place, [time, ...order.map((i) => curves[i])], {
      padding: [spec.times.length > 0 ? kRoom : null, null, null, null],
      series: order.map((i) => (spec.stacked ? { fill: ink(i), fillTo: 0, width: 0 } : { stroke: ink(i), width: last > 0 ? 3 - (1.8 * i) / last : 1.6 })),
      scales: { y: { range: (_, low, high) => this.range(low, high) } },
      hooks: { draw: [(plot) => this.mark(plot)], setCursor: [(plot) => this.showValues(plot.cursor.idx)] },
    });
    // The caption is as wide as the figure, and keeps its size when the plot changes.
    new ResizeObserver(() => place.clientWidth > 60 && this.plot.setSize({ width: place.clientWidth, height: 210 })).observe(caption);
    whenInksChange(() => {
      for (const name of this.names) name.recolour();
      this.plot.redraw();
    });
  }
  ink({ colour, series }) {
    return colour || seriesColour(series);
  }
  range(low, high) {
    const all = [low, high, ...this.spec.limits.map(({ value }) => value), ...(this.spec.stacked ? [0] : [])].filter((v) => v !== null);
    return uPlot.rangeNum(Math.min(...all), Math.max(...all), 0.1, true);
  }
  // A band's value is its own part.
  showValues(row) {
    this.names.forEach((name, i) => {
      const value = row == null ? null : this.curves[i][row] - (this.spec.stacked && i > 0 ? this.curves[i - 1][row] : 0);
      name.querySelector("output").textContent = value === null ? "" : short(value);
    });
  }
  mark({ ctx, bbox, valToPos }) {
    const ratio = uPlot.pxRatio, right = bbox.left + bbox.width, bottom = bbox.top + bbox.height;
    const line = (from, to, ink, dash) => {
      ctx.strokeStyle = ctx.fillStyle = ink;
      ctx.setLineDash(dash.map((d) => d * ratio));
      ctx.beginPath();
      ctx.moveTo(...from);
      ctx.lineTo(...to);
      ctx.stroke();
    };
    ctx.save();
    ctx.lineWidth = ratio;
    ctx.font = `${11 * ratio}px sans-serif`;
    ctx.textBaseline = "bottom";
    for (const { time, text } of this.spec.times) {
      const x = valToPos(time, "x", true), turned = x > right - ctx.measureText(text).width;
      if (x < bbox.left || x > right) continue;
      line([x, bbox.top], [x, bottom], inks().ink, [2, 3]);
      ctx.textAlign = turned ? "right" : "left";
      ctx.fillText(text, x, bbox.top - 2 * ratio);
    }
    ctx.textAlign = "right";
    for (const { value, text } of this.spec.limits) {
      const y = valToPos(value, "y", true);
      if (y < bbox.top || y > bottom) continue;
      line([bbox.left, y], [right, y], inks().limit, [7, 4]);
      ctx.fillText(text, right - 4 * ratio, y - 2 * ratio);
    }
    for (const { time, value } of this.spec.peaks) {
      const x = valToPos(time, "x", true), y = valToPos(value, "y", true);
      if (x < bbox.left || x > right || y < bbox.top || y > bottom) continue;
      ctx.fillStyle = inks().ink;
      ctx.beginPath();
      ctx.arc(x, y, 3 * ratio, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.restore();
  }
}

// group: times, and the figures that share them; values: curve by curve.
export function showFigures(place, { times, figures }, values) {
  const time = Float64Array.from(times);
  let next = 0;
  for (const spec of figures) {
    const figure = document.createElement("figure");
    place.append(figure);
    new Figure(figure, spec, time, spec.curves.map(() => values.subarray(next * time.length, ++next * time.length)));
  }
}
