// The colours of a measure, and its histogram with the colour scale.

import { interpolateViridis } from "d3-scale-chromatic";

// The colours of the figures of the manual: without the darkest ones, in which the shape would not be visible.
const STEPS = 255;
const INVERTED_COLOUR = [228, 0, 110]; // after the others, with a hue that the scale does not have
const palette = Array.from({ length: STEPS }, (_, i) =>
  interpolateViridis(0.12 + (0.88 * i) / (STEPS - 1))
    .match(/[0-9a-f]{2}/g)
    .map((hex) => parseInt(hex, 16)),
);

const css = (colour) => `rgb(${colour.join(" ")})`;

const clamp = (t) => Math.min(Math.max(t, 0), 1);

// A logarithmic scale, or a linear one if the minimum is 0. It ends at the 99th percentile, because a single bad face would hide all
// others.
export function scaleOf({ values, minimum }) {
  const sorted = values.filter(Number.isFinite).sort();
  const most = sorted[Math.floor(0.99 * (sorted.length - 1))] ?? 0;
  if (minimum === 0) {
    const high = most || 1;
    return {
      kind: "linear",
      position: (value) => clamp(value / high),
      tick: (t) => String(Number((t * high).toPrecision(3))),
    };
  }
  const high = Math.max(1.01 * minimum, most);
  const range = Math.log(high / minimum);
  const digits = 3 + Math.max(0, Math.floor(-Math.log10(high / minimum - 1)));
  return {
    kind: "logarithmic",
    position: (value) => clamp(Math.log(value / minimum) / range),
    tick: (t) => String(Number((minimum * Math.exp(t * range)).toPrecision(digits))),
  };
}

// The colours, and the index of the colour of each face
export function shadesOf({ values, classes }, scale, inverted) {
  const colours = classes ? classes.map(({ colour }) => colour) : palette;
  const shades = Uint16Array.from(values, (value) =>
    classes ? value : Math.round((STEPS - 1) * scale.position(value)),
  );
  for (const f of inverted) shades[f] = colours.length;
  return { shades, colours: [...colours, INVERTED_COLOUR] };
}

const [LEFT, RIGHT, TOP, BASE, BINS] = [8, 292, 16, 112, 48];
const xOf = (t) => LEFT + t * (RIGHT - LEFT);

function element(name, attributes, text = "") {
  const result = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.textContent = text;
  return result;
}

const MOST_CLASSES = 8;

const rowOf = (i) => TOP + 19 * i;
const invertedText = (n) => (n === 1 ? "1 inverted face" : `${n} inverted faces`);

// A square in a colour and its meaning
const swatch = (row, colour, text) => [
  element("rect", { x: LEFT, y: rowOf(row) - 10, width: 12, height: 12, fill: css(colour), stroke: "currentColor" }),
  element("text", { x: LEFT + 20, y: rowOf(row) }, text),
];

function draw(svg, elements, height) {
  svg.replaceChildren(...elements);
  svg.setAttribute("viewBox", `0 0 300 ${height}`);
}

// Colours, names and fractions of the faces of the largest classes
export function drawClasses(svg, { title, values, classes }, numberOfInverted) {
  const counts = new Array(classes.length).fill(0);
  for (const value of values) ++counts[value];
  const largest = [...counts.keys()].filter((k) => counts[k]).sort((k, l) => counts[l] - counts[k]);
  const rows = largest.slice(0, MOST_CLASSES).map((k) => {
    return {
      colour: classes[k].colour,
      name: classes[k].name,
      percent: ((100 * counts[k]) / values.length).toFixed(1),
    };
  });
  const elements = rows.flatMap(({ colour, name, percent }, i) => [
    ...swatch(i, colour, name),
    element("text", { x: RIGHT, y: rowOf(i), "text-anchor": "end" }, `${percent} %`),
  ]);
  if (numberOfInverted) elements.push(...swatch(rows.length, INVERTED_COLOUR, invertedText(numberOfInverted)));
  draw(svg, elements, rowOf(rows.length + (numberOfInverted ? 1 : 0)) - 8);
  const texts = rows.map(({ name, percent }) => `${name}: ${percent} % of the faces`);
  svg.setAttribute("aria-label", `Colors of ${title}. ${texts.join("; ")}`);
  const omitted = largest.length - rows.length;
  return `Percentages are fractions of the faces${omitted > 0 ? `; ${omitted} smaller classes are not listed` : ""}.`;
}

// The histogram over the faces, with the colour scale; returns its explanation.
export function drawHistogram(svg, measure, scale, numberOfInverted) {
  const counts = new Array(BINS).fill(0);
  for (const value of measure.values) ++counts[Math.min(Math.floor(BINS * scale.position(value)), BINS - 1)];
  const highest = Math.max(...counts);
  const width = (RIGHT - LEFT) / BINS;
  const bars = counts.map((count, i) => {
    const height = (count / highest) * (BASE - TOP);
    const fill = css(palette[Math.round(((i + 0.5) / BINS) * (STEPS - 1))]);
    return element("rect", { x: LEFT + i * width, y: BASE - height, width, height, fill });
  });
  const colours = palette.map((colour, i) => {
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
  const percent = Number(((100 * highest) / measure.values.length).toPrecision(2)); // not 1.0e+2
  const most = element("text", { x: RIGHT, y: 10, "text-anchor": "end" }, `highest bar: ${percent} % of the faces`);
  const elements = [...bars, ...colours, ...ticks, most];
  if (numberOfInverted) {
    const [square, text] = swatch(0, INVERTED_COLOUR, invertedText(numberOfInverted));
    square.setAttribute("y", BASE + 42);
    text.setAttribute("y", BASE + 52);
    elements.push(square, text);
  }
  draw(svg, elements, BASE + (numberOfInverted ? 58 : 36));
  svg.setAttribute(
    "aria-label",
    `Histogram of ${measure.title} over the faces, from ${scale.tick(0)} to ${scale.tick(1)} and more`,
  );
  return (
    `The bars count the faces with each value. The color scale is ${scale.kind}, from dark violet to yellow; ` +
    `the largest 1 % of the values share the last color.`
  );
}

// Marks the value of a face.
export function markValue(svg, scale, value) {
  svg.querySelector(".value")?.remove();
  const x = xOf(scale.position(value)) - 1;
  svg.append(element("rect", { class: "value", x, y: TOP, width: 2, height: BASE - TOP + 17 }));
}
