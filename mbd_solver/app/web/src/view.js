// view.html: the run in 3D, with a time slider and plots in step. The page holds all that it shows.
import plotStyle from "uplot/dist/uPlot.min.css";
import ownPlotStyle from "./plots.css";
import style from "./view.css";
import { runOfPage, secondOf, takeHistory } from "./page.js";
import { Controls } from "./controls.js";
import { showJudgement } from "./judgement.js";
import { LiveRun } from "./live.js";
import { readLink } from "./link.js";
import { Player } from "./player.js";
import { Plots } from "./plots.js";
import { Scenery } from "./scenery.js";
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
// Of a run in progress, what was added is shown so often [ms], and rests so much longer than it took, though not for ever: the run has the
// processor.
const kGrown = 1000, kRested = 50, kLongest = 10000;

// Between two frames the browser may draw and answer.
const breath = () => new Promise((resolve) => setTimeout(resolve, 0));

// The page of this run. link: what it shows, as in its address. renderer: of a page that was built before, or none. held: nothing is drawn
// yet.
async function build(run, history, link, shown, { renderer, held = false } = {}) {
  const ended = new AbortController();
  const scenery = new Scenery(run);
  await scenery.load();
  const stage = new Stage(document.getElementById("footfall-stage"), run, renderer, scenery);
  stage.held = held;
  await stage.loadFirst();
  stage.addForces(history);
  const times = [history.time, run.grains?.times ?? [], run.bodies?.times ?? [], run.marks?.times ?? [], run.other?.history.time ?? []].filter((t) => t.length > 0);
  const player = new Player({
    start: Math.min(...times.map((t) => t[0])),
    end: Math.max(...times.map((t) => t[t.length - 1])),
    marks: run.grains?.times ?? run.bodies?.times ?? run.marks?.times ?? history.time,
  });
  const seek = (t) => {
    player.setLive(false);
    player.seek(t);
  };
  const plots = run.history ? new Plots(document.getElementById("footfall-plots"), history, shown, seek, ended.signal, await secondOf(run)) : null;
  if (plots) showJudgement(document.getElementById("footfall-plots"), run, seek);
  const controls = new Controls(run, stage, player, ended.signal);
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
  stage.resize();
  controls.follow(link);
  window.addEventListener("hashchange", () => controls.follow(readLink()), { signal: ended.signal });
  stage.draw();
  // picture(t): draws this time at once, for what photographs the page.
  const picture = (t) => {
    player.seek(t);
    controls.showCaption(player.time, window.footfall.slow);
    stage.draw();
    return player.time;
  };
  const end = () => {
    ended.abort();
    player.play(false);
    stage.end();
    controls.end();
    document.getElementById("footfall-plots").replaceChildren();
  };
  return (window.footfall = { run, history, stage, player, plots, controls, picture, end });
}

async function loadAll(page) {
  for (let more = true; more; ) {
    more = await page.stage.loadNext();
    page.controls.showLoaded();
    await breath();
  }
}

async function start() {
  const sheet = document.createElement("style");
  sheet.textContent = plotStyle + ownPlotStyle + style;
  document.head.append(sheet);
  const run = runOfPage(), link = readLink();
  document.body.classList.toggle("picture", link.picture === "1");
  document.body.classList.toggle("still", !run.history && !run.live);
  if (run.live) return startLive(run, link);
  const history = run.history ? await takeHistory(run) : { time: new Float64Array(), columns: new Map() };
  const page = await build(run, history, link, run.shown);
  document.body.dataset.firstFrame = Math.round(performance.now());  // since the browser began with the page [ms]
  document.body.dataset.state = "loading";
  await loadAll(page);
  page.player.seek(link.t !== undefined ? Number(link.t) || page.player.start : page.player.time);
  document.body.dataset.loaded = Math.round(performance.now());
  document.body.dataset.state = "ready";
  if (link.picture === "1") page.picture(page.player.time);
}

// A run in progress: its page, and the line that says how far it is.
function startLive(head, link) {
  const word = document.createElement("output");
  word.className = "progress";
  word.textContent = "waiting for the first frames of the run";
  document.querySelector("header").append(word);
  document.body.dataset.state = "waiting";
  let page = null, due = -Infinity, over = false, scaled = false;
  const live = new LiveRun(head, {
    async rebuild(run, history, shown) {
      const before = page, entries = before ? { ...before.controls.entries(), ...(before.player.live ? { t: undefined } : {}) } : link;
      const follows = before ? before.player.live : link.t === undefined, chosen = before?.plots?.chosen ?? shown;
      before?.end();
      page = await build(run, history, entries, chosen, { renderer: before?.stage.renderer, held: true });
      await loadAll(page);
      page.player.follows = !over;
      page.controls.addLive();
      page.player.setLive(follows && !over);
      if (over) page.player.seek(page.player.end);
      page.stage.held = false;
      await page.stage.drawn();
      document.body.dataset.state = over ? "ready" : "live";
      return page.stage;
    },
    async grown(scales) {
      scaled ||= scales === true;
      const start = performance.now();
      if (!page || (!over && (start < due || document.hidden))) return;
      due = Infinity;
      try {
        if (scaled) page.controls.colourGrains();
        scaled = false;
        page.stage.arrows?.grow();
        page.controls.tellForces();
        page.plots?.grow();
        page.player.grow(live.end);
        Object.assign(document.body.dataset, { end: live.end, rows: live.rows, bodies: live.bodies.length, grains: live.grains.length });
        await page.stage.drawn();
      } finally {
        due = start + Math.min(kLongest, Math.max(kGrown, kRested * (performance.now() - start)));
      }
    },
    told({ text, over: ended, lost }) {
      word.textContent = text;
      word.classList.toggle("lost", lost === true);
      if (!ended) return;
      over = true;
      this.grown();
      word.textContent += ". To keep this page, or to see all its frames: footfall view";
      document.body.dataset.state = "ready";
      if (!page) return;
      page.player.follows = false;
      page.player.setLive(false);
      page.controls.addLive();
    },
  });
  document.addEventListener("visibilitychange", () => live.grown());
  window.footfallLive = live;
}

window.addEventListener("error", (event) => fail(event.error ?? new Error(event.message)));
start().catch(fail);
