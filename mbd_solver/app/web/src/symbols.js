// Symbols of joints, struts, springs, drives, gears and forces, the brackets that hold them to their bodies, and tracks of points.
import { across, between, cross, dot, length, minus, plus, unit } from "./shapes.js";

const kColour = {
  joint: "#1f4e79", axis: "#5b8db8", bracket: "#8b95a1", ground: "#6b6257", strut: "#5a6673", gas: "#56b4e9", mr: "#8e5bd0", honeycomb: "#d6a419",
  spring: "#e08a1e", table: "#5a6673", stops: "#5a6673", drive: "#c2006b", gear: "#00857c", force: "#d1272b", cable: "#2b2b2b", track: "#d55e00", mass: "#333f4c",
};
const kUnit = 0.009;     // of the mechanism's size: half the width of a joint
const kAxisReach = 5;    // of an axis beyond its joint, in such units

// What can be switched, with its kinds of marks.
export const kLayers = [
  { name: "struts", text: "struts, springs, cables", kinds: ["strut", "spring", "cable"], on: true },
  { name: "joints", text: "joints", kinds: ["joint"], on: true },
  { name: "drives", text: "drives, gears", kinds: ["drive", "gear"], on: true },
  { name: "forces", text: "given forces", kinds: ["force"], on: true },
  { name: "brackets", text: "brackets to bodies", kinds: [], on: true },
];

export class Symbols {
  // bodies: of surface.js, or none. up: against gravity. solids, tracks: Shapes that take the symbols, and the track of a point.
  constructor(marks, bodies, bodyNames, size, up, solids, tracks) {
    Object.assign(this, { marks, bodies, up, solids, tracks });
    this.u = kUnit * size;
    this.object = { visible: true };
    this.on = Object.fromEntries(kLayers.map(({ name, on }) => [name, on]));
    this.layerOf = Object.fromEntries(kLayers.flatMap(({ name, kinds }) => kinds.map((kind) => [kind, name])));
    this.bodyNumber = new Map(bodyNames.map((name, i) => [name, i]));
    const first = { k: 0, next: 0, mix: 0 };
    this.lengths = marks.list.map((_, i) => length(minus(marks.vector(i, 1, first), marks.vector(i, 0, first))));
    this.largest = { force: this.largestOf("force", 2), torque: this.largestOf("force", 3), drive: this.largestOf("drive", 2) };
    this.findBrackets(first);
  }
  layers() {
    const kinds = new Set(this.marks.list.map((mark) => mark.kind));
    return kLayers.filter((layer) => (layer.name === "brackets" ? this.brackets.length > 0 : layer.kinds.some((kind) => kinds.has(kind))));
  }
  largestOf(kind, v) {
    let largest = 0;
    this.marks.list.forEach((mark, i) => {
      if (mark.kind !== kind) return;
      for (let k = 0; k < this.marks.times.length; ++k) largest = Math.max(largest, length(this.marks.vector(i, v, { k, next: k, mix: 0 })));
    });
    return largest;
  }

  // The scales of arrows, of one more frame.
  grow() {
    const k = this.marks.times.length - 1, moment = { k, next: k, mix: 0 };
    this.marks.list.forEach((mark, i) => {
      const most = (name, v) => (this.largest[name] = Math.max(this.largest[name], length(this.marks.vector(i, v, moment))));
      if (mark.kind === "force") most("force", 2), most("torque", 3);
      if (mark.kind === "drive") most("drive", 2);
    });
    if (this.track) this.setTrack(this.track);
  }

  // From each end of a mark to its body where the drawing of the body does not reach it: to the nearest point of its surface, or to its
  // mass centre where it has no drawing.
  findBrackets(first) {
    this.brackets = [];
    const seen = new Set();
    this.marks.list.forEach((mark, i) => {
      if (mark.kind === "body" || mark.kind === "gear" || mark.kind === "drive") return;
      mark.bodies.forEach((name, end) => {
        const p = this.marks.vector(i, end, first), key = `${name} ${p.map((x) => Math.round(x / (0.1 * this.u)))}`;
        if (seen.has(key)) return;
        seen.add(key);
        if (name === "ground") {
          this.brackets.push({ mark: i, end, ground: true });
          return;
        }
        const near = this.bodies?.nearest(this.bodyNumber.get(name), p);
        if (near) {
          if (near.gap > 0.3 * this.u) this.brackets.push({ mark: i, end, near });
          return;
        }
        const centre = this.marks.index("body", name);
        if (centre >= 0 && length(minus(p, this.marks.vector(centre, 0, first))) > 0.3 * this.u) this.brackets.push({ mark: i, end, centre });
      });
    });
    this.hidden = this.marks.list.flatMap((mark, i) => (mark.kind === "body" && !this.bodies?.has(this.bodyNumber.get(mark.name)) ? [i] : []));
  }

  show(t, smooth) {
    const { solids, marks, u } = this, moment = marks.moment(t, smooth);
    solids.begin();
    if (this.object.visible) {
      for (const i of this.hidden) solids.ball(marks.vector(i, 0, moment), 1.5 * u, kColour.mass);
      if (this.on.brackets) for (const bracket of this.brackets) this.bracket(bracket, moment);
      marks.list.forEach((mark, i) => {
        if (this.on[this.layerOf[mark.kind]]) this[mark.kind]?.(mark, i, [0, 1, 2, 3].map((v) => marks.vector(i, v, moment)));
      });
    }
    solids.finish();
    this.showTrack(moment, t);
  }

  bracket({ mark, end, ground, near, centre }, moment) {
    const { solids, marks, u } = this, p = marks.vector(mark, end, moment);
    if (ground) {
      const foot = plus(p, this.up, -2.4 * u);
      solids.cone(foot, p, 1.3 * u, 0.3 * u, kColour.ground);
      solids.tube(plus(foot, this.up, -0.3 * u), foot, 1.9 * u, kColour.ground);
    } else {
      solids.tube(p, near ? this.bodies.place(near) : marks.vector(centre, 0, moment), 0.45 * u, kColour.bracket);
    }
  }

  // ---- joints: the axis is thin, what turns or slides about it thick
  axis(p, z, reach = kAxisReach) {
    this.solids.tube(plus(p, z, -reach * this.u), plus(p, z, reach * this.u), 0.16 * this.u, kColour.axis);
  }
  barrel(p, z, half, radius, colour = kColour.joint) {
    this.solids.tube(plus(p, z, -half * this.u), plus(p, z, half * this.u), radius * this.u, colour);
  }
  joint({ type }, i, [a, b, axis, axis2]) {
    const { solids, u } = this, p = between(a, b, 0.5), z = unit(axis), x = unit(axis2, across(z));
    const draw = {
      fixed: () => this.barrel(p, z, 0.8, 1.1),
      spherical: () => solids.ball(p, 1.4 * u, kColour.joint),
      universal: () => {
        for (const axis of [z, x]) {
          this.axis(p, axis, 3.4);
          this.barrel(p, axis, 2, 0.75);
        }
      },
      constant_velocity: () => {
        solids.ball(p, 1.2 * u, kColour.joint);
        for (const axis of [z, x]) this.axis(p, axis, 3.4);
      },
      revolute: () => {
        this.axis(p, z);
        this.barrel(p, z, 1.8, 1.1);
      },
      cylindrical: () => {
        this.axis(p, z);
        this.barrel(p, z, 2.6, 0.9);
      },
      prismatic: () => {
        this.axis(p, z);
        for (const s of [-1.3, 1.3]) this.barrel(plus(p, z, s * u), z, 0.45, 1.35);
      },
      planar: () => {
        this.axis(p, z, 3);
        this.barrel(p, z, 0.15, 3.2);
      },
      prescribed: () => {
        this.axis(p, z, 4);
        this.barrel(p, z, 1.4, 1.2, kColour.drive);
      },
      distance: () => {
        for (const end of [a, b]) solids.ball(end, 0.9 * u, kColour.joint);
        solids.tube(a, b, 0.4 * u, kColour.joint);
      },
      point_on_plane: () => {
        const foot = plus(b, z, -dot(minus(b, a), z));
        solids.ball(b, 1.1 * u, kColour.joint);
        this.barrel(foot, z, 0.15, 3.2);
      },
      rolling: () => this.solids.tube(plus(b, x, -0.25 * u), plus(b, x, 0.25 * u), length(axis2), kColour.axis),
      rolling_ball: () => solids.ball(b, 1.1 * u, kColour.joint),
    };
    (draw[type] ?? draw.fixed)();
  }

  // ---- a strut: a rod between its ends, and a sleeve in the colours of its laws; a spring is wound about it
  strut({ type }, i, [a, b]) {
    const { solids, u } = this, laws = type.split("+"), e = unit(minus(b, a)), first = this.lengths[i];
    for (const end of [a, b]) solids.ball(end, 0.8 * u, kColour.strut);
    solids.tube(a, b, 0.34 * u, kColour.strut);
    const sleeves = laws.filter((law) => ["gas", "mr", "honeycomb", "table"].includes(law));
    if (sleeves.length === 0 && laws.length === 1 && laws[0] === "stops") sleeves.push("stops");
    const size = Math.min(0.34 * first, 10 * u);
    sleeves.forEach((law, k) => {
      const from = 0.16 * first + (k * size) / sleeves.length, to = from + size / sleeves.length;
      solids.tube(plus(a, e, from), plus(a, e, to), 1.25 * u, kColour[law]);
    });
    if (laws.includes("spring")) this.coil(a, b, sleeves.length > 0 ? 1.7 : 1.1);
  }
  coil(a, b, width) {
    const { solids, u } = this, e = unit(minus(b, a)), x = across(e), y = cross(e, x), turns = 7, steps = 8, points = [a];
    for (let k = 0; k <= turns * steps; ++k) {
      const angle = (2 * Math.PI * k) / steps;
      points.push(plus(plus(between(a, b, 0.1 + (0.8 * k) / (turns * steps)), x, width * u * Math.cos(angle)), y, width * u * Math.sin(angle)));
    }
    solids.line([...points, b], 0.2 * u, kColour.spring);
  }
  // One mark per straight part.
  cable(mark, i, [a, b]) {
    this.solids.tube(a, b, 0.22 * this.u, kColour.cable);
  }
  spring({ type }, i, [a, b, axis]) {
    const { solids, u } = this, p = between(a, b, 0.5), z = unit(axis);
    if (type === "torsion") for (let k = 0; k < 3; ++k) solids.arc(plus(p, z, (k - 1) * 0.7 * u), z, (1.9 + 0.15 * k) * u, 0.96, 0.6 * u, kColour.spring, false);
    if (type === "centring") for (const axis of [z, across(z)]) solids.arc(p, axis, 1.9 * u, 1, 0.6 * u, kColour.spring, false);
    if (type === "bushing") {
      for (const s of [-0.9, 0, 0.9]) this.barrel(plus(p, z, s * u), z, 0.28, 1.7, kColour.spring);
      solids.tube(a, b, 0.3 * u, kColour.spring);
    }
  }

  drive({ type }, i, [a, b, effort, axis]) {
    const { solids, u } = this, p = between(a, b, 0.5), z = unit(axis), value = dot(effort, z);
    const share = this.largest.drive > 0 ? value / this.largest.drive : 0, sign = value < 0 ? -1 : 1;
    if (type === "turns") {
      solids.arc(p, z, 3 * u, sign * (0.35 + 0.5 * Math.abs(share)), 0.8 * u, kColour.drive);
    } else {
      const side = plus(p, across(z), 2 * u);
      solids.arrow(plus(side, z, -sign * 2 * u), plus(side, z, sign * (2 + 5 * Math.abs(share)) * u), 1.5 * u, kColour.drive);
    }
  }
  gear({ type }, i, [p, next, axis, numbers]) {
    const { solids, u } = this, z = unit(axis), x = across(z), y = cross(z, x), turns = numbers[1] > 0.5, n = 10;
    const way = minus(next, p), dashes = Math.max(1, Math.round(length(way) / (3 * u)));
    for (let k = 0; k < dashes; ++k) solids.tube(plus(p, way, (k + 0.25) / dashes), plus(p, way, (k + 0.75) / dashes), 0.16 * u, kColour.gear);
    if (!turns) {
      this.barrel(p, z, 3.2, 0.5, kColour.gear);
      return;
    }
    this.barrel(p, z, 0.3, 2, kColour.gear);
    for (let k = 0; k < n; ++k) {
      const e = plus([0, 0, 0].map((_, j) => x[j] * Math.cos((2 * Math.PI * k) / n)), y, Math.sin((2 * Math.PI * k) / n));
      solids.tube(plus(p, e, 1.9 * u), plus(p, e, 2.6 * u), 0.32 * u, kColour.gear);
    }
  }
  force({ type }, i, [p, , f, m]) {
    const { solids, u, largest } = this, size = length(f), moment = length(m);
    if (largest.force > 0 && size > 1e-3 * largest.force) {
      const e = unit(f);
      solids.arrow(plus(p, e, -(4 + 16 * (size / largest.force)) * u), p, 1.9 * u, kColour.force);
    }
    if (largest.torque > 0 && moment > 1e-3 * largest.torque) solids.arc(p, unit(m), 3.4 * u, 0.3 + (0.5 * moment) / largest.torque, 0.8 * u, kColour.force);
    if (largest.force === 0 && largest.torque === 0) solids.ball(p, 0.8 * u, kColour.force);
  }

  // ---- tracks and names
  // A point that can be followed, as "body:NAME" or "joint:NAME"; "": none.
  setTrack(name) {
    this.track = this.marks.byName.has(name) ? name : "";
    this.way = this.track ? this.marks.way(this.marks.byName.get(this.track)) : [];
  }
  // Bright until now, thin for what is to come.
  showTrack(moment) {
    const { tracks, u } = this;
    tracks.begin();
    if (this.track) {
      const now = this.marks.vector(this.marks.byName.get(this.track), 0, moment);
      tracks.line([...this.way.slice(0, moment.k + 1), now], 0.34 * u, kColour.track);
      tracks.line([now, ...this.way.slice(moment.k + 1)], 0.14 * u, kColour.track);
      tracks.ball(now, 0.9 * u, kColour.track);
    }
    tracks.finish();
  }
  // Names and places of what is drawn.
  names(t, smooth) {
    const moment = this.marks.moment(t, smooth);
    return this.marks.list.flatMap((mark, i) => {
      if (mark.kind === "gear" || (mark.kind !== "body" && !this.on[this.layerOf[mark.kind]])) return [];
      return [{ text: mark.name, kind: mark.kind, place: between(this.marks.vector(i, 0, moment), this.marks.vector(i, 1, moment), 0.5) }];
    });
  }
}
