// The plots of report.html.
import plotStyle from "uplot/dist/uPlot.min.css";
import ownStyle from "./plots.css";
import { runOfPage, secondOf, takeHistory } from "./page.js";
import { Plots } from "./plots.js";

async function start() {
  const place = document.getElementById("footfall-plots");
  try {
    const style = document.createElement("style");
    style.textContent = plotStyle + ownStyle;
    document.head.append(style);
    const run = runOfPage();
    new Plots(place, await takeHistory(run), run.shown, null, undefined, await secondOf(run));
    document.body.dataset.state = "ready";
  } catch (error) {
    place.textContent = `The plots cannot be shown: ${error.message}. They need a browser of 2023 or later.`;
    document.body.dataset.state = "failed";
    console.error(error);
  }
}
start();
