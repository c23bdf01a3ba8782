// Where an eye is: azimuth and elevation about level axes.
import { cross, plus, unit } from "./shapes.js";

// Level axes: x as near to that of W as it can be, and up.
export function level(up) {
  const x = unit(plus([1, 0, 0], up, -up[0]), [0, 1, 0]);
  return { x, y: cross(up, x), z: up };
}
// The direction to an eye at this azimuth and elevation [deg].
export function wayToEye(azimuth, elevation, up) {
  const a = (azimuth * Math.PI) / 180, e = (elevation * Math.PI) / 180, { x, y, z } = level(up);
  return [0, 1, 2].map((k) => Math.cos(e) * Math.cos(a) * x[k] + Math.cos(e) * Math.sin(a) * y[k] + Math.sin(e) * z[k]);
}
