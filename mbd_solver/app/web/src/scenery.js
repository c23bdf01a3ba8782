// The surroundings: meshes of the script that no body moves, seen through, and the block of a bed without drawn grains.
import * as three from "three";
import { joinPlanes } from "./decode.js";
import { given, takeChunk } from "./page.js";
import { lightOn } from "./shading.js";

const kMesh = [0.55, 0.6, 0.66], kBed = 0xd9cfb4;

export class Scenery {
  constructor(run) {
    this.run = run;
    this.object = new three.Group();
    this.box = new three.Box3();
    if (run.bed) this.box.union(new three.Box3(new three.Vector3(...run.bed.low), new three.Vector3(...run.bed.high)));
  }
  async load() {
    for (let k = 0; k < (this.run.meshes ?? []).length; ++k) {
      const chunk = given.has(`mesh-${k}`) ? given.get(`mesh-${k}`) : joinPlanes(await takeChunk(`mesh-${k}`), Float32Array);
      this.corners = [...(this.corners ?? []), chunk];
      for (let i = 0; i < chunk.length; i += 3) this.box.expandByPoint(new three.Vector3(chunk[i], chunk[i + 1], chunk[i + 2]));
    }
  }
  build() {
    for (const corners of this.corners ?? []) this.object.add(this.mesh(corners));
    if (this.run.bed) this.object.add(this.bed(this.run.bed));
    return this.object;
  }
  mesh(corners) {
    const colours = new Float32Array(corners.length), at = (i) => [corners[i], corners[i + 1], corners[i + 2]];
    for (let i = 0; i < corners.length; i += 9) {
      const [a, b, c] = [at(i), at(i + 3), at(i + 6)], u = b.map((x, k) => x - a[k]), v = c.map((x, k) => x - a[k]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], size = Math.hypot(...n) || 1, side = n[2] < 0 ? -1 : 1;
      const light = lightOn(...n.map((x) => (side * x) / size));
      for (let k = 0; k < 9; ++k) colours[i + k] = kMesh[k % 3] * (0.4 + 0.6 * light);
    }
    const geometry = new three.BufferGeometry();
    geometry.setAttribute("position", new three.BufferAttribute(corners, 3));
    geometry.setAttribute("color", new three.BufferAttribute(colours, 3));
    const group = new three.Group();
    const sheet = new three.Mesh(geometry, new three.MeshBasicMaterial({ vertexColors: true, side: three.DoubleSide, transparent: true, opacity: 0.28, depthWrite: false }));
    sheet.renderOrder = 3;
    group.add(sheet, new three.LineSegments(new three.EdgesGeometry(geometry, 25), new three.LineBasicMaterial({ color: 0x5f6b78 })));
    return group;
  }
  bed({ low, high }) {
    const size = high.map((h, k) => h - low[k]), box = new three.BoxGeometry(...size), group = new three.Group();
    const sides = new three.Mesh(box, new three.MeshBasicMaterial({ color: kBed, transparent: true, opacity: 0.55, depthWrite: false }));
    sides.renderOrder = 3;
    group.add(sides, new three.LineSegments(new three.EdgesGeometry(box), new three.LineBasicMaterial({ color: 0x8d8468 })));
    group.position.set(...low.map((l, k) => l + size[k] / 2));
    return group;
  }
}
