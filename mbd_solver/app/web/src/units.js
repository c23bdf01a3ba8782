// Numbers as people read them: 12340 N is 12.34 kN.

const kPrefixes = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "\u00b5"],
];

const kWithPrefix = /^(N|J|Pa|W|N m)$/; // large ones too; lengths, angles and times get small ones only
const kSmall = /^(m|rad|s|m\/s|rad\/s)$/;

// The factor and the unit in which a size of this unit is best written.
export function scaleFor(unit, largest) {
  const any = kWithPrefix.test(unit);
  if (!(largest > 0) || !(any || kSmall.test(unit))) return { factor: 1, unit: unit === "-" ? "" : unit };
  for (const [size, letter] of kPrefixes)
    if (largest >= size && (any || size <= 1)) return { factor: 1 / size, unit: letter + unit };
  return { factor: 1e6, unit: `\u00b5${unit}` };
}

export function short(value, digits = 4) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  return size >= 1e5 || size < 1e-3 ? rounded.toExponential() : String(rounded);
}

export function withUnit(value, unit) {
  const { factor, unit: text } = scaleFor(unit, Math.abs(value));
  return `${short(value * factor)} ${text}`.trim();
}
