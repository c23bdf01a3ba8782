// A plot of curves, as all pages draw it: zoom by dragging, back by a double click. Inks are asked for with every drawing, as the page may become dark, or paper.
import uPlot from "uplot";
import { inks } from "./colours.js";
import { short } from "./units.js";

// data: of uPlot: first the times, then each curve. series, own: options of uPlot beyond the common ones.
export function newChart(place, data, { series, ...own }) {
  const grid = { stroke: () => inks().grid, width: 1 }, font = "12px sans-serif";
  const axis = (size) => ({ font, labelFont: font, size, stroke: () => inks().ink, grid, values: (_, ticks) => ticks.map((v) => short(v)) });
  return new uPlot({
    width: 320,
    height: 200,
    legend: { show: false },
    cursor: { sync: { key: "footfall" }, drag: { x: true, y: false, setScale: true }, points: { size: 6 } },
    axes: [axis(34), axis(58)],
    series: [{}, ...series.map((one) => ({ width: 1.6, points: { show: false }, ...one }))],
    ...own,
    scales: { x: { time: false }, ...own.scales },
  }, data, place);
}

// A line of a list: the curve's colour, its name, and the place of its value. inkOf: gives the colour.
export function nameOfCurve(name, inkOf) {
  const item = document.createElement("li");
  item.innerHTML = '<span class="dot"></span><span></span><output></output>';
  item.children[1].textContent = name;
  item.recolour = () => (item.firstChild.style.background = inkOf());
  item.recolour();
  return item;
}
