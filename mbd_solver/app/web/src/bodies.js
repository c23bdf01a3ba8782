// The mechanism as it was drawn: triangles, and lines as tubes, moved by the shader between two frames.
import * as three from "three";
import { SeriesDecoder, joinPlanes } from "./decode.js";
import { indexBefore, takeChunk } from "./page.js";
import { bodyColours, kMaps } from "./colours.js";
import { kBox, kClip, kLight, kScale, boxUniforms, scaleUniforms } from "./shading.js";
import { tintOf } from "./solids.js";

const kColour = /* glsl */ `
uniform bool uStress;
attribute vec4 tint;  // the last: its stress is known
varying vec3 vColour, vEye;
varying float vBehind;  // how far the clip plane leaves it out [m]
void paint(float stress, vec3 x) {
  vColour = uStress && tint.w > 0.5 ? colourOf(stress) : tint.rgb;
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
  vBehind = dot(x, uClip.xyz) - uClip.w;
}`;

const kPlates = /* glsl */ `
${kScale}${kBox}${kClip}${kColour}
attribute vec4 a, b;
void main() {
  paint(mix(a.w, b.w, uMix), placed(a, b));
}`;

// The unit tube along z, from 0 to 1, is laid from the line's start to its end.
const kTubes = /* glsl */ `
${kScale}${kBox}${kClip}${kColour}
attribute vec4 a0, a1, b0, b1;
attribute float radius;
void main() {
  vec3 from = placed(a0, b0), to = placed(a1, b1), axis = normalize(to - from + vec3(0.0, 0.0, 1e-12));
  vec3 side = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 x = mix(from, to, position.z) + radius * (position.x * side + position.y * cross(axis, side));
  paint(mix(a0.w, b0.w, uMix), x);
}`;

// Facets are flat: the normal is that of the triangle on the screen.
const kFragment = /* glsl */ `
${kLight}
varying vec3 vColour, vEye;
varying float vBehind;
uniform float uOpaque;
void main() {
  if (vBehind > 0.0) discard;
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), uOpaque);
}`;

// The unit tube: points around its ends and in their middles, and three corners of each triangle of its side and of its two ends. Every line
// has points of its own: software renderers take longer over an instance than over its points.
const kTube = (() => {
  const sides = 8, points = [], corners = [], ends = [[], []];
  for (let k = 0; k < 2 * sides; ++k) {
    const angle = (2 * Math.PI * (k % sides)) / sides;
    points.push([Math.cos(angle), Math.sin(angle), k < sides ? 0 : 1]);
  }
  points.push([0, 0, 0], [0, 0, 1]);
  for (let k = 0; k < sides; ++k) {
    const next = (k + 1) % sides;
    corners.push(k, next, sides + next, k, sides + next, sides + k);
    ends[0].push(next, k, 2 * sides);
    ends[1].push(sides + k, sides + next, 2 * sides + 1);
  }
  return { sides, points, corners, ends };
})();

// Colours of stresses, from none to the largest, as colourOf in shading.js finds them.
const kStresses = Array.from({ length: 256 }, (_, i) => {
  const { shares, stops } = kMaps.stress, share = i / 255;
  let k = 1;
  while (k < shares.length - 1 && share > shares[k]) ++k;
  const m = (share - shares[k - 1]) / (shares[k] - shares[k - 1]);
  return stops[k].map((c, rgb) => (stops[k - 1][rgb] + m * (c - stops[k - 1][rgb])) / 255);
});

const kGhost = "#8338ec", kMark = 0.62;  // of the second run; how dark marks of turning are

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

export class Bodies {
  // ghost: of a second run, whose chunks begin with "other-"; it has one colour, and what is behind it is seen through it.
  constructor(spec, names, ghost = false) {
    this.spec = spec;
    this.ghost = ghost;
    this.prefix = ghost ? "other-" : "";
    this.colours = ghost ? names.map(() => kGhost) : bodyColours(names);
    this.times = spec.times;
    this.frames = [];
    this.uniforms = {
      ...scaleUniforms(kMaps.stress),
      ...boxUniforms(spec.box),
      uClip: { value: new three.Vector4() },
      uStress: { value: false },
      uOpaque: { value: ghost ? 0.35 : 1 },
    };
    this.object = new three.Group();
    this.shown = [-1, -1];
  }

  material(vertexShader) {
    return new three.ShaderMaterial({ vertexShader, fragmentShader: kFragment, uniforms: this.uniforms, side: three.DoubleSide,
      ...(this.ghost ? { transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 } : {}) });
  }

  async loadFirst() {
    this.radius = null;
    const static32 = async (name, Kind) => joinPlanes(await takeChunk(`${this.prefix}bodies-${name}`), Kind);
    this.triangles = await static32("triangles", Uint32Array);  // three points each
    this.lines = await static32("lines", Uint32Array);          // two points each
    this.cellBody = await static32("cells", Uint32Array);       // body of each triangle, then of each line
    const radius = (this.radius = await static32("radius", Float32Array));
    this.decoder = new SeriesDecoder(3 * this.spec.points + (this.spec.stress > 0 ? this.spec.cells : 0));
    const triangles = this.triangles.length / 3, lines = this.lines.length / 2;
    const first = await takeChunk(`${this.prefix}bodies-0`);
    this.frames.push(first instanceof Uint16Array ? first : this.decoder.next(first));
    this.marked = this.turningMarks();
    const tints = (cells, times) => {
      const colour = new three.Color(), all = new Float32Array(4 * times * cells.length);
      cells.forEach((cell, i) => {
        const body = this.cellBody[cell];
        colour.set(this.colours[body % this.colours.length] ?? "#8fa6bd").convertLinearToSRGB();
        if (this.marked.has(cell)) colour.multiplyScalar(kMark);
        for (let k = 0; k < times; ++k) all.set([colour.r, colour.g, colour.b, this.spec.stressed.includes(body) ? 1 : 0], 4 * (times * i + k));
      });
      return all;
    };
    const cells = (first, count) => Array.from({ length: count }, (_, i) => first + i);
    const sixteen = (count) => new three.BufferAttribute(new Uint16Array(4 * count), 4, true);
    if (triangles > 0) {
      const geometry = new three.BufferGeometry();
      geometry.setAttribute("tint", new three.BufferAttribute(tints(cells(0, triangles), 3), 4));
      for (const name of ["a", "b"]) geometry.setAttribute(name, sixteen(3 * triangles));
      geometry.setAttribute("position", geometry.attributes.a);
      this.plates = new three.Mesh(geometry, this.material(kPlates));
    }
    if (lines > 0) {
      const geometry = new three.BufferGeometry();
      geometry.setIndex(this.tubeCorners());
      geometry.setAttribute("position", new three.Float32BufferAttribute(Array(lines).fill(kTube.points.flat()).flat(), 3));
      const copies = kTube.points.length;
      geometry.setAttribute("tint", new three.BufferAttribute(tints(cells(triangles, lines), copies), 4));
      geometry.setAttribute("radius", new three.BufferAttribute(Float32Array.from({ length: copies * lines }, (_, i) => radius[(i / copies) | 0]), 1));
      for (const name of ["a0", "a1", "b0", "b1"]) geometry.setAttribute(name, sixteen(copies * lines));
      this.tubes = new three.Mesh(geometry, this.material(kTubes));
    }
    for (const mesh of [this.plates, this.tubes]) {
      if (!mesh) continue;
      mesh.frustumCulled = false;
      this.object.add(mesh);
    }
    this.show(this.times[0], true);
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

  // An end where another line goes on is not closed: nobody sees it.
  tubeCorners() {
    const lines = this.lines.length / 2, met = new Map(), all = [];
    for (const point of this.lines) met.set(point, (met.get(point) ?? 0) + 1);
    this.profiles = [];
    for (let l = 0; l < lines; ++l) {
      const open = [0, 1].filter((end) => met.get(this.lines[2 * l + end]) === 1);
      this.profiles.push([...(open.includes(0) ? [[0, 0]] : []), [0, 1], [1, 1], ...(open.includes(1) ? [[1, 0]] : [])]);
      for (const corners of [kTube.corners, ...open.map((end) => kTube.ends[end])])
        for (const corner of corners) all.push(l * kTube.points.length + corner);
    }
    return all;
  }

  // Place `to` of an array of four numbers each gets the position of a point and the stress of a cell.
  static put(array, to, values, points, point, stress) {
    array[4 * to] = values[point];
    array[4 * to + 1] = values[points + point];
    array[4 * to + 2] = values[2 * points + point];
    array[4 * to + 3] = stress;
  }
  fill(letter, k) {
    const values = this.frames[k], points = this.spec.points, triangles = this.triangles.length / 3;
    const stress = (cell) => (this.spec.stress > 0 ? values[3 * points + cell] : 0);
    if (this.plates) {
      const attribute = this.plates.geometry.attributes[letter];
      for (let i = 0; i < this.triangles.length; ++i)
        Bodies.put(attribute.array, i, values, points, this.triangles[i], stress((i / 3) | 0));
      attribute.needsUpdate = true;
    }
    if (this.tubes)
      for (const end of [0, 1]) {
        const attribute = this.tubes.geometry.attributes[letter + end];
        const copies = kTube.points.length;
        for (let i = 0; i < (copies * this.lines.length) / 2; ++i) {
          const l = (i / copies) | 0;
          Bodies.put(attribute.array, i, values, points, this.lines[2 * l + end], stress(triangles + l));
        }
        attribute.needsUpdate = true;
      }
  }

  show(t, smooth) {
    const loaded = this.frames.length - 1;
    const k = Math.min(indexBefore(this.times, t), loaded);
    const next = smooth ? Math.min(k + 1, loaded) : k;
    const span = this.times[next] - this.times[k];
    this.uniforms.uMix.value = span > 0 ? Math.min(1, Math.max(0, (t - this.times[k]) / span)) : 0;
    if (this.shown[0] !== k) this.fill("a", k);
    if (this.shown[1] !== next) this.fill("b", next);
    this.shown = [k, next];
    return k;
  }

  // Into facets, in place of the shaders; false where a cut goes through the bodies, which those alone show.
  collect(facets) {
    const cut = this.uniforms.uClip.value;
    if ((cut.x || cut.y || cut.z) && cut.w < 1e29) return false;
    const { low, size } = this.spec.box, n = this.spec.points, mix = this.uniforms.uMix.value, [from, to] = this.shown.map((k) => this.frames[k]);
    const at = (this.at ??= new Float64Array(3 * n)), triangles = this.triangles.length / 3;
    for (let axis = 0; axis < 3; ++axis)
      for (let p = 0, j = axis * n; p < n; ++p, ++j) at[3 * p + axis] = low[axis] + (size[axis] * (from[j] + mix * (to[j] - from[j]))) / 65534;
    const stress = this.uniforms.uStress.value && this.spec.stress > 0, known = this.colours.map((_, body) => this.spec.stressed.includes(body));
    const tint = (cell) => {
      const body = this.cellBody[cell];
      if (!stress || !known[body]) {
        const tint = tintOf(this.colours[body % this.colours.length] ?? "#8fa6bd");
        return this.marked.has(cell) ? tint.map((c) => c * kMark) : tint;
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
      facets.solid(at[a], at[a + 1], at[a + 2], at[b], at[b + 1], at[b + 2], r, r, kTube.sides, this.profiles[l], tint(triangles + l));
    }
    return true;
  }
  showMeshes(on) {
    for (const mesh of this.object.children) mesh.visible = on;
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
    const mix = this.uniforms.uMix.value, [from, to] = this.shown.map((k) => this.frames[k]), x = [0, 0, 0];
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
