// The surface of the mechanism, moved by shaders between two frames.
import * as three from "three";
import { kMaps } from "./colours.js";
import { kBox, kClip, kLight, kScale, boxUniforms, scaleUniforms } from "./shading.js";
import { kTubeSides, Surface } from "./surface.js";

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

// Facets are flat: the normal belongs to the triangle on the screen.
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
  const sides = kTubeSides, points = [], corners = [], ends = [[], []];
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

const kGhost = "#8338ec";  // of the second run

export class Bodies extends Surface {
  // ghost: of a second run, whose chunks begin with "other-"; it has one colour, and what is behind it is seen through it.
  constructor(spec, names, ghost = false) {
    super(spec, names, ghost ? "other-" : "", ghost ? kGhost : null);
    this.ghost = ghost;
    this.uniforms = {
      ...scaleUniforms(kMaps.stress),
      ...boxUniforms(spec.box),
      uClip: { value: new three.Vector4() },
      uStress: { value: false },
      uOpaque: { value: ghost ? 0.35 : 1 },
    };
    this.object = new three.Group();
    this.filled = [-1, -1];  // frames that the shaders have
  }

  material(vertexShader) {
    return new three.ShaderMaterial({ vertexShader, fragmentShader: kFragment, uniforms: this.uniforms, side: three.DoubleSide,
      ...(this.ghost ? { transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 } : {}) });
  }

  async loadFirst() {
    await super.loadFirst();
    const triangles = this.triangles.length / 3, lines = this.lines.length / 2;
    const tints = (cells, times) => {
      const all = new Float32Array(4 * times * cells.length);
      cells.forEach((cell, i) => {
        const tint = [...this.ownTint(cell), this.spec.stressed.includes(this.cellBody[cell]) ? 1 : 0];
        for (let k = 0; k < times; ++k) all.set(tint, 4 * (times * i + k));
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
      geometry.setAttribute("radius", new three.BufferAttribute(Float32Array.from({ length: copies * lines }, (_, i) => this.radius[(i / copies) | 0]), 1));
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
  tubeCorners() {
    const all = [];
    this.openEnds.forEach((open, l) => {
      for (const corners of [kTube.corners, ...open.map((end) => kTube.ends[end])])
        for (const corner of corners) all.push(l * kTube.points.length + corner);
    });
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
    const [k, next] = this.moment(t, smooth);
    this.uniforms.uMix.value = this.mix;
    if (this.filled[0] !== k) this.fill("a", k);
    if (this.filled[1] !== next) this.fill("b", next);
    this.filled = [k, next];
    return k;
  }

  // As of Surface; false where a cut goes through the bodies, which the shaders alone show.
  collect(facets) {
    const cut = this.uniforms.uClip.value;
    if ((cut.x || cut.y || cut.z) && cut.w < 1e29) return false;
    super.collect(facets, this.uniforms.uStress.value);
    return true;
  }
  showMeshes(on) {
    for (const mesh of this.object.children) mesh.visible = on;
  }
}
