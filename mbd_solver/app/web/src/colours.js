// Colours that people with colour-blindness can tell apart.

// The page is dark where the user's system is; pictures (link.js) are light.
let onPaper = false;  // what is printed is light, too
export const isDark = () => !onPaper && window.matchMedia("(prefers-color-scheme: dark)").matches && !/picture=1/.test(window.location.hash);

// Calls draw() when the colours of the page have changed.
export function whenInksChange(draw, signal) {
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw, { signal });
  for (const event of ["beforeprint", "afterprint"])
    window.addEventListener(event, () => {
      onPaper = event === "beforeprint";
      draw();
    }, { signal });
}

// Okabe and Ito, as in the drawn plots.
export const kSeries = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"];
const kSeriesOnDark = ["#4da3ff", "#ff8c42", "#2fcf9f", "#e3a0c6", "#f0b53a", "#7fcdf5", "#f2f2f2", "#aaaaaa"];
export const seriesColour = (i) => (isDark() ? kSeriesOnDark : kSeries)[i];
// Of plots and of the ground under a picture.
export const inks = () => (isDark() ? { ink: "#d5d9dd", grid: "#3a424b", stage: 0x1d2228, lines: 0x444d57, axes: 0x7a8794, limit: "#ff6b6b" } : { ink: "#333", grid: "#e4e4e4", stage: 0xeef1f4, lines: 0xc5ccd3, axes: 0x8896a3, limit: "#b91c1c" });

export const kBodies = ["#8fa6bd", "#c98b5f", "#7fb09a", "#c79bb5", "#d9b668", "#93c4dd", "#9a9a9a", "#b7b08f"];

// One colour per body. Bodies that differ in their numbers only have the same part: leg_1_rod, leg_2_rod.
export function bodyColours(names) {
  const parts = names.map((name) => name.replace(/\d+/g, "#")), order = [...new Set(parts)];
  return parts.map((part) => kBodies[order.indexOf(part) % kBodies.length]);
}

// Each with five stops: share of the scale, and red, green, blue in 0 ... 255.
export const kMaps = {
  // Sand at rest, as `footfall view --pictures` draws it.
  sand: { shares: [0, 0.1, 0.3, 0.65, 1], stops: [[233, 223, 199], [214, 178, 104], [127, 174, 138], [31, 111, 168], [46, 20, 90]] },
  // cividis
  stress: { shares: [0, 0.25, 0.5, 0.75, 1], stops: [[0, 34, 78], [65, 77, 107], [124, 123, 120], [188, 175, 111], [254, 232, 56]] },
};

export function cssGradient(map) {
  return `linear-gradient(to top, ${map.stops.map((c, i) => `rgb(${c.join(",")}) ${100 * map.shares[i]}%`).join(", ")})`;
}
