// The mechanism at one time, painted by the processor: as view.html paints it while it plays on a machine without a graphics card.
import { wayToEye } from "./eye.js";
import { Facets, kDepths } from "./facets.js";
import { Marks } from "./marks.js";
import { Shapes, cross, dot, length, minus, unit } from "./shapes.js";
import { Surface } from "./surface.js";
import { Symbols } from "./symbols.js";

const kAzimuth = -65, kElevation = 24;               // [deg]
const kReach = Math.tan((35 / 360) * Math.PI);        // half of the picture's height, at the distance of 1
const kMargin = 1.06, kWidth = 1600, kHeight = 900;   // [pixels]: twice what the page shows, which smooths edges

// The camera, as the facets read it, that sees all of these points.
function cameraOn(points, up) {
  const back = wayToEye(kAzimuth, kElevation, up), right = unit(cross(up, back), [1, 0, 0]), top = cross(back, right), axes = [right, top, back];
  const places = points.map((p) => axes.map((axis) => dot(axis, p)));
  const middle = [0, 1, 2].map((k) => 0.5 * (Math.min(...places.map((x) => x[k])) + Math.max(...places.map((x) => x[k]))));
  const far = Math.max(...places.map((x) => x[2] - middle[2] + (kMargin * Math.max(Math.abs(x[1] - middle[1]), (Math.abs(x[0] - middle[0]) * kHeight) / kWidth)) / kReach));
  const eye = [middle[0], middle[1], middle[2] + far], elements = new Float64Array(16);
  axes.forEach((axis, row) => {
    for (let k = 0; k < 3; ++k) elements[4 * k + row] = axis[k];
    elements[12 + row] = -eye[row];
  });
  return { matrixWorldInverse: { elements }, projectionMatrix: { elements: { 5: 1 / kReach } }, near: far / 500 };
}

export async function paintMechanism(canvas, run) {
  const surface = run.bodies && new Surface(run.bodies, run.bodyNames), marks = run.marks && new Marks(run.marks);
  await surface?.loadFirst();
  await marks?.load();
  const up = unit(run.gravity.map((g) => -g)), first = { k: 0, next: 0, mix: 0 }, points = [];
  if (surface) for (let p = 0; p < surface.spec.points; ++p) points.push(surface.pointOf(surface.frames[0], p));
  marks?.list.forEach((_, i) => points.push(marks.vector(i, 0, first), marks.vector(i, 1, first)));
  const size = length(minus(...[Math.max, Math.min].map((most) => [0, 1, 2].map((k) => points.reduce((found, p) => most(found, p[k]), points[0][k])))));
  const facets = new Facets();
  facets.begin(cameraOn(points, up), kWidth, kHeight);
  surface?.collect(facets);
  const solids = new Shapes(({ sides, rows }) => ({ add: (a, b, r0, r1, tint) => facets.solid(...a, ...b, r0, r1, sides, rows, tint) }));
  if (marks) new Symbols(marks, surface, run.bodyNames, size, up, solids, solids).show(0, false);
  const pixels = new Int32Array(kWidth * kHeight);
  facets.fill(pixels, facets.nearest, (facets.farthest - facets.nearest || 1) / (kDepths - 1));
  Object.assign(canvas, { width: kWidth, height: kHeight });
  const context = canvas.getContext("2d"), image = context.createImageData(kWidth, kHeight);
  for (let v = 0; v < kHeight; ++v)
    for (let u = 0, k = v * kWidth, j = 4 * (kHeight - 1 - v) * kWidth; u < kWidth; ++u, ++k, j += 4) {
      if (pixels[k] === 0) continue;
      for (let rgb = 0; rgb < 3; ++rgb) image.data[j + rgb] = (((pixels[k] >>> (26 - 6 * rgb)) & 63) * 255) / 63;
      image.data[j + 3] = 255;
    }
  context.putImageData(image, 0, 0);
}
