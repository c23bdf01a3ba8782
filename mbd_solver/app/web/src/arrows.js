// The force of the ground on each body, as the history has it, drawn over everything at the body.
import * as three from "three";
import { valueAt } from "./page.js";

const kColour = 0xc2006b;
const kLength = 0.28;  // of the picture's size, for the largest force of the run
const kShown = 0.004;  // of the largest force

export class Arrows {
  // `names`: of the bodies, by their number. `size`: of what is drawn [m].
  constructor(history, names, size) {
    this.history = history;
    this.object = new three.Group();
    this.entries = [];
    let largest = 0;
    names.forEach((name, body) => {
      const force = ["fx", "fy", "fz"].map((c) => history.columns.get(`${name}.contact.${c}`)?.values);
      if (!force.every(Boolean)) return;
      for (let k = 0; k < history.time.length; ++k) largest = Math.max(largest, Math.hypot(force[0][k], force[1][k], force[2][k]));
      const arrow = new three.ArrowHelper(new three.Vector3(0, 0, 1), new three.Vector3(), 1, kColour);
      for (const part of [arrow.line, arrow.cone]) {
        part.material.depthTest = false;
        part.material.toneMapped = false;
        part.renderOrder = 10;
      }
      this.object.add(arrow);
      this.entries.push({ body, force, arrow, place: ["x", "y", "z"].map((c) => history.columns.get(`${name}.${c}`)?.values) });
    });
    this.largest = largest;
    this.perNewton = largest > 0 ? (kLength * size) / largest : 0;
    this.head = 0.02 * size;
  }

  // `centre(body)`: where a body is whose place the history does not hold.
  show(t, centre) {
    if (!this.object.visible) return;
    for (const { body, force, arrow, place } of this.entries) {
      const f = new three.Vector3(...force.map((column) => valueAt(this.history, column, t)));
      const x = place.every(Boolean) ? place.map((column) => valueAt(this.history, column, t)) : centre(body);
      const size = f.length();
      arrow.visible = x !== null && this.perNewton > 0 && size > kShown * this.largest;
      if (!arrow.visible) continue;
      const length = this.perNewton * size;
      arrow.position.set(...x);
      arrow.setDirection(f.divideScalar(size));
      arrow.setLength(length, Math.min(this.head, 0.4 * length), Math.min(0.6 * this.head, 0.25 * length));
    }
  }
}
