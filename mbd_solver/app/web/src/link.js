// The address of a page says what it shows: #t=0.25&camera=-65,24&grains=force. Keys:
//   t         time [s]                        camera   azimuth, elevation [deg], zoom, and the point that is looked at [m]
//   grains    colour of the grains            bodies   colour of the bodies
//   hide      layers that are off, names of kLayers, "symbols", "arrows" or "grains", "bodies"
//   track     body:NAME, joint:NAME           names    1: names are shown
//   clip      axis, share of the box          picture  1: nothing but the picture
export function readLink(hash = window.location.hash) {
  const found = {};
  for (const part of hash.replace(/^#/, "").split("&")) {
    const [key, ...rest] = part.split("=");
    if (key) found[decodeURIComponent(key)] = decodeURIComponent(rest.join("="));
  }
  return found;
}

export function linkOf(entries) {
  const parts = Object.entries(entries).filter(([, value]) => value !== "" && value !== undefined && value !== null);
  return `#${parts.map(([key, value]) => `${key}=${encodeURIComponent(value).replace(/%2C/g, ",").replace(/%3A/g, ":")}`).join("&")}`;
}

export const numbersIn = (text) => (text ?? "").split(",").map(Number).filter(Number.isFinite);
