// From the page's text to numbers. A chunk is base64 of zlib-compressed bytes, written by packed_series.cpp.

export function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

export async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// One frame after the other: each holds the change of every 16-bit number since the frame before, zigzag coded (0, -1,
// 1, -2 ... are 0, 1, 2, 3 ...), all low bytes first, then all high bytes.
export class SeriesDecoder {
  constructor(length) {
    this.last = new Uint16Array(length);
  }
  next(bytes) {
    const n = this.last.length;
    if (bytes.length !== 2 * n) throw new Error(`a frame has ${bytes.length} bytes, expected ${2 * n}`);
    const values = new Uint16Array(n);
    for (let i = 0; i < n; ++i) {
      const z = bytes[i] | (bytes[n + i] << 8);
      values[i] = this.last[i] + ((z >>> 1) ^ -(z & 1));
    }
    this.last = values;
    return values;
  }
}

// 32-bit numbers whose four bytes stand in four planes, lowest first.
export function joinPlanes(bytes, Kind) {
  const n = bytes.length / 4;
  const joined = new Uint8Array(bytes.length);
  for (let k = 0; k < 4; ++k) for (let i = 0; i < n; ++i) joined[4 * i + k] = bytes[k * n + i];
  return new Kind(joined.buffer);
}
