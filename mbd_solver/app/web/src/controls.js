// Buttons, slider, keys: what the user can do.
import { cssGradient, kMaps } from "./colours.js";
import { linkOf, numbersIn } from "./link.js";
import { short, withUnit } from "./units.js";

const kKeys = [
  ["space", "play, pause"],
  ["\u2190 \u2192", "one frame back, on"],
  ["Home End", "start, end"],
  ["+ \u2212", "faster, slower"],
  ["c", "clip plane across x, y, z, none"],
  ["[ ]", "move the clip plane"],
  ["f", "ground forces"],
  ["j", "symbols of joints, struts, drives, forces"],
  ["n", "names"],
  ["l", "this moment and camera into the address of the page"],
  ["g", "next colour of the grains"],
  ["b", "next colour of the bodies"],
  ["s", "smooth, or frame by frame"],
  ["1 2 3 4 5", "from the front, the side, above, all, the mechanism"],
  ["?", "this list"],
];

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

function choice(label, options, picked, change) {
  const select = make("select", { onchange: () => change(select.value), "aria-label": label });
  for (const { value, text } of options) select.append(make("option", value === picked ? { value, selected: "" } : { value }, text));
  return { select, row: make("label", {}, make("span", {}, label), select) };
}

const forcesText = (largest) => `ground forces, length ~ sqrt(F), max ${withUnit(largest, "N")}`;

export class Controls {
  // signal: ends what listens to the document.
  constructor(run, stage, player, signal) {
    Object.assign(this, { run, stage, player });
    this.frames = 0;
    this.bar();
    if (stage.scene) this.panel();
    this.help();
    player.onPlaying = (on) => {
      this.button.textContent = on ? "\u275a\u275a" : "\u25b6";
      this.button.setAttribute("aria-label", on ? "pause" : "play");
      stage.suitRate(0, on);
    };
    document.addEventListener("keydown", (event) => this.key(event), { signal });
  }
  end() {
    for (const id of ["panel", "bar", "caption"]) document.getElementById(`footfall-${id}`).replaceChildren();
    this.keys.remove();
  }
  // Of a run in progress: back to its end.
  addLive() {
    const { player } = this;
    this.live?.remove();
    if (!player.follows) return;
    this.live = make("button", { class: "live", onclick: () => player.setLive(true), title: "stay at the end of the run" }, "\u25cf live");
    document.getElementById("footfall-bar").append(this.live);
    player.onLive = (on) => this.live.classList.toggle("on", on);
    player.onLive(player.live);
  }
  tellForces() {
    const largest = this.stage.arrows?.largest > 0 ? this.stage.arrows.largest : 0;
    if (!this.forces || !(largest > 0)) return;
    this.forces.hidden = false;
    this.forces.querySelector("span").textContent = forcesText(largest);
  }

  bar() {
    const { player } = this;
    this.button = make("button", { onclick: () => player.play(), "aria-label": "play", class: "play" }, "\u25b6");
    this.slider = make("input", { type: "range", min: 0, max: 10000, value: 0, step: 1, "aria-label": "time", oninput: () => {
      player.play(false);
      player.seek(player.start + (this.slider.value / 10000) * (player.end - player.start));
    } });
    this.clock = make("output", { class: "clock" });
    const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4].map((v) => ({ value: String(v), text: `\u00d7 ${v}` }));
    const speed = choice("speed", speeds, "1", (value) => (player.speed = Number(value)));
    this.speed = speed.select;
    document.getElementById("footfall-bar").append(
      this.button,
      make("button", { onclick: () => player.step(-1), "aria-label": "one frame back" }, "\u2039"),
      make("button", { onclick: () => player.step(1), "aria-label": "one frame on" }, "\u203a"),
      this.slider,
      this.clock,
      this.speed,
      make("button", { onclick: () => (this.keys.hidden = !this.keys.hidden), "aria-label": "keys" }, "?"),
    );
  }

  panel() {
    const { stage, run } = this;
    const rows = [];
    this.legend = make("div", { class: "legends" });
    if (stage.grains) {
      const colours = stage.grains.colours();
      const found = choice("grains", colours.map((c) => ({ value: c.name, text: c.name })), colours[0].name, () => this.colourGrains());
      this.grainColour = found.select;
      rows.push(found.row);
    }
    if (stage.bodies) {
      const options = [{ value: "body", text: "by body" }];
      if (run.bodies.stress > 0) options.push({ value: "stress", text: "stress" });
      const found = choice("bodies", options, options[0].value, () => this.colourBodies());
      this.bodyColour = found.select;
      rows.push(found.row);
    }
    const clip = choice("clip", [["", "none"], ["x", "across x"], ["y", "across y"], ["z", "across z"]].map(([value, text]) => ({ value, text })), "",
      (axis) => this.setClip({ axis }));
    this.clip = clip.select;
    this.clipPlace = make("input", { type: "range", min: 0, max: 1, step: 0.005, value: 0.5, "aria-label": "place of the clip plane", oninput: () =>
      this.setClip({ share: Number(this.clipPlace.value) }) });
    this.clipText = make("output");
    this.clipMore = make("div", { class: "clip", hidden: "" }, this.clipPlace, this.clipText,
      this.check("other side", false, (on) => this.setClip({ flip: on })), this.check("bodies too", false, (on) => this.setClip({ bodies: on })));
    rows.push(clip.row, this.clipMore);
    if (stage.arrows?.largest > 0 || (run.live && stage.arrows)) {
      this.forces = this.check(forcesText(stage.arrows.largest), true, (on) => {
        stage.arrows.object.visible = on;
        stage.setTime(stage.time);
      });
      this.forces.hidden = !(stage.arrows.largest > 0);
      rows.push(this.forces);
    }
    if (stage.other)
      rows.push((this.ghost = this.check(`ghost: ${run.other.name}`, true, (on) => {
        stage.other.object.visible = on;
        stage.wish();
      })));
    if (stage.symbols) this.symbolRows(rows);
    rows.push((this.smooth = this.check("smooth between frames", true, (on) => {
      stage.smooth = on;
      stage.setTime(stage.time);
    })));
    const views = [["front", -90, 4], ["side", 0, 4], ["above", -90, 89.9], ["all", -65, 24]];
    this.views = views.map(([name, azimuth, elevation]) => make("button", { onclick: () => stage.look(azimuth, elevation) }, name));
    if (stage.mechanism) this.views.push(make("button", { onclick: () => stage.lookAtMechanism(-65, 18) }, "mechanism"));
    const notes = [`grid: squares of ${short(stage.square)} m`];
    if (stage.slope > 1e-3) notes.push(`slope: ${short((stage.slope * 180) / Math.PI, 3)}\u00b0`);
    if (stage.grains) notes.push(`bands: initial depth, ${short(stage.grains.layer)} m each`);
    this.notes = notes;
    rows.push(make("div", { class: "views" }, ...this.views, make("button", { onclick: () => this.writeLink(), title: "this moment and camera into the address of the page" }, "link")), this.legend,
      ...notes.map((text) => make("div", { class: "note" }, text)));
    document.getElementById("footfall-panel").append(make("details", innerWidth > 1500 ? { open: "" } : {}, make("summary", {}, "show"), ...rows));
    this.colourGrains();
    this.colourBodies();
  }

  // Switches of the symbols, and the point whose track is drawn.
  symbolRows(rows) {
    const { stage } = this, redraw = () => stage.setTime(stage.time);
    const all = (this.symbols = this.check("symbols", true, (on) => {
      stage.symbols.object.visible = on;
      redraw();
    }));
    this.layers = new Map(stage.symbols.layers().map((layer) => [layer.name, this.check(layer.text, layer.on, (on) => {
      stage.symbols.on[layer.name] = on;
      redraw();
    })]));
    this.named = this.check("names", false, (on) => {
      stage.overlay.named = on;
      stage.wish();
    });
    rows.push(all, make("div", { class: "layers" }, ...this.layers.values(), this.named));
    const points = stage.marks.list.filter((mark) => mark.kind === "body" || mark.kind === "joint").map((mark) => `${mark.kind}:${mark.name}`);
    const track = choice("track of", [{ value: "", text: "no point" }, ...points.map((value) => ({ value, text: value.replace(":", " ") }))], "", (value) => {
      stage.symbols.setTrack(value);
      redraw();
    });
    this.track = track.select;
    rows.push(track.row);
  }

  // ---- links: what the page shows, as its address
  writeLink() {
    history.replaceState(null, "", linkOf(this.entries()));
  }
  entries() {
    const { stage, player } = this, entries = { t: Number(player.time.toPrecision(6)) };
    if (stage.scene) {
      const eye = stage.eye(), text = (x) => String(Number(x.toFixed(3)));
      entries.camera = [eye.azimuth, eye.elevation, eye.zoom, ...eye.at].map(text).join(",");
      entries.grains = this.grainColour?.value;
      entries.bodies = this.bodyColour?.value;
      const off = [...(this.layers ?? [])].filter(([, label]) => !label.querySelector("input").checked).map(([name]) => name);
      if (this.symbols && !this.symbols.querySelector("input").checked) off.push("symbols");
      if (this.forces && !this.forces.querySelector("input").checked) off.push("arrows");
      entries.hide = off.join(",");
      entries.track = this.track?.value;
      entries.names = stage.overlay.named ? "1" : "";
      if (stage.clip.axis) entries.clip = [stage.clip.axis, Number(stage.clip.share.toFixed(3))].join(",");
    }
    return entries;
  }
  follow(link) {
    const { stage, player } = this;
    const set = (label, on) => label && label.querySelector("input").checked !== on && Controls.flip(label);
    const pick = (select, value) => {
      if (!select || ![...select.options].some((option) => option.value === value)) return;
      select.value = value;
      select.dispatchEvent(new Event("change"));
    };
    const [t] = numbersIn(link.t);
    if (t !== undefined) player.seek(t);
    if (!stage.scene) return;
    const camera = numbersIn(link.camera);
    if (camera.length >= 2) stage.look(camera[0], camera[1], camera[2] > 0 ? camera[2] : 1, camera.length >= 6 ? camera.slice(3, 6) : null);
    else if (link.camera === "mechanism") stage.lookAtMechanism(-65, 18);
    pick(this.grainColour, link.grains);
    pick(this.bodyColour, link.bodies);
    if (link.track !== undefined) pick(this.track, link.track.includes(":") || link.track === "" ? link.track : `body:${link.track}`);
    if (link.hide !== undefined) {
      const off = link.hide.split(",");
      for (const [name, label] of this.layers ?? []) set(label, !off.includes(name));
      set(this.symbols, !off.includes("symbols"));
      set(this.forces, !off.includes("arrows"));
      if (stage.grains) stage.grains.object.visible = !off.includes("grains");
      if (stage.bodies) stage.bodies.object.visible = !off.includes("bodies");
    }
    if (link.names !== undefined) set(this.named, link.names === "1");
    if (link.clip !== undefined && this.clip) {
      const [axis, share] = link.clip.split(",");
      pick(this.clip, axis);
      this.setClip({ share: Number(share) >= 0 ? Number(share) : 0.5 });
      this.clipPlace.value = String(stage.clip.share);
    }
    stage.wish();
  }

  check(label, on, change) {
    const box = make("input", { type: "checkbox", ...(on ? { checked: "" } : {}), onchange: () => change(box.checked) });
    return make("label", { class: "check" }, box, make("span", {}, label));
  }
  static flip(label) {
    label?.querySelector("input").click();
  }

  setClip(change) {
    const { stage } = this;
    stage.setClip(change);
    this.clipMore.hidden = stage.clip.axis === "";
    this.clipText.textContent = stage.clip.axis ? `${stage.clip.axis} = ${short(stage.clipAt, 3)} m` : "";
  }

  colourGrains() {
    if (!this.stage.grains) return;
    this.stage.grains.setColour(this.grainColour.value);
    this.stage.wish();
    this.legends();
  }
  colourBodies() {
    if (!this.stage.bodies) return;
    this.stage.bodies.uniforms.uStress.value = this.bodyColour.value === "stress";
    this.stage.wish();
    this.legends();
  }
  legends() {
    const bars = [];
    const legend = (title, map, largest, unit) =>
      make("div", { class: "legend" }, make("div", { class: "scale", style: `background:${cssGradient(map)}` }),
        make("div", { class: "ends" }, make("span", {}, withUnit(largest, unit)), make("span", {}, title), make("span", {}, "0")));
    const colour = this.stage.grains?.colours().find((c) => c.name === this.grainColour.value);
    if (colour?.largest > 0) bars.push(legend(`grains, ${colour.name}`, kMaps.sand, colour.largest, colour.unit));
    if (this.bodyColour?.value === "stress") bars.push(legend("bodies, von Mises", kMaps.stress, this.run.bodies.stress, "Pa"));
    this.legend.replaceChildren(...bars);
  }

  showTime(t) {
    const { player, stage } = this;
    this.slider.value = String(Math.round((10000 * (t - player.start)) / (player.end - player.start || 1)));
    this.clock.textContent = `${t.toFixed(4)} s`;
    if (player.playing && ++this.frames % 2 === 0 && stage.suitRate(player.rate(), true)) player.drawn = [];
  }
  // Of a picture: title, time, legend and notes, in the picture itself. slow: so many seconds of it show one of the run.
  showCaption(t, slow = 0) {
    const { run } = this, place = document.getElementById("footfall-caption");
    if (!place) return;
    const words = [run.title, run.history ? `t = ${t.toFixed(run.digits ?? 3)} s` : "reference configuration", slow > 1.01 ? `slowed ${short(slow, 3)} times` : slow > 0 && slow < 0.99 ? `${short(1 / slow, 3)} times as fast` : ""];
    const arrows = this.stage.arrows?.largest > 0 && this.stage.arrows.object.visible ? [forcesText(this.stage.arrows.largest)] : [];
    place.replaceChildren(make("div", {}, words.filter(Boolean).join("   ")), ...[...(this.notes ?? []), ...arrows].map((text) => make("div", { class: "note" }, text)));
    if (this.legend && this.legend.parentElement !== place.parentElement) place.parentElement.append(this.legend);
  }
  showLoaded() {
    const share = this.stage.loaded();
    this.slider.style.setProperty("--loaded", `${100 * share}%`);
    document.getElementById("footfall-loading").hidden = share >= 1;
    document.getElementById("footfall-loading").textContent = `reading frames: ${Math.round(100 * share)} %`;
  }

  help() {
    const list = make("dl", {}, ...kKeys.flatMap(([key, what]) => [make("dt", {}, key), make("dd", {}, what)]));
    const hand = "One finger or the left button turns, two fingers or the right button move, a pinch or the wheel zooms. A click into a plot goes to that time; a drag zooms it, a double click goes back.";
    this.keys = make("div", { class: "keys", hidden: "", onclick: () => (this.keys.hidden = true) }, list, make("p", {}, hand));
    document.body.append(this.keys);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || /^(input|select|textarea)$/i.test(event.target.tagName) && event.target.type !== "range" && event.target.type !== "checkbox") return;
    const { player, stage } = this;
    const next = (select, change) => {
      if (!select) return;
      select.selectedIndex = (select.selectedIndex + 1) % select.options.length;
      change();
    };
    const faster = (by) => {
      this.speed.selectedIndex = Math.min(this.speed.options.length - 1, Math.max(0, this.speed.selectedIndex + by));
      player.speed = Number(this.speed.value);
    };
    const moveClip = (by) => {
      if (!this.clip) return;
      this.clipPlace.value = String(Number(this.clipPlace.value) + by);
      this.setClip({ share: Number(this.clipPlace.value) });
    };
    const actions = {
      " ": () => player.play(),
      ArrowLeft: () => player.step(-1),
      ArrowRight: () => player.step(1),
      Home: () => player.seek(player.start),
      End: () => player.seek(player.end),
      "+": () => faster(1),
      "=": () => faster(1),
      "-": () => faster(-1),
      c: () => next(this.clip, () => this.setClip({ axis: this.clip.value })),
      "[": () => moveClip(-0.02),
      "]": () => moveClip(0.02),
      f: () => Controls.flip(this.forces),
      g: () => next(this.grainColour, () => this.colourGrains()),
      b: () => next(this.bodyColour, () => this.colourBodies()),
      s: () => Controls.flip(this.smooth),
      1: () => this.views?.[0].click(),
      2: () => this.views?.[1].click(),
      3: () => this.views?.[2].click(),
      4: () => this.views?.[3].click(),
      5: () => this.views?.[4]?.click(),
      j: () => Controls.flip(this.symbols),
      n: () => Controls.flip(this.named),
      l: () => this.writeLink(),
      "?": () => (this.keys.hidden = !this.keys.hidden),
      Escape: () => (this.keys.hidden = true),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
