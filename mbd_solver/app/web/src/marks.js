// Places of bodies, joints and forces as the run recorded them: four vectors per mark and frame (run/observe/marks.h of the solver).
import { given, indexBefore, takeNumbers } from "./page.js";

const kNumbers = 12;  // of a mark

export class Marks {
  constructor(spec) {
    this.times = spec.times;
    this.list = spec.list;
    this.byName = new Map(spec.list.map((mark, i) => [`${mark.kind}:${mark.name}`, i]));
  }
  async load() {
    this.numbers = given.get("marks") ?? (await takeNumbers("marks", Float32Array));
  }
  // One more frame of a run in progress.
  add(t, numbers) {
    const used = this.times.length * numbers.length;
    if (used + numbers.length > this.numbers.length) {
      const longer = new Float32Array(2 * (used + numbers.length));
      longer.set(this.numbers.subarray(0, used));
      this.numbers = longer;
    }
    this.numbers.set(numbers, used);
    this.times.push(t);
  }

  // The frames around t, and the share between them.
  moment(t, smooth) {
    const k = indexBefore(this.times, t), next = smooth ? Math.min(k + 1, this.times.length - 1) : k;
    const span = this.times[next] - this.times[k];
    return { k, next, mix: span > 0 ? Math.min(1, Math.max(0, (t - this.times[k]) / span)) : 0 };
  }
  // Vector v (0 ... 3) of mark i.
  vector(i, v, { k, next, mix }) {
    const size = kNumbers * this.list.length, a = k * size + kNumbers * i + 3 * v, b = next * size + kNumbers * i + 3 * v, n = this.numbers;
    return [n[a] + mix * (n[b] - n[a]), n[a + 1] + mix * (n[b + 1] - n[a + 1]), n[a + 2] + mix * (n[b + 2] - n[a + 2])];
  }
  // Where mark i has been: one point per frame.
  way(i) {
    return this.times.map((_, k) => this.vector(i, 0, { k, next: k, mix: 0 }));
  }
  index(kind, name) {
    return this.byName.get(`${kind}:${name}`) ?? -1;
  }
}
