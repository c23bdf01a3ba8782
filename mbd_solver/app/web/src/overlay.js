// What lies over the picture as text and lines: axes and gravity in its corner, names of parts.
import * as three from "three";
import { inks } from "./colours.js";
import { dot } from "./shapes.js";
import { short } from "./units.js";

const kArm = 30;  // of an axis [pixels]
const kTold = 160;  // while it plays without a graphics card, the corner follows so often [ms]: to lay out and draw the page anew takes long
const kMostNames = 200, kLetter = 6.3, kLine = 12;  // width of a letter, height of a line [pixels]
const kFirst = ["joint", "drive", "strut", "spring", "force", "body"];

export class Overlay {
  constructor(place, stage) {
    this.stage = stage;
    this.corner = document.createElement("div");
    this.corner.className = "corner";
    this.labels = document.createElement("div");
    this.labels.className = "names";
    place.append(this.labels, this.corner);
    this.named = false;
    this.told = -Infinity;  // the corner, last [ms]
  }

  end() {
    this.labels.remove();
    this.corner.remove();
  }

  show() {
    this.showCorner();
    this.showNames();
  }

  showCorner() {
    const { camera, run } = this.stage, m = camera.matrixWorldInverse.elements;
    const seen = (v) => [m[0] * v[0] + m[4] * v[1] + m[8] * v[2], -(m[1] * v[0] + m[5] * v[1] + m[9] * v[2])];
    const arrows = [["x", [1, 0, 0], "#b3261e", kArm], ["y", [0, 1, 0], "#1f7a3d", kArm], ["z", [0, 0, 1], "#1d5fae", kArm]];
    const g = run.gravity ?? [0, 0, 0], size = Math.sqrt(dot(g, g));
    if (size > 0) arrows.push([`g ${short(size, 3)} m/s\u00b2`, g.map((v) => v / size), inks().ink, 1.3 * kArm]);
    const now = performance.now();
    if (this.stage.playing && this.stage.inSoftware && now - this.told < kTold) return;
    const key = arrows.map(([, v]) => seen(v).map((x) => x.toFixed(3))).join();
    if (key === this.cornerShown) return;
    this.cornerShown = key;
    this.told = now;
    // As text, which the browser reads as SVG.
    this.corner.innerHTML = `<svg viewBox="-60 -60 120 120">${arrows.map(([text, v, colour, reach]) => {
      const [x, y] = seen(v).map((c) => c * reach), l = Math.hypot(x, y) || 1, head = Math.min(7, 0.5 * l), ex = x / l, ey = y / l, nx = x - ex * head, ny = y - ey * head, w = 0.45 * head;
      const points = [[x, y], [nx - ey * w, ny + ex * w], [nx + ey * w, ny - ex * w]].map((p) => p.map((c) => c.toFixed(2)).join()).join(" ");
      return `<line x1="0" y1="0" x2="${nx}" y2="${ny}" stroke="${colour}" stroke-width="2"/><polygon points="${points}" fill="${colour}"/>` +
        `<text x="${x + 8 * ex}" y="${y + 9 * ey + 4}" fill="${colour}" text-anchor="middle">${text}</text>`;
    }).join("")}</svg>`;
  }

  // Names where the parts are; of two that would cover each other the first, by kFirst.
  showNames() {
    const { stage } = this;
    this.labels.hidden = !this.named || !stage.symbols;
    if (this.labels.hidden) return;
    const { clientWidth: width, clientHeight: height } = stage.place, point = new three.Vector3();
    const found = stage.symbols.names(stage.time, stage.smooth).sort((a, b) => kFirst.indexOf(a.kind) - kFirst.indexOf(b.kind)).slice(0, kMostNames), taken = [];
    while (this.labels.childElementCount > found.length) this.labels.lastChild.remove();
    found.forEach(({ text, kind, place }, i) => {
      const label = this.labels.children[i] ?? this.labels.appendChild(document.createElement("span"));
      point.set(...place).project(stage.camera);
      label.textContent = text;
      label.className = kind;
      const x = ((point.x + 1) * width) / 2 + 6, y = ((1 - point.y) * height) / 2, right = x + kLetter * text.length;
      const free = point.z <= 1 && !taken.some((other) => x < other.right && other.x < right && Math.abs(y - other.y) < kLine);
      label.hidden = !free;
      if (free) taken.push({ x, y, right });
      label.style.transform = `translate(${x}px,${y - 0.5 * kLine}px)`;
    });
  }
}
