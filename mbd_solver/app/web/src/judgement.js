// What the run is judged by: requirements, peaks and errors; and of two runs the keys in which their scenes differ.
function make(tag, text, attributes = {}) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}
function folded(title, rows, open) {
  const details = make("details", undefined, open ? { open: "" } : {}), table = make("table", undefined, { class: "judged" });
  details.append(make("summary", title), table);
  table.append(...rows);
  return details;
}
const row = (cells, name = "") => {
  const line = make("tr", undefined, name ? { class: name } : {});
  line.append(...cells.map((cell) => {
    const place = make("td");
    place.append(cell);
    return place;
  }));
  return line;
};

// seek(t): shows this time.
export function showJudgement(place, run, seek) {
  const { requirements = [], peaks = [], differences = [] } = run;
  const parts = [];
  if (requirements.length > 0) {
    const missed = requirements.filter(([, verdict]) => verdict !== "met").length;
    const title = missed === 0 ? `Requirements: all ${requirements.length} met` : `Requirements: ${missed} of ${requirements.length} not met`;
    parts.push(folded(title, requirements.map(([text, verdict]) => row([make("span", text, { class: verdict === "met" ? "met" : "missed" })], "wide")), true));
  }
  if (peaks.length > 0)
    parts.push(folded("Peaks and errors", peaks.map(([name, value, time]) => {
      const when = time === null ? "" : make("button", `${value} at ${Number(time.toPrecision(4))} s`, { title: "show this time" });
      if (time !== null) when.addEventListener("click", () => seek(time));
      return row([name, time === null ? value : when]);
    }), true));
  if (run.other) {
    const rows = differences.map(([key, a, b]) => row([key, `${a} \u2192 ${b}`]));
    parts.push(folded(rows.length > 0 ? `Scenes: ${rows.length} keys differ` : "Scenes: no key differs", rows, rows.length < 12));
  }
  place.append(...parts);
}
