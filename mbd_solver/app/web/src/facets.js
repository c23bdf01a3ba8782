// Facets of the mechanism as polygons of one colour in the picture of painter.js. A software renderer takes microseconds over a triangle, the
// processor less than one over a facet. Facets that face away are left out: tubes and balls are closed by themselves or by what they meet.
import { lightOn } from "./shading.js";

export const kDepths = 16383;  // steps from the nearest to the farthest thing of a picture; 0 is nothing

export class Facets {
  constructor() {
    this.points = new Float64Array(1 << 15);  // of all corners: x, y [pixels], 1 / depth [1/m]
    this.firsts = new Uint32Array(1 << 12);   // corner of each facet, and the end of the last
    this.colours = new Int32Array(1 << 12);   // of each facet: 6 bits of red, green and blue from bit 14 on
    this.corners = Array.from({ length: 64 }, () => new Float64Array(3));  // of one solid, in the eye's axes [m]
    this.polygon = [];
  }

  // width, height of the picture [pixels].
  begin(camera, width, height) {
    this.V = camera.matrixWorldInverse.elements;
    this.near = camera.near;
    this.perPixel = camera.projectionMatrix.elements[5] * 0.5 * height;  // pixels of a metre at the distance of one metre
    Object.assign(this, { width, height, count: 0, used: 0, nearest: Infinity, farthest: 0, left: width, right: 0, bottom: height, top: 0 });
    this.whole = true;  // false: something reaches behind the eye, which is left to the shaders
  }
  toEye(x, y, z, to) {
    const V = this.V;
    to[0] = V[0] * x + V[4] * y + V[8] * z + V[12];
    to[1] = V[1] * x + V[5] * y + V[9] * z + V[13];
    to[2] = V[2] * x + V[6] * y + V[10] * z + V[14];
  }

  // Corners in the eye's axes, counterclockwise seen from outside; tint: red, green, blue, 0 ... 1. bothSides: seen from either.
  add(corners, tint, bothSides = false) {
    const n = corners.length;
    if (3 * (this.used + n) > this.points.length) this.points = Facets.grown(this.points);
    if (this.count + 2 > this.firsts.length) [this.firsts, this.colours] = [Facets.grown(this.firsts), Facets.grown(this.colours)];
    const { points } = this;
    let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity, nearest = Infinity, farthest = 0;
    for (let k = 0, j = 3 * this.used; k < n; ++k, j += 3) {
      const c = corners[k], depth = -c[2];
      if (depth < this.near) {
        this.whole = false;
        return;
      }
      const scale = this.perPixel / depth, x = (points[j] = 0.5 * this.width + scale * c[0]), y = (points[j + 1] = 0.5 * this.height + scale * c[1]);
      points[j + 2] = 1 / depth;
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < bottom) bottom = y;
      if (y > top) top = y;
      if (depth < nearest) nearest = depth;
      if (depth > farthest) farthest = depth;
    }
    if (right < 0 || top < 0 || left > this.width || bottom > this.height) return;
    let area = 0;
    for (let k = 0, j = 3 * this.used, last = j + 3 * (n - 1); k < n; ++k, last = j, j += 3) area += points[last] * points[j + 1] - points[j] * points[last + 1];
    if (bothSides ? area === 0 : area <= 0) return;
    // The normal, from two diagonals of a quadrangle or two sides of a triangle.
    const a = corners[0], b = corners[1], c = corners[n >> 1], d = corners[n === 3 ? 2 : (n >> 1) + 1], e = n === 3 ? a : b;
    const ux = (n === 3 ? b[0] : c[0]) - a[0], uy = (n === 3 ? b[1] : c[1]) - a[1], uz = (n === 3 ? b[2] : c[2]) - a[2];
    const vx = d[0] - e[0], vy = d[1] - e[1], vz = d[2] - e[2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, size = (z < 0 ? -1 : 1) * (Math.sqrt(x * x + y * y + z * z) || 1);
    const light = 63 * lightOn(x / size, y / size, z / size);
    this.colours[this.count] = (Math.round(tint[0] * light) << 26) | (Math.round(tint[1] * light) << 20) | (Math.round(tint[2] * light) << 14);
    this.firsts[this.count] = this.used;
    this.used += n;
    this.firsts[++this.count] = this.used;
    this.left = Math.min(this.left, left);
    this.right = Math.max(this.right, right);
    this.bottom = Math.min(this.bottom, bottom);
    this.top = Math.max(this.top, top);
    this.nearest = Math.min(this.nearest, nearest);
    this.farthest = Math.max(this.farthest, farthest);
  }
  static grown(array) {
    const larger = new array.constructor(2 * array.length);
    larger.set(array);
    return larger;
  }

  // A solid of revolution from a to b [m, in W] as the shaders of solids.js and bodies.js lay it. rows: place along the axis (0 ... 1) and share of the
  // radius; radii r0, r1 at both ends [m].
  solid(ax, ay, az, bx, by, bz, r0, r1, sides, rows, tint) {
    const { V, corners, polygon } = this;
    let x = bx - ax, y = by - ay, z = bz - az + 1e-12;
    const l = Math.hypot(x, y, z);
    x /= l;
    y /= l;
    z /= l;
    const steep = Math.abs(z) >= 0.9, h = steep ? Math.hypot(y, z) : Math.hypot(x, y);
    const sx = steep ? 0 : y / h, sy = (steep ? z : -x) / h, sz = steep ? -y / h : 0;  // axis x (1, 0, 0), else axis x (0, 0, 1)
    const tx = y * sz - z * sy, ty = z * sx - x * sz, tz = x * sy - y * sx;
    const ex = V[0] * sx + V[4] * sy + V[8] * sz, ey = V[1] * sx + V[5] * sy + V[9] * sz, ez = V[2] * sx + V[6] * sy + V[10] * sz;
    const fx = V[0] * tx + V[4] * ty + V[8] * tz, fy = V[1] * tx + V[5] * ty + V[9] * tz, fz = V[2] * tx + V[6] * ty + V[10] * tz;
    const centre = corners[63], turns = Facets.turns(sides);
    rows.forEach(([place, share], row) => {
      this.toEye(ax + place * (bx - ax), ay + place * (by - ay), az + place * (bz - az), centre);
      const r = share * (r0 + place * (r1 - r0));
      for (let k = 0; k < sides; ++k) {
        const c = r * turns[2 * k], s = r * turns[2 * k + 1], to = corners[row * sides + k];
        to[0] = centre[0] + c * ex + s * fx;
        to[1] = centre[1] + c * ey + s * fy;
        to[2] = centre[2] + c * ez + s * fz;
      }
    });
    for (let row = 0; row + 1 < rows.length; ++row) {
      const first = row * sides, flat = rows[row][0] === rows[row + 1][0];
      if (flat) {  // an end: its ring, at the start in the other sense
        const start = rows[row][1] === 0, ring = start ? first + sides : first;
        if ((start ? r0 : r1) === 0) continue;
        polygon.length = sides;
        for (let k = 0; k < sides; ++k) polygon[k] = corners[ring + (start ? sides - 1 - k : k)];
        this.add(polygon, tint);
        continue;
      }
      polygon.length = 4;
      for (let k = 0; k < sides; ++k) {
        const next = (k + 1) % sides;
        polygon[0] = corners[first + k];
        polygon[1] = corners[first + next];
        polygon[2] = corners[first + sides + next];
        polygon[3] = corners[first + sides + k];
        this.add(polygon, tint);
      }
    }
  }
  // Cosine and sine of the corners of a ring.
  static turns(sides) {
    Facets.known ??= new Map();
    if (!Facets.known.has(sides)) Facets.known.set(sides, Float64Array.from({ length: 2 * sides }, (_, k) => (k % 2 ? Math.sin : Math.cos)((2 * Math.PI * (k >> 1)) / sides)));
    return Facets.known.get(sides);
  }

  // Into a picture of the painter: where a facet is nearer than what the pixel shows. A plane is straight in 1 / depth over the picture.
  fill(pixels, nearest, step) {
    const { points, firsts, colours, width, height } = this;
    for (let f = 0; f < this.count; ++f) {
      const first = 3 * firsts[f], end = 3 * firsts[f + 1];
      let bottom = Infinity, top = -Infinity;
      for (let j = first; j < end; j += 3) {
        if (points[j + 1] < bottom) bottom = points[j + 1];
        if (points[j + 1] > top) top = points[j + 1];
      }
      // w = w0 + wx x + wy y, from the triangle of the fan that has the largest area.
      const x0 = points[first], y0 = points[first + 1], w0 = points[first + 2];
      let largest = 0, wx = 0, wy = 0;
      for (let j = first + 3; j + 3 < end; j += 3) {
        const px = points[j] - x0, py = points[j + 1] - y0, pw = points[j + 2] - w0, qx = points[j + 3] - x0, qy = points[j + 4] - y0, qw = points[j + 5] - w0;
        const area = px * qy - py * qx;
        if (Math.abs(area) <= largest) continue;
        largest = Math.abs(area);
        wx = (pw * qy - qw * py) / area;
        wy = (px * qw - qx * pw) / area;
      }
      const last = Math.min(height - 1, Math.ceil(top - 0.5) - 1), colour = colours[f];
      for (let v = Math.max(0, Math.ceil(bottom - 0.5)); v <= last; ++v) {
        const y = v + 0.5;
        let left = Infinity, right = -Infinity;
        for (let j = first, i = end - 3; j < end; i = j, j += 3) {
          const ya = points[i + 1], yb = points[j + 1];
          if (ya <= y === yb <= y) continue;
          const x = points[i] + ((y - ya) / (yb - ya)) * (points[j] - points[i]);
          if (x < left) left = x;
          if (x > right) right = x;
        }
        const stop = Math.min(width - 1, Math.ceil(right - 0.5) - 1), begin = Math.max(0, Math.ceil(left - 0.5));
        let w = w0 + wx * (begin + 0.5 - x0) + wy * (y - y0);
        for (let k = v * width + begin; k <= v * width + stop; ++k, w += wx) {
          const depth = Math.min(kDepths, Math.max(1, 1 + (((1 / w - nearest) / step) | 0))), there = pixels[k] & kDepths;
          if (there === 0 || depth < there) pixels[k] = colour | depth;
        }
      }
    }
  }
}
