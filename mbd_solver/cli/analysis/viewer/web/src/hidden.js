// Which grains can be seen. A bed shows its outermost grains alone, and a machine without graphics card is slow at drawing
// points: those behind others are left out. Nothing that would be seen is lost: a cell of the mask counts as covered
// only when one disc covers all of it, and a grain is left out only when nearer ones cover every cell that it touches.
// While the picture moves a rough answer does: a cell is its centre alone, and slivers narrower than a cell may be lost.

const kFineness = 2.5;  // cells of the mask in the radius of a grain
const kRough = 1.5;     // likewise, of a rough answer
const kDepths = 65536;

export class HiddenGrains {
  constructor(count) {
    this.x = new Float32Array(count);       // of the disc, in cells
    this.y = new Float32Array(count);
    this.r = new Float32Array(count);
    this.depth = new Float32Array(count);   // along the line of sight [m]
    this.order = new Uint32Array(count);
    this.places = new Uint32Array(kDepths + 1);
    this.seen = new Uint32Array(count);     // the result: indices, the nearest first
    this.mask = new Uint8Array(0);
  }

  // a, b: frames of four 16-bit numbers; mix between them; box { low, size }; radius [m]; clip: normal, distance;
  // width, height of the picture [pixels]; rough: see above. Returns how many stand in `seen`.
  find({ a, b, mix, box, radius, camera, clip, width, height, rough }) {
    const view = camera.matrixWorldInverse.elements, P = camera.projectionMatrix.elements;
    const perPixel = P[5] * 0.5 * height;  // pixels of a metre at the distance of one metre
    const n = radius.length;
    const { low, size } = box;
    let nearest = Infinity, farthest = 0, sum = 0, count = 0;
    for (let i = 0; i < n; ++i) {
      const k = 4 * i;
      if (a[k] === 65535) continue;
      const m = b[k] === 65535 ? 0 : mix;
      const x = low[0] + (size[0] * (a[k] + m * (b[k] - a[k]))) / 65534;
      const y = low[1] + (size[1] * (a[k + 1] + m * (b[k + 1] - a[k + 1]))) / 65534;
      const z = low[2] + (size[2] * (a[k + 2] + m * (b[k + 2] - a[k + 2]))) / 65534;
      if (x * clip.x + y * clip.y + z * clip.z > clip.w) continue;
      const depth = -(view[2] * x + view[6] * y + view[10] * z + view[14]);
      if (depth < camera.near) continue;
      this.x[i] = 0.5 * width + (perPixel * (view[0] * x + view[4] * y + view[8] * z + view[12])) / depth;
      this.y[i] = 0.5 * height + (perPixel * (view[1] * x + view[5] * y + view[9] * z + view[13])) / depth;
      this.r[i] = Math.max(0.5, (perPixel * radius[i]) / depth);
      const r = this.r[i];
      if (this.x[i] < -r || this.y[i] < -r || this.x[i] > width + r || this.y[i] > height + r) continue;
      this.depth[i] = depth;
      nearest = Math.min(nearest, depth);
      farthest = Math.max(farthest, depth);
      sum += r;
      this.seen[count++] = i;
    }
    this.sort(count, nearest, farthest);
    const cell = sum / count / (rough ? kRough : kFineness);
    return this.cover(count, Math.min(8, Math.max(0.75, cell)), width, height, rough);
  }

  // The first `count` of `seen` into `order`, the nearest first.
  sort(count, nearest, farthest) {
    const { places, seen, order, depth } = this;
    const scale = (kDepths - 1) / (farthest - nearest || 1);
    places.fill(0);
    for (let j = 0; j < count; ++j) ++places[((depth[seen[j]] - nearest) * scale | 0) + 1];
    for (let d = 1; d <= kDepths; ++d) places[d] += places[d - 1];
    for (let j = 0; j < count; ++j) order[places[(depth[seen[j]] - nearest) * scale | 0]++] = seen[j];
  }

  cover(count, cell, width, height, rough) {
    const columns = Math.ceil(width / cell), rows = Math.ceil(height / cell);
    if (this.mask.length !== columns * rows) this.mask = new Uint8Array(columns * rows);
    const { mask, order, seen } = this;
    mask.fill(0);
    let found = 0;
    for (let j = 0; j < count; ++j) {
      const i = order[j], x = this.x[i] / cell, y = this.y[i] / cell, r = this.r[i] / cell, rr = r * r;
      const left = Math.max(0, Math.floor(x - r)), right = Math.min(columns - 1, Math.floor(x + r));
      const bottom = Math.max(0, Math.floor(y - r)), top = Math.min(rows - 1, Math.floor(y + r));
      let open = false;
      if (rough) {
        let touched = false;
        for (let v = bottom; v <= top; ++v) {
          const dy = v + 0.5 - y, reach = Math.sqrt(Math.max(0, rr - dy * dy));
          const last = Math.min(right, Math.floor(x + reach - 0.5));
          for (let k = v * columns + Math.max(left, Math.ceil(x - reach - 0.5)), end = v * columns + last; k <= end; ++k) {
            touched = true;
            if (mask[k]) continue;
            mask[k] = 1;
            open = true;
          }
        }
        // A grain between four centres: the cell that it stands in says whether nearer ones cover it.
        if (!touched) open = !mask[Math.min(rows - 1, Math.max(0, Math.floor(y))) * columns + Math.min(columns - 1, Math.max(0, Math.floor(x)))];
        if (open) seen[found++] = i;
        continue;
      }
      for (let v = bottom; v <= top; ++v) {
        const dy = Math.abs(v + 0.5 - y), inY = Math.max(0, dy - 0.5), outY = dy + 0.5;
        for (let u = left; u <= right; ++u) {
          if (mask[v * columns + u]) continue;
          const dx = Math.abs(u + 0.5 - x), inX = Math.max(0, dx - 0.5), outX = dx + 0.5;
          if (inX * inX + inY * inY > rr) continue;
          open = true;
          if (outX * outX + outY * outY <= rr) mask[v * columns + u] = 1;
        }
      }
      if (open) seen[found++] = i;
    }
    return found;
  }
}
