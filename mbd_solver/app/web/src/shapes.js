// Tubes, cones and balls between two points, for what draws them: the shaders of solids.js, or the facets of a picture (picture.js).

// Rows of a profile: place along the axis (0 ... 1), share of the radius. Rings of points, and triangles between them, few: a software renderer
// takes longer over a triangle than over its pixels.
function solid(kSides, rows) {
  const points = [], corners = [];
  for (const [z, radius] of rows)
    for (let k = 0; k < kSides; ++k) points.push([radius * Math.cos((2 * Math.PI * k) / kSides), radius * Math.sin((2 * Math.PI * k) / kSides), z]);
  for (let row = 0; row + 1 < rows.length; ++row)
    for (let k = 0; k < kSides; ++k) {
      const a = row * kSides + k, b = row * kSides + ((k + 1) % kSides);
      if (rows[row][1] > 0) corners.push(a, b, a + kSides);
      if (rows[row + 1][1] > 0) corners.push(b, b + kSides, a + kSides);
    }
  return { sides: kSides, rows, points, corners };
}
export const kShapes = {
  tube: solid(8, [[0, 0], [0, 1], [1, 1], [1, 0]]),
  pipe: solid(5, [[0, 1], [1, 1]]),  // open, of a line
  ball: solid(8, [0, 1, 2, 3, 4].map((k) => [(1 - Math.cos((Math.PI * k) / 4)) / 2, k % 4 === 0 ? 0 : Math.sin((Math.PI * k) / 4)])),
};

const kTints = new Map();
export function tintOf(colour) {
  if (!kTints.has(colour)) kTints.set(colour, [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16) / 255));
  return kTints.get(colour);
}

export const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const unit = (a, otherwise = [0, 0, 1]) => {
  const l = length(a);
  return l > 1e-12 ? [a[0] / l, a[1] / l, a[2] / l] : otherwise;
};
export const between = (a, b, s) => [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])];
export const across = (a) => unit(cross(a, Math.abs(a[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));

export class Shapes {
  // kindOf(shape): what collects the solids of this shape, with add(from, to, r0, r1, tint) [m; 0 ... 1].
  constructor(kindOf) {
    this.tubes = kindOf(kShapes.tube);
    this.pipes = kindOf(kShapes.pipe);
    this.balls = kindOf(kShapes.ball);
  }
  begin() {}
  finish() {}
  tube(a, b, radius, colour) {
    this.tubes.add(a, b, radius, radius, tintOf(colour));
  }
  cone(a, b, r0, r1, colour) {
    this.tubes.add(a, b, r0, r1, tintOf(colour));
  }
  ball(c, radius, colour) {
    this.balls.add([c[0], c[1], c[2] - radius], [c[0], c[1], c[2] + radius], radius, radius, tintOf(colour));
  }
  line(points, radius, colour) {
    for (let k = 0; k + 1 < points.length; ++k) this.pipes.add(points[k], points[k + 1], radius, radius, tintOf(colour));
  }
  // `width`: of the head.
  arrow(from, to, width, colour) {
    const way = minus(to, from), size = length(way);
    if (!(size > 0)) return;
    const head = Math.min(2.4 * width, 0.6 * size), neck = between(from, to, 1 - head / size), r = (0.5 * width * head) / (2.4 * width);
    this.tube(from, neck, 0.36 * r, colour);
    this.cone(neck, to, r, 0, colour);
  }
  // Part of a circle about an axis, from the direction `x`, with a head. turns: of a whole circle, signed.
  arc(centre, axis, radius, turns, width, colour, headed = true) {
    const x = across(axis), y = cross(axis, x), n = 12, points = [];
    for (let k = 0; k <= n; ++k) {
      const angle = (2 * Math.PI * turns * k) / n;
      points.push(plus(plus(centre, x, radius * Math.cos(angle)), y, radius * Math.sin(angle)));
    }
    this.line(headed ? points.slice(0, n - 1) : points, 0.3 * width, colour);
    if (headed) this.cone(points[n - 2], points[n], width, 0, colour);
  }
}
