// The colours of a measure, and its histogram above the legend.

import { interpolateViridis } from "d3-scale-chromatic";

// Those of the figures of the manual: without the darkest part, in which the shape would not be seen.
const STEPS = 255;
const FOLDED_COLOUR = [228, 0, 110]; // behind the others, in a hue that the scale does not have
const palette = Array.from({ length: STEPS }, (_, i) =>
  interpolateViridis(0.12 + (0.88 * i) / (STEPS - 1))
    .match(/[0-9a-f]{2}/g)
    .map((hex) => parseInt(hex, 16)),
);

const css = (colour) => `rgb(${colour.join(" ")})`;

const clamp = (t) => Math.min(Math.max(t, 0), 1);

// Equal ratios look alike; equal differences if the minimum is 0. Ends at what one face in a hundred exceeds, as a single bad face
// would hide all others.
export function scaleOf({ values, minimum }) {
  const sorted = values.filter(Number.isFinite).sort();
  const most = sorted[Math.floor(0.99 * (sorted.length - 1))] ?? 0;
  if (minimum === 0) {
    const high = most || 1;
    return { position: (value) => clamp(value / high), tick: (t) => String(Number((t * high).toPrecision(3))) };
  }
  const high = Math.max(1.01 * minimum, most);
  const range = Math.log(high / minimum);
  const digits = 3 + Math.max(0, Math.floor(-Math.log10(high / minimum - 1)));
  return {
    position: (value) => clamp(Math.log(value / minimum) / range),
    tick: (t) => String(Number((minimum * Math.exp(t * range)).toPrecision(digits))),
  };
}

// The colours, and for each face the index of its own.
export function shadesOf({ values, classes }, scale, folded) {
  const colours = classes ? classes.map(({ colour }) => colour) : palette;
  const shades = Uint16Array.from(values, (value) =>
    classes ? value : Math.round((STEPS - 1) * scale.position(value)),
  );
  for (const f of folded) shades[f] = colours.length;
  return { shades, colours: [...colours, FOLDED_COLOUR] };
}

const [LEFT, RIGHT, TOP, BASE, BINS] = [8, 292, 14, 130, 48];
const xOf = (t) => LEFT + t * (RIGHT - LEFT);

function element(name, attributes, text = "") {
  const result = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.textContent = text;
  return result;
}

const MOST_CLASSES = 8;

// The largest classes, with the shares of the faces that they have.
export function drawClasses(svg, { name, values, classes }) {
  const counts = new Array(classes.length).fill(0);
  for (const value of values) ++counts[value];
  const largest = [...counts.keys()].filter((k) => counts[k]).sort((k, l) => counts[l] - counts[k]);
  const rows = largest.slice(0, MOST_CLASSES).flatMap((k, i) => {
    const y = TOP + 19 * i;
    const share = ((100 * counts[k]) / values.length).toFixed(1);
    return [
      element("rect", { x: LEFT, y: y - 10, width: 12, height: 12, fill: css(classes[k].colour) }),
      element("text", { x: LEFT + 20, y }, classes[k].name),
      element("text", { x: RIGHT, y, "text-anchor": "end" }, `${share} %`),
    ];
  });
  svg.replaceChildren(...rows);
  svg.setAttribute("aria-label", `The largest of ${largest.length} classes of ${name}, by their shares of the faces`);
}

export function drawHistogram(svg, measure, scale) {
  const counts = new Array(BINS).fill(0);
  for (const value of measure.values) ++counts[Math.min(Math.floor(BINS * scale.position(value)), BINS - 1)];
  const highest = Math.max(...counts);
  const width = (RIGHT - LEFT) / BINS;
  const bars = counts.map((count, i) => {
    const height = (count / highest) * (BASE - TOP);
    const fill = css(palette[Math.round(((i + 0.5) / BINS) * (STEPS - 1))]);
    return element("rect", { x: LEFT + i * width, y: BASE - height, width, height, fill });
  });
  const legend = palette.slice(0, STEPS).map((colour, i) => {
    return element("rect", {
      x: xOf(i / STEPS),
      y: BASE + 5,
      width: (1.5 * (RIGHT - LEFT)) / STEPS,
      height: 10,
      fill: css(colour),
    });
  });
  const ticks = [0, 1 / 3, 2 / 3, 1].flatMap((t) => {
    const anchor = t === 0 ? "start" : t === 1 ? "end" : "middle";
    return [
      element("rect", { x: xOf(t) - 0.5, y: BASE + 15, width: 1, height: 4 }),
      element("text", { x: xOf(t), y: BASE + 31, "text-anchor": anchor }, (t === 1 ? "\u2265 " : "") + scale.tick(t)),
    ];
  });
  const share = Number(((100 * highest) / measure.values.length).toPrecision(2)); // not 1.0e+2
  const most = element("text", { x: RIGHT, y: 9, "text-anchor": "end" }, `highest bar: ${share} % of the faces`);
  svg.replaceChildren(...bars, ...legend, ...ticks, most);
  svg.setAttribute(
    "aria-label",
    `Histogram of ${measure.name} over the faces, from ${scale.tick(0)} to ${scale.tick(1)} and more`,
  );
}

// Shows where the value of a face is.
export function markValue(svg, scale, value) {
  svg.querySelector(".value")?.remove();
  const x = xOf(scale.position(value)) - 1;
  svg.append(element("rect", { class: "value", x, y: TOP, width: 2, height: BASE - TOP + 17 }));
}
