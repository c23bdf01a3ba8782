// The picture: camera, grains, bodies, arrows, ground, clip plane.
import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Arrows } from "./arrows.js";
import { Bodies } from "./bodies.js";
import { Grains } from "./grains.js";

const kAxes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const kLowest = 0.5;    // pixels of the picture per pixel of the page
const kWanted = 30;     // pictures in a second
const kPaintedAtMost = 3e5;  // grains: of more, to place and sort them takes longer than to draw them

export class Stage {
  constructor(place, run) {
    this.place = place;
    this.run = run;
    this.smooth = true;
    this.time = 0;
    this.controls = null;
    if (!run.grains && !run.bodies) return;
    // Opaque, which three.js never asks for: the browser then lays nothing under the picture and blends nothing, which
    // costs much where it draws in software.
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: false, antialias: false, powerPreference: "high-performance" });
    this.renderer = new three.WebGLRenderer({ canvas, context });
    this.renderer.setClearColor(0xeef1f4);
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
    place.append(this.renderer.domElement);
    this.paints = this.drawsInSoftware() && run.grains?.count < kPaintedAtMost;
    this.scene = new three.Scene();
    this.camera = new three.PerspectiveCamera(35, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.scene.add(new three.AmbientLight(0xffffff, 1));
    if (run.grains) this.grains = new Grains(run.grains);
    if (run.bodies) this.bodies = new Bodies(run.bodies);
    for (const part of this.parts()) this.scene.add(part.object);
    this.box = new three.Box3();
    for (const spec of [run.grains, run.bodies]) {
      if (!spec) continue;
      this.box.expandByPoint(new three.Vector3(...spec.view.low));
      this.box.expandByPoint(new three.Vector3(...spec.view.high));
    }
    this.size = this.box.getSize(new three.Vector3()).length() || 1;
    this.addGround();
    this.orbit = new OrbitControls(this.camera, this.renderer.domElement);
    this.orbit.addEventListener("change", () => this.wish());
    this.look(-65, 24);
    this.clip = { axis: "", share: 0.5, flip: false };
    new ResizeObserver(() => this.resize()).observe(place);
    this.resize();
  }

  drawsInSoftware() {
    const context = this.renderer.getContext();
    const names = context.getExtension("WEBGL_debug_renderer_info");
    const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  }

  parts() {
    return [this.grains, this.bodies].filter(Boolean);
  }

  async loadFirst() {
    for (const part of this.parts()) await part.loadFirst();
    this.hasFrames = true;
  }
  // One more frame of each; false when all are there.
  async loadNext() {
    let more = false;
    for (const part of this.parts()) more = (await part.loadNext()) || more;
    return more;
  }
  loaded() {
    const parts = this.parts();
    return parts.length === 0 ? 1 : Math.min(...parts.map((part) => part.frames.length / part.times.length));
  }

  addForces(history) {
    if (!this.scene) return;
    this.arrows = new Arrows(history, this.run.bodyNames, this.size);
    this.scene.add(this.arrows.object);
  }

  // A grid under everything, a plane where the ground is one. Its squares are 1, 2 or 5 times a power of ten.
  addGround() {
    const power = 10 ** Math.floor(Math.log10(this.size / 8));
    this.square = [1, 2, 5, 10].map((k) => k * power).find((s) => this.size / s < 16) ?? 10 * power;
    const cells = 2 * Math.ceil(this.size / this.square / 2);
    const grid = new three.GridHelper(cells * this.square, cells, 0x8896a3, 0xc5ccd3).rotateX(Math.PI / 2);
    const centre = this.box.getCenter(new three.Vector3());
    const snap = (v) => Math.round(v / this.square) * this.square;
    const plane = this.run.plane;
    if (plane) {
      const normal = new three.Vector3(...plane.normal), point = new three.Vector3(...plane.point);
      const turn = new three.Quaternion().setFromUnitVectors(new three.Vector3(0, 0, 1), normal);
      grid.applyQuaternion(turn);
      grid.position.copy(centre.addScaledVector(normal, -normal.dot(centre.clone().sub(point))));
    } else {
      grid.position.set(snap(centre.x), snap(centre.y), this.box.min.z);
    }
    this.scene.add(grid);
  }

  // The eye at this azimuth and elevation [deg], so that all is seen.
  look(azimuth, elevation) {
    if (!this.scene) return;
    const a = (azimuth * Math.PI) / 180, e = (elevation * Math.PI) / 180;
    const from = new three.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    const centre = this.box.getCenter(new three.Vector3());
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    this.camera.position.copy(centre).addScaledVector(from, (0.52 * this.size) / half);
    this.camera.near = this.size / 500;
    this.camera.far = this.size * 20;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(centre);
    this.orbit.update();
    this.wish();
  }

  // Leaves out what lies before the plane across `axis` at this share of the box; axis "": nothing.
  setClip(change) {
    if (!this.scene) return;
    Object.assign(this.clip, change);
    const { axis, share, flip } = this.clip;
    const sign = flip ? 1 : -1;
    const n = (kAxes[axis] ?? [0, 0, 0]).map((v) => v * sign);
    const at = axis ? this.box.min[axis] + share * (this.box.max[axis] - this.box.min[axis]) : 0;
    this.grains?.material.uniforms.uClip.value.set(...n, axis ? sign * at : 1);
    this.bodies?.uniforms.uClip.value.set(...n, axis && this.clip.bodies ? sign * at : 1e30);
    this.clipAt = at;
    this.wish();
  }

  setTime(t) {
    this.time = t;
    if (!this.scene) return;
    this.grainFrame = this.grains?.show(t, this.smooth);
    this.bodies?.show(t, this.smooth);
    this.arrows?.show(t, (body) => this.bodies?.centre(body) ?? null);
    this.wish();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (!(width > 0 && height > 0)) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height);
    if (this.grains) this.grains.material.uniforms.uPixels.value = this.renderer.domElement.height;
    this.wish();
  }
  // While it plays, a slow machine draws fewer pixels; the full picture comes back when it stands.
  suitRate(rate, playing) {
    if (!this.scene) return;
    const full = Math.min(window.devicePixelRatio || 1, 2);
    let ratio = this.ratio;
    if (!playing) ratio = full;
    else if (rate > 0 && rate < kWanted - 2) ratio = Math.max(kLowest, 0.85 * ratio);
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.resize();
  }

  // A picture with the next turn of the screen.
  wish() {
    if (this.wished || !this.scene) return;
    this.wished = true;
    requestAnimationFrame(() => this.draw());
  }
  draw() {
    this.wished = false;
    if (!this.scene || !this.hasFrames) return;
    this.camera.updateMatrixWorld();
    const { width, height } = this.renderer.domElement;
    this.grains?.paint(this.paints, this.camera, width, height);
    this.renderer.render(this.scene, this.camera);
  }
}
