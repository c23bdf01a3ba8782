// Grains as points that are shaded as spheres: one point each, moved by the shader between two frames.
import * as three from "three";
import { SeriesDecoder, joinPlanes } from "./decode.js";
import { indexBefore, takeChunk } from "./page.js";
import { kMaps } from "./colours.js";
import { GrainPainter } from "./painter.js";
import { kBox, kClip, kLayerShade, kLight, kMoving, kScale, boxUniforms, lightOn, scaleUniforms } from "./shading.js";

const kVertex = /* glsl */ `
${kScale}${kBox}${kClip}
attribute vec4 a, b, start;
attribute float radius;
uniform float uPixels;       // height of the picture [pixels]
uniform int uColour;         // 0 plain, 1 the frame's number, 2 displacement since the first frame
uniform float uLargest;      // displacement at the end of the colours [m]
uniform float uUpper;        // share of the largest number at the end of the colours
uniform float uLayers;       // in the box
flat out vec3 vColour;
void main() {
  bool lastKnown = b.x >= 1.0;
  vec4 next = lastKnown ? a : b;
  vec3 x = placed(a, next);
  float value = mix(a.w, next.w, uMix);
  float share = 0.0;
  if (uColour == 1) share = value * value / uUpper;
  if (uColour == 2) share = start.x >= 1.0 ? 0.0 : length(x - (uLow + uSize * (65535.0 / 65534.0) * start.xyz)) / uLargest;
  vColour = colourOf(share);
  if (start.x < 1.0 && fract(0.5 * floor(start.z * uLayers)) > 0.25) vColour *= mix(${kLayerShade.toFixed(3)}, 1.0, min(1.0, share / ${kMoving.toFixed(3)}));
  vec4 eye = modelViewMatrix * vec4(x, 1.0);
  gl_Position = projectionMatrix * eye;
  gl_PointSize = max(1.0, radius * projectionMatrix[1][1] * uPixels / gl_Position.w);
  if (a.x >= 1.0 || clipped(x)) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
}`;

const kFragment = /* glsl */ `
${kLight}
flat in vec3 vColour;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float h = 1.0 - dot(p, p);
  if (h < 0.0) discard;
  gl_FragColor = vec4(vColour * lightOn(vec3(p.x, -p.y, sqrt(h))), 1.0);
}`;

export class Grains {
  // `spec`: run.grains. Call load() next.
  constructor(spec) {
    this.spec = spec;
    this.times = spec.times;
    this.frames = [];  // what has been unpacked: x, y, z, number of each grain
    this.geometry = new three.BufferGeometry();
    this.material = new three.ShaderMaterial({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: {
        ...scaleUniforms(kMaps.sand),
        ...boxUniforms(spec.box),
        uClip: { value: new three.Vector4() },
        uPixels: { value: 1 },
        uColour: { value: 0 },
        uLargest: { value: 1 },
        uUpper: { value: 1 },
        uLayers: { value: 1 },
      },
    });
    this.all = new three.Points(this.geometry, this.material);
    this.all.frustumCulled = false;
    this.object = new three.Group().add(this.all);
  }

  async loadFirst() {
    const chunk = await takeChunk("grains-radius"), radius = chunk instanceof Float32Array ? chunk : joinPlanes(chunk, Float32Array);
    this.geometry.setAttribute("radius", new three.BufferAttribute(radius, 1));
    this.radius = radius;
    this.decoder = new SeriesDecoder(this.spec.count * (3 + this.spec.numbers.length));
    await this.loadNext();
    this.geometry.setAttribute("start", this.frames[0].positions);
    this.findLayers();
    this.setNumber(0);
    this.show(this.times[0], true);
  }

  // Layers of 1, 2 or 5 times a power of ten, about six in the bed at the start, no thinner than grains.
  findLayers() {
    const { low, high } = this.spec.view, depth = high[2] - low[2], start = this.frames[0].positions.array, n = this.spec.count;
    const thick = Math.max(depth / 6, 3 * this.radius.reduce((sum, r) => sum + r, 0) / Math.max(1, n)) || 1, power = 10 ** Math.floor(Math.log10(thick));
    this.layer = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= 0.99 * thick) ?? 10 * power;
    const layers = (this.spec.box.size[2] || this.layer) / this.layer;
    this.material.uniforms.uLayers.value = layers;
    this.odd = Uint8Array.from({ length: n }, (_, i) => (start[4 * i] === 65535 ? 0 : Math.floor((start[4 * i + 2] / 65535) * layers) & 1));
  }

  // False when all frames are there.
  async loadNext() {
    const k = this.frames.length;
    if (k === this.times.length) return false;
    const chunk = await takeChunk(`grains-${k}`);
    this.add(chunk instanceof Uint16Array ? chunk : this.decoder.next(chunk));
    return true;
  }
  // One more frame: x, y, z in the box of all, then each number, of every grain.
  add(values) {
    const n = this.spec.count;
    const packed = new Uint16Array(4 * n);
    for (let i = 0; i < n; ++i) {
      packed[4 * i] = values[i];
      packed[4 * i + 1] = values[n + i];
      packed[4 * i + 2] = values[2 * n + i];
    }
    const numbers = this.spec.numbers.map((_, j) => values.slice((3 + j) * n, (4 + j) * n));
    this.frames.push({ positions: new three.BufferAttribute(packed, 4, true), numbers });
    if (this.frames.length > 1) this.fill(this.frames.at(-1));
  }

  // The number that colours the grains goes to the fourth place of each position: 8 bits, of the root of its share.
  fill(frame) {
    const numbers = frame.numbers[this.number];
    const packed = frame.positions.array;
    if (numbers) for (let i = 0; i < this.spec.count; ++i) packed[4 * i + 3] = numbers[i] * 257;
    frame.positions.needsUpdate = true;
  }
  setNumber(j) {
    this.number = j;
    for (const frame of this.frames) this.fill(frame);
  }

  // What can be shown: "plain", the dumped numbers by name, "displacement".
  colours() {
    const dumped = this.spec.numbers.map((number) => ({ name: number.name, unit: number.unit, largest: number.shown }));
    return [...dumped, { name: "displacement", unit: "m", largest: this.spec.farthest }, { name: "plain" }];
  }
  setColour(name) {
    const uniforms = this.material.uniforms;
    const j = this.spec.numbers.findIndex((number) => number.name === name);
    if (j >= 0) {
      uniforms.uColour.value = 1;
      uniforms.uUpper.value = this.spec.numbers[j].shown / this.spec.numbers[j].largest;
      if (j !== this.number) this.setNumber(j);
    } else {
      uniforms.uColour.value = name === "displacement" ? 2 : 0;
      uniforms.uLargest.value = this.spec.farthest || 1;
    }
  }

  // smooth: grains move straight from frame to frame; else they stand at the last one.
  show(t, smooth) {
    const loaded = this.frames.length - 1;
    const k = Math.min(indexBefore(this.times, t), loaded);
    const next = Math.min(k + 1, loaded);
    const span = this.times[next] - this.times[k];
    this.material.uniforms.uMix.value = smooth && span > 0 ? Math.min(1, Math.max(0, (t - this.times[k]) / span)) : 0;
    this.geometry.setAttribute("a", this.frames[k].positions);
    this.geometry.setAttribute("b", this.frames[smooth ? next : k].positions);
    this.geometry.setAttribute("position", this.frames[k].positions);
    this.shown = [this.frames[k], this.frames[smooth ? next : k]];
    return k;
  }

  // Before a picture of this size is drawn: the processor paints the grains, and facets if there are any, or the points of the shader are drawn.
  paint(on, camera, width, height, facets) {
    this.all.visible = !on;
    if (this.painter) this.painter.object.visible = on;
    if (!on) return;
    if (!this.painter) {
      this.painter = new GrainPainter(this.spec.count, kMaps.sand, lightOn);
      this.object.add(this.painter.object);
    }
    const uniforms = this.material.uniforms;
    const [a, b] = this.shown.map((frame) => frame.positions.array);
    const view = { a, b, mix: uniforms.uMix.value, box: this.spec.box, radius: this.radius, camera, clip: uniforms.uClip.value, width, height };
    this.painter.paint({ ...view, share: this.shareOfColours(a, b), odd: this.odd, facets });
  }

  // What kVertex computes: the share of the colours of a grain at the share mix between frames a and b.
  shareOfColours(a, b) {
    const uniforms = this.material.uniforms, colour = uniforms.uColour.value;
    if (colour === 1) {
      const upper = uniforms.uUpper.value * 65535 * 65535;
      return (i, mix) => {
        const value = a[4 * i + 3] + mix * (b[4 * i + 3] - a[4 * i + 3]);
        return (value * value) / upper;
      };
    }
    if (colour !== 2) return () => 0;
    const start = this.frames[0].positions.array, largest = uniforms.uLargest.value, { size } = this.spec.box;
    return (i, mix) => {
      const k = 4 * i;
      if (start[k] === 65535) return 0;
      let way = 0;
      for (let axis = 0; axis < 3; ++axis) {
        const d = (size[axis] * (a[k + axis] + mix * (b[k + axis] - a[k + axis]) - start[k + axis])) / 65534;
        way += d * d;
      }
      return Math.sqrt(way) / largest;
    };
  }
}
