// view.html: the run in 3D, with a time slider and plots in step. All that is shown stands in the page.
import plotStyle from "uplot/dist/uPlot.min.css";
import ownPlotStyle from "./plots.css";
import style from "./view.css";
import { runOfPage, takeHistory } from "./page.js";
import { Controls } from "./controls.js";
import { readLink } from "./link.js";
import { Player } from "./player.js";
import { Plots } from "./plots.js";
import { Stage } from "./stage.js";

function fail(error) {
  document.body.dataset.state = "failed";
  const note = document.getElementById("footfall-fault");
  note.hidden = false;
  note.textContent = `This run cannot be shown: ${error.message}. The page needs a browser of 2023 or later with WebGL 2.`;
  console.error(error);
}

// While it plays, numbers, slider and lines in the plots follow so often [ms]: to draw the page anew takes a software renderer longer than the
// picture does.
const kTold = 160;

// Between two frames the browser may draw and answer.
const breath = () => new Promise((resolve) => setTimeout(resolve, 0));

async function start() {
  const sheet = document.createElement("style");
  sheet.textContent = plotStyle + ownPlotStyle + style;
  document.head.append(sheet);
  const run = runOfPage();
  const stage = new Stage(document.getElementById("footfall-stage"), run);
  await stage.loadFirst();
  const history = run.history ? await takeHistory(run) : { time: new Float64Array(), columns: new Map() };
  stage.addForces(history);

  const times = [history.time, run.grains?.times ?? [], run.bodies?.times ?? [], run.marks?.times ?? []].filter((t) => t.length > 0);
  const player = new Player({
    start: Math.min(...times.map((t) => t[0])),
    end: Math.max(...times.map((t) => t[t.length - 1])),
    marks: run.grains?.times ?? run.bodies?.times ?? run.marks?.times ?? history.time,
  });
  const plots = run.history ? new Plots(document.getElementById("footfall-plots"), history, run.shown, (t) => player.seek(t)) : null;
  const controls = new Controls(run, stage, player);
  stage.controls = controls;
  let told = -Infinity;
  player.onTime = (t) => {
    stage.setTime(t);
    const now = performance.now();
    if (player.playing && now - told < kTold) return;
    told = now;
    plots?.showTime(t);
    controls.showTime(t);
  };
  player.onStopped = () => player.seek(player.time);
  player.seek(player.start);
  const link = readLink();
  document.body.classList.toggle("picture", link.picture === "1");
  document.body.classList.toggle("still", !run.history);
  stage.resize();
  controls.follow(link);
  window.addEventListener("hashchange", () => controls.follow(readLink()));
  stage.draw();
  document.body.dataset.firstFrame = Math.round(performance.now());  // since the browser began with the page [ms]
  document.body.dataset.state = "loading";
  for (let more = true; more; ) {
    more = await stage.loadNext();
    controls.showLoaded();
    await breath();
  }
  player.seek(link.t !== undefined ? Number(link.t) || player.start : player.time);
  document.body.dataset.loaded = Math.round(performance.now());
  document.body.dataset.state = "ready";
  // picture(t): draws this time at once, for what photographs the page.
  const picture = (t) => {
    player.seek(t);
    controls.showCaption(player.time, window.footfall.slow);
    stage.draw();
    return player.time;
  };
  window.footfall = { run, stage, player, plots, controls, picture };
  if (link.picture === "1") picture(player.time);
}

window.addEventListener("error", (event) => fail(event.error ?? new Error(event.message)));
start().catch(fail);
