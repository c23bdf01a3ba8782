// Shapes that are drawn anew for every picture, all of one kind in one mesh.
import * as three from "three";
import { kLight } from "./shading.js";
import { Shapes } from "./shapes.js";

const kVertex = /* glsl */ `
attribute vec3 from, to, tint;
attribute vec2 radii;  // at both ends [m]
varying vec3 vColour, vEye;
void main() {
  vec3 axis = normalize(to - from + vec3(0.0, 0.0, 1e-12));
  vec3 side = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 x = mix(from, to, position.z) + mix(radii.x, radii.y, position.z) * (position.x * side + position.y * cross(axis, side));
  vColour = tint;
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}`;
const kFragment = /* glsl */ `
${kLight}
uniform float uOpacity;
varying vec3 vColour, vEye;
void main() {
  vec3 n = normalize(cross(dFdx(vEye), dFdy(vEye)));
  gl_FragColor = vec4(vColour * lightOn(n.z < 0.0 ? -n : n), uOpacity);
}`;

const kGreaterDepth = 6;  // of three.js

function material(options, opacity) {
  return new three.ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, uniforms: { uOpacity: { value: opacity } }, transparent: opacity < 1, ...options });
}

class Kind {
  constructor(shape) {
    this.shape = shape;
    this.geometry = new three.BufferGeometry();
    this.room = 0;
    this.count = 0;
  }
  grow() {
    const { points, corners } = this.shape, old = this.arrays, room = Math.max(64, 2 * this.room);
    const per = points.length, positions = new Float32Array(3 * per * room), index = new Uint32Array(corners.length * room);
    for (let i = 0; i < room; ++i) {
      points.forEach((p, k) => positions.set(p, 3 * (per * i + k)));
      corners.forEach((c, k) => (index[corners.length * i + k] = per * i + c));
    }
    this.geometry.dispose();
    this.arrays = { from: new Float32Array(3 * per * room), to: new Float32Array(3 * per * room), tint: new Float32Array(3 * per * room), radii: new Float32Array(2 * per * room) };
    this.geometry.setIndex(new three.BufferAttribute(index, 1));
    this.geometry.setAttribute("position", new three.BufferAttribute(positions, 3));
    for (const [name, array] of Object.entries(this.arrays)) {
      if (old) array.set(old[name]);
      this.geometry.setAttribute(name, new three.BufferAttribute(array, name === "radii" ? 2 : 3));
    }
    this.room = room;
  }
  add(from, to, r0, r1, tint) {
    if (this.count === this.room) this.grow();
    const per = this.shape.points.length, { arrays } = this;
    for (let k = 0, j = per * this.count; k < per; ++k, ++j) {
      arrays.from[3 * j] = from[0];
      arrays.from[3 * j + 1] = from[1];
      arrays.from[3 * j + 2] = from[2];
      arrays.to[3 * j] = to[0];
      arrays.to[3 * j + 1] = to[1];
      arrays.to[3 * j + 2] = to[2];
      arrays.tint[3 * j] = tint[0];
      arrays.tint[3 * j + 1] = tint[1];
      arrays.tint[3 * j + 2] = tint[2];
      arrays.radii[2 * j] = r0;
      arrays.radii[2 * j + 1] = r1;
    }
    ++this.count;
  }
  finish() {
    if (this.room === 0) return;
    this.geometry.setDrawRange(0, this.shape.corners.length * this.count);
    for (const name of Object.keys(this.arrays)) this.geometry.attributes[name].needsUpdate = true;
  }
}

// begin(), then what is to be seen, then finish(). `ghost`: what other things hide shows faintly through them. `above`: it is drawn over all.
export class Solids extends Shapes {
  constructor({ ghost = 0, above = false } = {}) {
    super((shape) => new Kind(shape));
    this.ghosts = [];
    this.object = new three.Group();
    for (const { geometry } of [this.tubes, this.pipes, this.balls]) {
      const layers = [[above ? { depthTest: false, depthWrite: false } : {}, 1, above ? 10 : 1]];
      if (ghost > 0) layers.push([{ depthFunc: kGreaterDepth, depthWrite: false }, ghost, 2]);
      for (const [options, opacity, order] of layers) {
        const mesh = new three.Mesh(geometry, material(options, opacity));
        mesh.frustumCulled = false;
        mesh.renderOrder = order;
        if (opacity < 1) this.ghosts.push(mesh);
        this.object.add(mesh);
      }
    }
  }
  begin() {
    this.tubes.count = this.pipes.count = this.balls.count = 0;
  }
  // solid: drawn by the shaders; ghosts: what other things hide, too.
  showMeshes(solid, ghosts) {
    for (const mesh of this.object.children) mesh.visible = this.ghosts.includes(mesh) ? ghosts : solid;
  }
  // Into facets, in place of the shaders.
  collect(facets) {
    for (const { shape, arrays, count } of [this.tubes, this.pipes, this.balls])
      for (let i = 0; i < count; ++i) {
        const k = shape.points.length * i, { from, to, radii, tint } = arrays;
        facets.solid(from[3 * k], from[3 * k + 1], from[3 * k + 2], to[3 * k], to[3 * k + 1], to[3 * k + 2], radii[2 * k], radii[2 * k + 1], shape.sides, shape.rows, tint.subarray(3 * k, 3 * k + 3));
      }
  }
  finish() {
    this.tubes.finish();
    this.pipes.finish();
    this.balls.finish();
  }
}
