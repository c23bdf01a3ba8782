// The picture: camera, grains, bodies, symbols, arrows, ground, clip plane.
import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Arrows } from "./arrows.js";
import { Bodies } from "./bodies.js";
import { inks } from "./colours.js";
import { level, wayToEye } from "./eye.js";
import { Facets } from "./facets.js";
import { Grains } from "./grains.js";
import { Marks } from "./marks.js";
import { Overlay } from "./overlay.js";
import { cross, dot, plus, unit } from "./shapes.js";
import { Solids } from "./solids.js";
import { Symbols } from "./symbols.js";

const kAxes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const kLowest = 0.4;    // pixels of the picture per pixel of the page
const kFar = 0.47;       // half of what the eye sees, at zoom 1, of the size of all
const kWanted = 33;     // pictures in a second
const kTried = 1.1;     // times the size that played last, when it plays again
const kLook = 10;       // so often it is asked whether a picture is there [ms]
const kPaintedAtMost = 3e5;  // grains: of more, to place and sort them takes longer than to draw them

export class Stage {
  // renderer: of a stage before this one, or none. scenery: loaded, or none.
  constructor(place, run, renderer, scenery) {
    this.place = place;
    this.run = run;
    this.smooth = true;
    this.held = false;  // draws nothing yet
    this.time = 0;
    this.controls = null;
    if (!run.grains && !run.bodies && !run.marks && !run.meshes?.length && !run.bed) return;
    this.renderer = renderer ?? Stage.newRenderer();
    this.renderer.setClearColor(inks().stage);
    this.ratio = Math.min(window.devicePixelRatio || 1, 2);
    place.append(this.renderer.domElement);
    this.inSoftware = this.drawsInSoftware();
    this.paints = this.inSoftware && run.grains?.count < kPaintedAtMost;
    this.scene = new three.Scene();
    this.camera = new three.PerspectiveCamera(35, 1, 0.01, 1000);
    // Up is against gravity: where it is tilted, the bed is a slope.
    this.up = unit((run.gravity ?? [0, 0, 0]).map((g) => -g));
    this.camera.up.set(...this.up);
    this.scene.add(new three.AmbientLight(0xffffff, 1));
    if (run.grains) this.grains = new Grains(run.grains);
    if (run.bodies) this.bodies = new Bodies(run.bodies, run.bodyNames);
    if (run.other?.bodies) this.other = new Bodies(run.other.bodies, run.other.bodyNames, true);
    if (run.marks) this.marks = new Marks(run.marks);
    for (const part of this.parts()) this.scene.add(part.object);
    this.scenery = scenery;
    this.box = new three.Box3();
    if (scenery && !scenery.box.isEmpty()) this.box.union(scenery.box);
    if (scenery) this.scene.add(scenery.build());
    for (const spec of [run.grains, run.bodies, run.marks, run.other?.bodies]) {
      if (!spec) continue;
      this.box.expandByPoint(new three.Vector3(...spec.view.low));
      this.box.expandByPoint(new three.Vector3(...spec.view.high));
    }
    this.size = this.box.getSize(new three.Vector3()).length() || 1;
    this.overlay = new Overlay(place, this);
    this.addGround();
    this.orbit = new OrbitControls(this.camera, this.renderer.domElement);
    this.orbit.addEventListener("change", () => this.wish());
    this.look(-65, 24);
    this.overlay.show();
    this.clip = { axis: "", share: 0.5, flip: false };
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(place);
    this.resize();
  }
  // Opaque, which three.js never asks for: the browser then lays nothing under the picture and blends nothing, which costs much where it
  // draws in software.
  static newRenderer() {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: false, antialias: false, powerPreference: "high-performance" });
    return new three.WebGLRenderer({ canvas, context });
  }
  // Leaves the place and the renderer to another stage.
  end() {
    if (!this.scene) return;
    this.observer.disconnect();
    this.orbit.dispose();
    this.overlay.end();
    this.scene.traverse((object) => {
      object.geometry?.dispose();
      object.material?.dispose();
    });
    this.scene = null;
  }

  drawsInSoftware() {
    const context = this.renderer.getContext();
    const names = context.getExtension("WEBGL_debug_renderer_info");
    const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  }

  parts() {
    return [this.grains, this.bodies, this.other].filter(Boolean);
  }

  async loadFirst() {
    for (const part of this.parts()) await part.loadFirst();
    await this.marks?.load();
    if (this.marks) {
      const own = new three.Box3();
      for (const spec of [this.run.bodies, this.run.marks]) if (spec) for (const end of ["low", "high"]) own.expandByPoint(new three.Vector3(...spec.view[end]));
      this.mechanism = own;
      this.symbols = new Symbols(this.marks, this.bodies, this.run.bodyNames, own.getSize(new three.Vector3()).length() || this.size, this.up, new Solids({ ghost: 0.28 }), new Solids({ above: true }));
      this.symbols.object = new three.Group().add(this.symbols.solids.object, this.symbols.tracks.object);
      this.scene.add(this.symbols.object);
    }
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
    this.arrows = new Arrows(history, this.run.bodyNames, this.size, this.marks);
    this.scene.add(this.arrows.object);
  }

  // A grid under everything, a plane where the ground is one. Its squares are 1, 2 or 5 times a power of ten.
  addGround() {
    const power = 10 ** Math.floor(Math.log10(this.size / 8));
    this.square = [1, 2, 5, 10].map((k) => k * power).find((s) => this.size / s < 16) ?? 10 * power;
    const cells = 2 * Math.ceil(this.size / this.square / 2);
    const centre = this.box.getCenter(new three.Vector3());
    const snap = (v) => Math.round(v / this.square) * this.square;
    const grid = (lines = inks().lines) => new three.GridHelper(cells * this.square, cells, inks().axes, lines).rotateX(Math.PI / 2);
    const planes = this.run.planes ?? [];
    this.slope = 0;
    if (this.run.terrain) this.addTerrain(this.run.terrain);
    planes.forEach(({ point, normal }, i) => {
      const n = new three.Vector3(...normal), lines = grid(0xa39a80), at = centre.clone().addScaledVector(n, -n.dot(centre.clone().sub(new three.Vector3(...point))));
      const turn = new three.Quaternion().setFromUnitVectors(new three.Vector3(0, 0, 1), n), plane = new three.Group().add(lines, this.ground(0.5 * cells * this.square, turn));
      plane.applyQuaternion(turn);
      plane.position.copy(at);
      this.scene.add(plane);
      if (i === 0) this.slope = Math.acos(Math.min(1, Math.abs(dot(unit(normal), this.up))));
    });
    if (planes.length > 0 || this.run.terrain) return;
    this.slope = Math.acos(Math.min(1, this.up[2]));
    const lines = grid();
    lines.position.set(snap(centre.x), snap(centre.y), this.box.min.z);
    this.scene.add(lines);
  }
  // The surface of uneven ground, brighter where it faces the light, with level lines; and its rocks.
  addTerrain({ first, step, counts, heights, rocks }) {
    const light = unit([-0.5, -0.6, 0.9]), [columns, rows] = counts, positions = [], colours = [], index = [];
    const at = (i, j) => heights[Math.min(rows - 1, Math.max(0, j)) * columns + Math.min(columns - 1, Math.max(0, i))];
    const low = Math.min(...heights), high = Math.max(...heights), apart = [1, 2, 5, 10].map((k) => k * 10 ** Math.floor(Math.log10((high - low || 1) / 10))).find((s) => (high - low) / s < 12);
    const shade = (n, base) => base.map((c) => c * (0.45 + 0.55 * Math.max(0, dot(n, light))));
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        positions.push(first[0] + i * step[0], first[1] + j * step[1], at(i, j));
        const n = unit([(at(i - 1, j) - at(i + 1, j)) / (2 * step[0]), (at(i, j - 1) - at(i, j + 1)) / (2 * step[1]), 1]);
        colours.push(...shade(n, [0.72, 0.66, 0.52]));
        if (i + 1 < columns && j + 1 < rows) index.push(j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, j * columns + i, (j + 1) * columns + i + 1, (j + 1) * columns + i);
      }
    const mesh = (points, tints, corners) => {
      const geometry = new three.BufferGeometry().setIndex(corners);
      geometry.setAttribute("position", new three.Float32BufferAttribute(points, 3));
      geometry.setAttribute("color", new three.Float32BufferAttribute(tints, 3));
      this.scene.add(new three.Mesh(geometry, new three.MeshBasicMaterial({ vertexColors: true, side: three.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 })));
    };
    mesh(positions, colours, index);
    // Where a level crosses the edges of a triangle.
    const lines = [];
    for (let t = 0; t < index.length && high > low; t += 3) {
      const p = [0, 1, 2].map((k) => positions.slice(3 * index[t + k], 3 * index[t + k] + 3)), zs = p.map((q) => q[2]);
      for (let level = Math.ceil(Math.min(...zs) / apart) * apart; level <= Math.max(...zs); level += apart) {
        const ends = [];
        for (const [a, b] of [[0, 1], [1, 2], [2, 0]])
          if ((zs[a] - level) * (zs[b] - level) < 0) ends.push(plus(p[a], p[b].map((x, k) => x - p[a][k]), (level - zs[a]) / (zs[b] - zs[a])));
        if (ends.length === 2) lines.push(...ends[0], ...ends[1]);
      }
    }
    const contours = new three.BufferGeometry();
    contours.setAttribute("position", new three.Float32BufferAttribute(lines, 3));
    this.scene.add(new three.LineSegments(contours, new three.LineBasicMaterial({ color: 0x8d8468 })));
    for (const [x, y, z, radius] of rocks) {
      const ball = new three.SphereGeometry(radius, 24, 16), points = ball.getAttribute("position").array, tints = [], places = [];
      for (let k = 0; k < points.length; k += 3) {
        tints.push(...shade([points[k] / radius, points[k + 1] / radius, points[k + 2] / radius], [0.6, 0.57, 0.53]));
        places.push(points[k] + x, points[k + 1] + y, points[k + 2] + z);
      }
      mesh(places, tints, [...ball.index.array]);
    }
  }
  // The sheet under the lines of a plane; a slope has a wedge with a level foot under it. turn: from z to the plane's normal.
  ground(half, turn) {
    const h = half, up = new three.Vector3(...this.up).applyQuaternion(turn.clone().invert()).toArray();
    const corners = [[-h, -h, 0], [h, -h, 0], [h, h, 0], [-h, h, 0]], heights = corners.map((c) => dot(c, up)), lowest = Math.min(...heights);
    const feet = corners.map((c, k) => plus(c, up, lowest - heights[k])), group = new three.Group();
    const add = (points, color) => {
      const geometry = new three.BufferGeometry();
      geometry.setAttribute("position", new three.Float32BufferAttribute(points.flat(), 3));
      const sheet = new three.Mesh(geometry, new three.MeshBasicMaterial({ color, side: three.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
      sheet.renderOrder = 2;  // last: what hides it is not shaded twice
      group.add(sheet);
    };
    add([0, 1, 2, 0, 2, 3].map((k) => corners[k]), 0xd9cfb4);
    // A wall beyond the horizontal is no ground to stand on.
    if (Math.max(...heights) - lowest > 1e-3 * h && up[2] > 0.1)
      corners.forEach((c, k) => add([c, corners[(k + 1) % 4], feet[(k + 1) % 4], c, feet[(k + 1) % 4], feet[k]], k % 2 ? 0xb5a988 : 0xc4b896));
    return group;
  }

  // The eye at this azimuth and elevation [deg], so that all is seen; `zoom`: so many times nearer; `at`: the point that is looked at [m].
  look(azimuth, elevation, zoom = 1, at = null) {
    if (!this.scene) return;
    const from = wayToEye(azimuth, elevation, this.up);
    const centre = at ? new three.Vector3(...at) : this.box.getCenter(new three.Vector3());
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    this.camera.position.copy(centre).addScaledVector(new three.Vector3(...from), (kFar * this.size) / half / zoom);
    this.camera.near = this.size / 500 / Math.max(1, zoom);
    this.camera.far = this.size * 20;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(centre);
    this.orbit.update();
    this.wish();
  }
  // Nearer, so that the mechanism fills the picture.
  lookAtMechanism(azimuth, elevation) {
    const box = this.mechanism ?? this.box;
    this.look(azimuth, elevation, this.size / (box.getSize(new three.Vector3()).length() || this.size), box.getCenter(new three.Vector3()).toArray());
  }
  // Azimuth, elevation [deg], zoom and target of the eye as it is: what look() takes.
  eye() {
    const way = this.camera.position.clone().sub(this.orbit.target), { x, y, z } = level(this.up), d = way.toArray(), far = way.length();
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    return {
      azimuth: (Math.atan2(dot(d, y), dot(d, x)) * 180) / Math.PI,
      elevation: (Math.asin(Math.min(1, Math.max(-1, dot(d, z) / far))) * 180) / Math.PI,
      zoom: (kFar * this.size) / half / far,
      at: this.orbit.target.toArray(),
    };
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
    for (const bodies of [this.bodies, this.other]) bodies?.uniforms.uClip.value.set(...n, axis && this.clip.bodies ? sign * at : 1e30);
    this.clipAt = at;
    this.wish();
  }

  setTime(t) {
    this.time = t;
    if (!this.scene) return;
    this.grainFrame = this.grains?.show(t, this.smooth);
    this.bodies?.show(t, this.smooth);
    this.other?.show(t, this.smooth);
    this.symbols?.show(t, this.smooth);
    this.arrows?.show(t, (body) => this.bodies?.centre(body) ?? null, this.smooth);
    this.wish();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (!this.scene || !(width > 0 && height > 0)) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height);
    if (this.grains) this.grains.material.uniforms.uPixels.value = this.renderer.domElement.height;
    this.wish();
  }
  // While it plays, a slow machine draws fewer pixels; the full picture comes back when it stops. rate: pictures a second, 0 while unknown.
  // Returns whether the picture has another size now.
  suitRate(rate, playing) {
    if (!this.scene) return false;
    const full = Math.min(window.devicePixelRatio || 1, 2);
    let ratio = this.ratio;
    if (!playing) ratio = full;
    else if (!this.playing) ratio = Math.min(full, kTried * (this.suited ?? full));
    else if (rate > 0 && rate < kWanted) ratio = Math.max(kLowest, ratio * Math.max(0.7, Math.sqrt(rate / kWanted)));
    this.playing = playing;
    if (playing) this.suited = ratio;
    if (ratio === this.ratio) return false;
    this.ratio = ratio;
    this.resize();
    return true;
  }

  // Of bodies and symbols, for the painter of the grains, while it plays; null where the shaders draw them.
  facetsOfMechanism(width, height) {
    if (!this.paints || !this.playing || !this.grains.object.visible) return null;
    const facets = (this.facets ??= new Facets());
    facets.begin(this.camera, width, height);
    if (this.bodies?.object.visible && !this.bodies.collect(facets)) return null;
    if (this.symbols?.object.visible) this.symbols.solids.collect(facets);
    return facets.whole ? facets : null;
  }

  // A picture with the next turn of the screen.
  wish() {
    if (this.wished || !this.scene) return;
    this.wished = true;
    requestAnimationFrame(() => this.wished && this.draw());
  }
  draw() {
    this.wished = false;
    if (!this.scene || !this.hasFrames || this.held) return;
    this.camera.updateMatrixWorld();
    const { width, height } = this.renderer.domElement;
    const facets = this.facetsOfMechanism(width, height), shaders = facets === null;
    this.bodies?.showMeshes(shaders);
    this.symbols?.solids.showMeshes(shaders, shaders && (!this.playing || !this.inSoftware));
    this.grains?.paint(this.paints, this.camera, width, height, facets);
    this.renderer.render(this.scene, this.camera);
    this.overlay.show();
  }
  // Draws at once; resolves when the picture is there, which without a graphics card is long after it was asked for.
  async drawn() {
    this.draw();
    const context = this.renderer?.getContext(), fence = context?.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    context.flush();
    do await new Promise((resolve) => setTimeout(resolve, kLook));
    while (!context.isContextLost() && context.getSyncParameter(fence, context.SYNC_STATUS) !== context.SIGNALED);
    context.deleteSync(fence);
  }
}
