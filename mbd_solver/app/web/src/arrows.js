// The force of the ground on each body, from the history or else from the drawings, drawn over everything where its line of action is
// nearest to the body's origin: p = x + F x M / F^2. Lengths go with the root of the force, so that small ones are seen next to a first peak.
import * as three from "three";
import { valueAt } from "./page.js";
import { cross, dot, length, plus, unit } from "./shapes.js";
import { Solids } from "./solids.js";

const kColour = "#c2006b";
const kLength = 0.22;  // of the picture's size, for the largest force of the run
const kShown = 1e-4;   // of the largest force

export class Arrows {
  // `names`: of the bodies, by their number; marks: of marks.js, or none. `size`: of what is drawn [m].
  constructor(history, names, size, marks) {
    Object.assign(this, { history, marks });
    this.solids = new Solids({ above: true });
    this.object = new three.Group().add(this.solids.object);
    this.entries = [];
    this.rows = 0;  // of the history, that `largest` knows
    names.forEach((name, body) => {
      const columns = (list) => list.map((c) => history.columns.get(`${name}.${c}`)?.values), mark = marks?.index("body", name) ?? -1;
      const force = columns(["contact.fx", "contact.fy", "contact.fz"]), moment = columns(["contact.mx", "contact.my", "contact.mz"]);
      if (!force.every(Boolean) && mark < 0) return;
      this.entries.push({ body, mark, force, moment, place: columns(["x", "y", "z"]) });
    });
    this.largest = 0;
    this.grow();
    this.longest = kLength * size;
    this.width = 0.017 * size;
  }

  // The largest force, with rows and frames that have come.
  grow() {
    const { history, marks } = this, first = this.rows;
    this.rows = history.time.length;
    for (const { force, mark } of this.entries)
      if (force.every(Boolean)) {
        for (let k = first; k < this.rows; ++k) this.largest = Math.max(this.largest, Math.hypot(force[0][k], force[1][k], force[2][k]));
      } else {
        for (let k = 0; k < marks.times.length; ++k) this.largest = Math.max(this.largest, length(marks.vector(mark, 2, { k, next: k, mix: 0 })));
      }
  }

  // `centre(body)`: where a body is whose place nothing else holds.
  show(t, centre, smooth = true) {
    this.solids.begin();
    if (this.object.visible)
      for (const { body, mark, force, moment, place } of this.entries) {
        const at = (columns) => columns.map((column) => valueAt(this.history, column, t)), now = this.marks?.moment(t, smooth);
        const f = force.every(Boolean) ? at(force) : this.marks.vector(mark, 2, now), size = length(f);
        if (!(size > kShown * this.largest)) continue;
        const x = mark >= 0 ? this.marks.vector(mark, 0, now) : place.every(Boolean) ? at(place) : centre(body);
        if (x === null) continue;
        const m = force.every(Boolean) ? (moment.every(Boolean) ? at(moment) : null) : this.marks.vector(mark, 3, now);
        const from = m ? plus(x, cross(f, m), 1 / dot(f, f)) : x;
        this.solids.arrow(from, plus(from, unit(f), this.longest * Math.sqrt(size / this.largest)), this.width, kColour);
      }
    this.solids.finish();
  }
}
