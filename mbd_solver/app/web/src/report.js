// report.html and difference.html: the mechanism, figures, and plots of any column.
import plotStyle from "uplot/dist/uPlot.min.css";
import ownStyle from "./plots.css";
import { showFigures } from "./figures.js";
import { runOfPage, secondOf, takeHistory, takeNumbers } from "./page.js";
import { paintMechanism } from "./picture.js";
import { Plots } from "./plots.js";

async function start() {
  const style = document.createElement("style");
  style.textContent = plotStyle + ownStyle;
  document.head.append(style);
  const run = runOfPage();
  const parts = {
    "footfall-mechanism": (place) => paintMechanism(place, run),
    "footfall-figures": async (place) => showFigures(place, run.figures[place.dataset.group], await takeNumbers(`figures-${place.dataset.group}`, Float32Array)),
    "footfall-plots": async (place) => new Plots(place, await takeHistory(run), run.shown, null, undefined, await secondOf(run)),
  };
  let state = "ready";
  for (const [name, show] of Object.entries(parts))
    for (const place of document.getElementsByClassName(name))
      try {
        await show(place);
      } catch (error) {
        place.replaceWith(`This cannot be shown: ${error.message}. It needs a browser of 2023 or later.`);
        state = "failed";
        console.error(error);
      }
  document.body.dataset.state = state;
}
start();
