// The mechanism as it was drawn: triangles, and lines as tubes, at frames of the run. Shaders (bodies.js) or facets show it.
import { SeriesDecoder, joinPlanes } from "./decode.js";
import { indexBefore, takeChunk } from "./page.js";
import { bodyColours, kMaps } from "./colours.js";
import { tintOf } from "./shapes.js";

export const kTubeSides = 8;
const kMark = 0.62;  // how dark marks of turning are

// Colours of stresses, from none to the largest, as colourOf in shading.js finds them.
const kStresses = Array.from({ length: 256 }, (_, i) => {
  const { shares, stops } = kMaps.stress, share = i / 255;
  let k = 1;
  while (k < shares.length - 1 && share > shares[k]) ++k;
  const m = (share - shares[k - 1]) / (shares[k] - shares[k - 1]);
  return stops[k].map((c, rgb) => (stops[k - 1][rgb] + m * (c - stops[k - 1][rgb])) / 255);
});

// Eigenvectors of a symmetric 3 x 3 matrix by Jacobi's rotations, with their values.
function eigen(m) {
  const a = m.map((r) => [...r]), v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 12; ++sweep)
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(a[p][q]) < 1e-300) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]), c = Math.cos(angle), s = Math.sin(angle);
      for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  return [0, 1, 2].map((k) => ({ value: a[k][k], axis: v.map((r) => r[k]) }));
}

// Weights of the corners of a triangle, or of the ends of a line, at the point that is nearest to p (Ericson, Real-Time Collision Detection 5.1.5).
function weightsOfNearest(corners, p) {
  const from = (a, b) => b.map((x, k) => x - a[k]), dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const share = (a, b) => Math.min(1, Math.max(0, dot(from(a, b), from(a, p)) / (dot(from(a, b), from(a, b)) || 1)));
  const [a, b, c] = corners;
  if (corners.length === 2) return [1 - share(a, b), share(a, b)];
  const ab = from(a, b), ac = from(a, c), ap = from(a, p), bp = from(b, p), cp = from(c, p);
  const d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2, sum = va + vb + vc;
  if (va > 0 && vb > 0 && vc > 0) return [va / sum, vb / sum, vc / sum];
  const edges = [[0, 1], [1, 2], [2, 0]].map(([i, j]) => {
    const s = share(corners[i], corners[j]), x = corners[i].map((v, k) => v + s * (corners[j][k] - v));
    return { i, j, s, distance: Math.hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) };
  });
  const { i, j, s } = edges.reduce((least, edge) => (edge.distance < least.distance ? edge : least)), weights = [0, 0, 0];
  weights[i] += 1 - s;
  weights[j] += s;
  return weights;
}

export class Surface {
  // spec: run.bodies; prefix: of its chunks; colour: of all bodies, or none.
  constructor(spec, names, prefix = "", colour = null) {
    Object.assign(this, { spec, prefix });
    this.colours = colour ? names.map(() => colour) : bodyColours(names);
    this.times = spec.times;
    this.frames = [];
    this.shown = [0, 0];
    this.mix = 0;
  }

  async loadFirst() {
    const static32 = async (name, Kind) => joinPlanes(await takeChunk(`${this.prefix}bodies-${name}`), Kind);
    this.triangles = await static32("triangles", Uint32Array);  // three points each
    this.lines = await static32("lines", Uint32Array);          // two points each
    this.cellBody = await static32("cells", Uint32Array);       // body of each triangle, then of each line
    this.radius = await static32("radius", Float32Array);
    this.decoder = new SeriesDecoder(3 * this.spec.points + (this.spec.stress > 0 ? this.spec.cells : 0));
    await this.loadNext();
    this.marked = this.turningMarks();
    // An end where another line goes on is not closed: nobody sees it.
    const met = new Map();
    for (const point of this.lines) met.set(point, (met.get(point) ?? 0) + 1);
    this.openEnds = Array.from({ length: this.lines.length / 2 }, (_, l) => [0, 1].filter((end) => met.get(this.lines[2 * l + end]) === 1));
    this.profiles = this.openEnds.map((open) => [...(open.includes(0) ? [[0, 0]] : []), [0, 1], [1, 1], ...(open.includes(1) ? [[1, 0]] : [])]);
  }
  async loadNext() {
    const k = this.frames.length;
    if (k === this.times.length) return false;
    const chunk = await takeChunk(`${this.prefix}bodies-${k}`);
    this.add(chunk instanceof Uint16Array ? chunk : this.decoder.next(chunk));
    return true;
  }
  // One more frame: x, y, z of every point in the box, then the stress of every cell.
  add(values) {
    this.frames.push(values);
  }

  // Frames k and next around a time, and the share between them.
  moment(t, smooth) {
    const loaded = this.frames.length - 1, k = Math.min(indexBefore(this.times, t), loaded), next = smooth ? Math.min(k + 1, loaded) : k;
    const span = this.times[next] - this.times[k];
    this.mix = span > 0 ? Math.min(1, Math.max(0, (t - this.times[k]) / span)) : 0;
    return (this.shown = [k, next]);
  }
  ownTint(cell) {
    const tint = tintOf(this.colours[this.cellBody[cell] % this.colours.length] ?? "#8fa6bd");
    return this.marked.has(cell) ? tint.map((c) => c * kMark) : tint;
  }
  // Triangles of wheels and balls in two opposite eighths of a turn, which are darker so that a rotation is seen: of bodies of which two
  // of three principal moments of the points are equal, and whose rim has points all around.
  turningMarks() {
    const marked = new Set(), count = this.triangles.length / 3, cells = new Map();
    for (let cell = 0; cell < count; ++cell) cells.has(this.cellBody[cell]) ? cells.get(this.cellBody[cell]).push(cell) : cells.set(this.cellBody[cell], [cell]);
    for (const own of cells.values()) {
      if (own.length < 24) continue;
      const points = [...new Set(own.flatMap((cell) => this.cornersOf(cell)))].map((p) => this.pointOf(this.frames[0], p)), n = points.length;
      const centre = [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / n), m = [0, 1, 2].map((i) => [0, 1, 2].map((j) => points.reduce((sum, p) => sum + (p[i] - centre[i]) * (p[j] - centre[j]), 0) / n));
      const [low, middle, high] = eigen(m).sort((x, y) => x.value - y.value), near = (x, y) => Math.abs(x.value - y.value) < 0.03 * high.value;
      if (!near(low, middle) && !near(middle, high)) continue;
      const alone = near(middle, high) ? low : high, u = near(middle, high) ? middle.axis : low.axis, v = [alone.axis[1] * u[2] - alone.axis[2] * u[1], alone.axis[2] * u[0] - alone.axis[0] * u[2], alone.axis[0] * u[1] - alone.axis[1] * u[0]];
      const spots = points.map((p) => p.map((x, k) => x - centre[k])).map((x) => [x[0] * u[0] + x[1] * u[1] + x[2] * u[2], x[0] * v[0] + x[1] * v[1] + x[2] * v[2]]);
      const rim = Math.max(...spots.map(([x, y]) => Math.hypot(x, y))), around = new Set(spots.filter(([x, y]) => Math.hypot(x, y) > 0.9 * rim).map(([x, y]) => Math.floor((Math.atan2(y, x) + Math.PI) * (6 / Math.PI)) % 12));
      if (around.size < 10) continue;
      for (const cell of own) {
        const corners = this.cornersOf(cell).map((p) => this.pointOf(this.frames[0], p)), x = [0, 1, 2].map((k) => corners.reduce((sum, p) => sum + p[k], 0) / 3 - centre[k]);
        const along = (axis) => axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2], turn = (Math.atan2(along(v), along(u)) + 2 * Math.PI) % Math.PI;
        if (turn < Math.PI / 4) marked.add(cell);
      }
    }
    return marked;
  }


  // Into facets. stressed: in the colours of stresses, where they are known.
  collect(facets, stressed = false) {
    const { low, size } = this.spec.box, n = this.spec.points, { mix } = this, [from, to] = this.shown.map((k) => this.frames[k]);
    const at = (this.at ??= new Float64Array(3 * n)), triangles = this.triangles.length / 3;
    for (let axis = 0; axis < 3; ++axis)
      for (let p = 0, j = axis * n; p < n; ++p, ++j) at[3 * p + axis] = low[axis] + (size[axis] * (from[j] + mix * (to[j] - from[j]))) / 65534;
    const stress = stressed && this.spec.stress > 0, known = this.colours.map((_, body) => this.spec.stressed.includes(body));
    const tint = (cell) => {
      const body = this.cellBody[cell];
      if (!stress || !known[body]) {
        return this.ownTint(cell);
      }
      return kStresses[Math.round(((from[3 * n + cell] + mix * (to[3 * n + cell] - from[3 * n + cell])) / 65535) * (kStresses.length - 1))];
    };
    const corners = [0, 1, 2].map(() => [0, 0, 0]);
    for (let i = 0; i < triangles; ++i) {
      for (let k = 0; k < 3; ++k) {
        const p = 3 * this.triangles[3 * i + k];
        facets.toEye(at[p], at[p + 1], at[p + 2], corners[k]);
      }
      facets.add(corners, tint(i), true);
    }
    for (let l = 0; 2 * l < this.lines.length; ++l) {
      const a = 3 * this.lines[2 * l], b = 3 * this.lines[2 * l + 1], r = this.radius[l];
      facets.solid(at[a], at[a + 1], at[a + 2], at[b], at[b + 1], at[b + 2], r, r, kTubeSides, this.profiles[l], tint(triangles + l));
    }
  }

  // ---- the surface of a body, for what is attached to it
  has(body) {
    this.cellsOf ??= this.cellsByBody();
    return this.cellsOf.has(body);
  }
  cellsByBody() {
    const cells = new Map();
    this.cellBody.forEach((body, cell) => (cells.has(body) ? cells.get(body).push(cell) : cells.set(body, [cell])));
    return cells;
  }
  cornersOf(cell) {
    const triangles = this.triangles.length / 3;
    return cell < triangles ? [0, 1, 2].map((k) => this.triangles[3 * cell + k]) : [0, 1].map((k) => this.lines[2 * (cell - triangles) + k]);
  }
  pointOf(values, p) {
    const { low, size } = this.spec.box, n = this.spec.points;
    return [0, 1, 2].map((axis) => low[axis] + (size[axis] * values[axis * n + p]) / 65534);
  }
  // The point of the body's first drawing that is nearest to p: its corners with their weights, and the gap [m]. Null without a drawing.
  nearest(body, p) {
    if (!this.has(body)) return null;
    const triangles = this.triangles.length / 3;
    let best = null;
    for (const cell of this.cellsOf.get(body)) {
      const corners = this.cornersOf(cell), weights = weightsOfNearest(corners.map((c) => this.pointOf(this.frames[0], c)), p);
      const x = [0, 1, 2].map((axis) => corners.reduce((sum, c, k) => sum + weights[k] * this.pointOf(this.frames[0], c)[axis], 0));
      const gap = Math.max(0, Math.hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) - (cell < triangles ? 0 : this.radius[cell - triangles]));
      if (!best || gap < best.gap) best = { corners, weights, gap };
    }
    return best;
  }
  // Where such a point is now.
  place({ corners, weights }) {
    const { mix } = this, [from, to] = this.shown.map((k) => this.frames[k]), x = [0, 0, 0];
    corners.forEach((c, k) => {
      const a = this.pointOf(from, c), b = this.pointOf(to, c);
      for (let axis = 0; axis < 3; ++axis) x[axis] += weights[k] * (a[axis] + mix * (b[axis] - a[axis]));
    });
    return x;
  }

  // Mean of the points of a body at the time shown [m]; null when it is not drawn.
  centre(body) {
    this.pointsOf ??= this.pointsByBody();
    const points = this.pointsOf.get(body);
    if (!points) return null;
    const { low, size } = this.spec.box, n = this.spec.points, mix = this.uniforms.uMix.value;
    const [from, to] = this.shown.map((k) => this.frames[k]);
    return [0, 1, 2].map((axis) => {
      let sum = 0;
      for (const p of points) sum += from[axis * n + p] + mix * (to[axis * n + p] - from[axis * n + p]);
      return low[axis] + (size[axis] * sum) / points.length / 65534;
    });
  }
  pointsByBody() {
    const sets = new Map();
    const note = (cell, point) => {
      const body = this.cellBody[cell];
      if (!sets.has(body)) sets.set(body, new Set());
      sets.get(body).add(point);
    };
    const triangles = this.triangles.length / 3;
    this.triangles.forEach((p, i) => note((i / 3) | 0, p));
    this.lines.forEach((p, i) => note(triangles + ((i / 2) | 0), p));
    return new Map([...sets].map(([body, points]) => [body, [...points]]));
  }
}
