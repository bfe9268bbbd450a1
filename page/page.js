// A surface and its map side by side: reads the data in the page and connects its parts.

import { CanvasPainter, PAINTS, WebGLPainter } from "./draw.js";
import { drawClasses, drawHistogram, markValue, scaleOf, shadesOf } from "./scale.js";
import { firstOnRay, pointOf, readSurfaces } from "./surfaces.js";
import { View, fit, startOf } from "./view.js";

const byId = (id) => document.getElementById(id);
const surfaces = readSurfaces();
const { facts, measures } = surfaces;
const scales = measures.map((one) => (one.classes ? null : scaleOf(one)));
const [colour, morph, together] = ["colour", "morph", "together"].map(byId);
const area = byId("views");

let painter;
let measure = measures.findIndex(({ name }) => name === facts.measure);
let mark = null;
let isDirty = true;
let isAtRest = false;
let isFollowing = false;
const redraw = () => (isDirty = true);

const start = startOf(surfaces.sides[0]);
if (facts.has_one_frame) fit(surfaces.sides, start);
else for (const side of surfaces.sides) fit([side], start);
const views = ["view-left", "view-right"].map((id) => new View(byId(id), start, { onMove, onPoint, onReset }));
const captions = views.map(({ element }) => element.parentElement.querySelector("figcaption"));
const middle = facts.has_one_frame ? "mean" : "halfway";
const patternTitle = facts.has_sphere ? "meridians and parallels" : "grid of the left side";
const morphs = () => [morph.valueAsNumber, 1];

function onMove(view) {
  if (isFollowing) return;
  isFollowing = true; // because following also calls this function
  if (together.checked) for (const other of views) if (other !== view) other.follow(view);
  isFollowing = false;
  redraw();
}

function onPoint(view, x, y) {
  const hit = firstOnRay(surfaces, view.ray(x, y), morphs()[views.indexOf(view)]);
  if (!hit) return;
  mark = hit;
  describePoint();
  redraw();
}

function onReset() {
  morph.value = 0;
  together.checked = true;
  for (const view of views) view.reset();
  describeMorph();
}

const number = (value) => (Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "infinite");

// Entries are a text, or several texts in an array.
function fill(list, entries) {
  const texts = Object.entries(entries).flatMap(([name, value]) => [
    ["dt", name],
    ...[value].flat().map((text) => ["dd", text]),
  ]);
  list.replaceChildren(
    ...texts.map(([tag, text]) => Object.assign(document.createElement(tag), { textContent: text })),
  );
}

function describePoint() {
  const { face, weights } = mark;
  const vertex = surfaces.vertices[3 * face + weights.indexOf(Math.max(...weights))];
  const { center, scale, title } = surfaces.sides[0];
  const unit = 10 ** (Math.floor(Math.log10(scale)) - 5); // coordinates are rounded to multiples of it
  const point = pointOf(surfaces, mark, 0).map((x, k) =>
    Number((unit * Math.round((center[k] + scale * x) / unit)).toPrecision(6)),
  );
  const values = measures.map(({ name, title, values, classes }) =>
    classes ? [title, classes[values[face]].name] : [name, number(values[face])],
  );
  const inverted = surfaces.inverted.includes(face) ? " (inverted)" : "";
  const location = surfaces.numbers
    ? Object.fromEntries(
        surfaces.numbers.map((faces, i) => [`Face of ${surfaces.sides[i].title}`, String(faces[face])]),
      )
    : { Face: face + inverted, "Nearest vertex": String(vertex) };
  byId("no-point").hidden = true;
  fill(byId("point"), { ...location, [`Point on ${title}`]: point.join(", "), ...Object.fromEntries(values) });
  Object.assign(byId("point").dataset, { face, vertex });
  if (scales[measure] && !byId("histogram").hasAttribute("hidden"))
    markValue(byId("histogram"), scales[measure], measures[measure].values[face]);
}

// What the colours mean
function describeColours() {
  const isMeasure = PAINTS[colour.value] === undefined;
  const { title, meaning } = isMeasure
    ? measures[measure]
    : colour.value === "plain"
      ? { title: "plain", meaning: "the shape without colors" }
      : {
          title: patternTitle,
          meaning: facts.has_sphere
            ? "a grid of 15 degrees on the sphere, and the same grid on the surface: the hue is the longitude, and lighter " +
              "colors are farther north"
            : "planes through the left side, and their images on the right side",
        };
  byId("measure").textContent = title[0].toUpperCase() + title.slice(1);
  byId("meaning").textContent = `${meaning[0].toUpperCase()}${meaning.slice(1)}.`;
  byId("histogram").toggleAttribute("hidden", !isMeasure);
  const draw = scales[measure] ? drawHistogram : drawClasses;
  byId("scale").textContent = isMeasure
    ? draw(byId("histogram"), measures[measure], scales[measure], surfaces.inverted.length)
    : "";
}

function choose() {
  const chosen = measures.findIndex(({ name }) => name === colour.value);
  if (chosen >= 0) measure = chosen;
  describeColours();
  painter.paintFaces(shadesOf(measures[measure], scales[measure], surfaces.inverted));
  if (mark) describePoint();
  redraw();
}

// What the left side shows during a morph
function describeMorph() {
  const { left, right } = facts;
  const fraction = morph.valueAsNumber;
  const named = { 0: left.title, 0.5: middle, 1: right.title }[fraction];
  const text = named ?? `${Math.round(100 * fraction)} % towards ${right.title}`;
  captions[0].textContent = text;
  morph.setAttribute("aria-valuetext", text);
  redraw();
}

function showMark() {
  views.forEach((view, i) => {
    const element = view.element.querySelector(".mark");
    element.hidden = !mark;
    if (!mark) return;
    const { x, y } = view.project(pointOf(surfaces, mark, morphs()[i]));
    element.style.left = `${50 + 50 * x}%`;
    element.style.top = `${50 - 50 * y}%`;
  });
}

// Tests all faces, and therefore runs only while nothing moves.
function showIfHidden() {
  if (!mark) return;
  views.forEach((view, i) => {
    const point = pointOf(surfaces, mark, morphs()[i]);
    const { x, y } = view.project(point);
    const first = firstOnRay(surfaces, view.ray(x, y), morphs()[i]);
    const isVisible = first && Math.hypot(...pointOf(surfaces, first, morphs()[i]).map((x, k) => x - point[k])) < 1e-3;
    view.element.querySelector(".mark").classList.toggle("behind", !isVisible);
  });
}

function resize() {
  painter.resize(area.clientWidth, area.clientHeight);
  for (const view of views) view.resize();
  redraw();
}

function loop() {
  for (const view of views) view.controls.update();
  if (isDirty) {
    isDirty = isAtRest = false;
    painter.draw(views, morphs(), PAINTS[colour.value] ?? PAINTS.measure);
    showMark();
  } else if (!isAtRest) {
    isAtRest = true;
    showIfHidden();
  }
  requestAnimationFrame(loop);
}

function makePainter() {
  const canvas = area.querySelector("canvas");
  try {
    return new WebGLPainter(canvas, surfaces);
  } catch {
    byId("notice").textContent = "WebGL is not available: drawing is slower, and grids are not shown.";
    byId("notice").hidden = false;
    const fresh = canvas.cloneNode(); // because a canvas may have only one context
    canvas.replaceWith(fresh);
    return new CanvasPainter(fresh, surfaces);
  }
}

function showSummary() {
  const { left, right } = facts;
  const title = facts.has_one_frame
    ? `${left.title} and ${right.title}`
    : left.title + (surfaces.numbers ? `, mapped onto ${right.title}` : "");
  document.title = title;
  byId("title").textContent = title;
  byId("certificate").textContent = facts.certificate;
  byId("certificate").classList.toggle("warning", !facts.one_to_one);
  byId("warning").textContent = facts.warning;
  byId("warning").hidden = !facts.warning;
  views.forEach(({ element }, i) => {
    captions[i].textContent = surfaces.sides[i].title;
    element.setAttribute("aria-label", `${i ? "Right" : "Left"} side: ${surfaces.sides[i].title}`);
  });
  showStatistics();
  fill(byId("summary"), facts.summary);
  const slider = morph.closest(".slider");
  slider.hidden = !facts.morphs;
  slider.querySelectorAll("span").forEach((mark, i) => {
    mark.textContent = mark.title = [left.title, middle, right.title][i];
  });
}

function showStatistics() {
  const measured = measures.filter(({ statistics }) => statistics);
  const columns = [...new Set(measured.flatMap(({ statistics }) => Object.keys(statistics)))];
  const cell = (tag, text, scope) => Object.assign(document.createElement(tag), { textContent: text, ...scope });
  const row = (cells) => {
    const result = document.createElement("tr");
    result.append(...cells);
    return result;
  };
  const names = columns.map((name) => (name === "deviation" ? "standard deviation" : name));
  const rows = measured.map(({ title, statistics }) =>
    row([
      cell("th", title, { scope: "row" }),
      ...columns.map((name) => cell("td", name in statistics ? number(statistics[name] ?? Infinity) : "")),
    ]),
  );
  const head = row(["measure", ...names].map((name) => cell("th", name, { scope: "col" })));
  byId("distortion").append(head, ...rows);
}

painter = makePainter();
for (const { name, title } of measures) colour.add(new Option(title, name, false, name === facts.measure));
if (painter instanceof WebGLPainter) colour.add(new Option(patternTitle, "pattern"));
colour.add(new Option("plain", "plain"));

showSummary();
describeMorph();
colour.addEventListener("change", choose);
morph.addEventListener("input", describeMorph);
together.addEventListener("change", () => onMove(views[0]));
byId("reset").addEventListener("click", onReset);
area.querySelector("canvas").addEventListener("webglcontextrestored", redraw);
new ResizeObserver(resize).observe(area);
choose();
resize();
loop();
