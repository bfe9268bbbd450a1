// A surface and its map side by side: reads what the program has written into the page, and puts its parts together.

import { CanvasPainter, PAINTS, WebGLPainter } from "./draw.js";
import { drawClasses, drawHistogram, markValue, scaleOf, shadesOf } from "./scale.js";
import { firstOnRay, placeOf, readSurfaces } from "./surfaces.js";
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
const views = ["view-left", "view-right"].map((id) => new View(byId(id), start, { onTurn, onPoint }));
const middle = facts.has_one_frame ? "mean" : "half way";
const morphs = () => [morph.valueAsNumber, 1];

function onTurn(view) {
  if (isFollowing) return;
  isFollowing = true; // a view that follows tells that it has turned
  if (together.checked) for (const other of views) if (other !== view) other.follow(view);
  isFollowing = false;
  redraw();
}

function onPoint(view, x, y) {
  const hit = firstOnRay(surfaces, view.ray(x, y), morphs()[views.indexOf(view)]);
  if (!hit) return;
  mark = hit;
  tellPlace();
  redraw();
}

const number = (value) => (Number.isFinite(value) ? String(Number(value.toPrecision(5))) : "infinite");

function fill(list, entries) {
  const texts = Object.entries(entries).flatMap(([name, text]) => [
    ["dt", name],
    ["dd", text],
  ]);
  list.replaceChildren(
    ...texts.map(([tag, text]) => Object.assign(document.createElement(tag), { textContent: text })),
  );
}

function tellPlace() {
  const { face, weights } = mark;
  const vertex = surfaces.vertices[3 * face + weights.indexOf(Math.max(...weights))];
  const { centre, scale } = surfaces.sides[0];
  const point = placeOf(surfaces, mark, 0).map((x, k) => Number((centre[k] + scale * x).toPrecision(6)));
  const values = measures.map(({ name, values, classes }) => [
    name,
    classes ? classes[values[face]].name : number(values[face]),
  ]);
  const folds = surfaces.folded.includes(face) ? " (folded)" : "";
  const places = surfaces.numbers
    ? { Faces: surfaces.numbers.map((faces, i) => `${faces[face]} of ${surfaces.sides[i].title}`).join(", ") }
    : { Face: face + folds, Vertex: `${vertex}, the nearest corner` };
  fill(byId("place"), { ...places, Point: point.join(", "), ...Object.fromEntries(values) });
  Object.assign(byId("place").dataset, { face, vertex });
  if (scales[measure]) markValue(byId("histogram"), scales[measure], measures[measure].values[face]);
}

function choose() {
  const chosen = measures.findIndex(({ name }) => name === colour.value);
  if (chosen >= 0) measure = chosen;
  byId("measure").textContent = `${measures[measure].name}: ${measures[measure].meaning}`;
  if (scales[measure]) drawHistogram(byId("histogram"), measures[measure], scales[measure]);
  else drawClasses(byId("histogram"), measures[measure]);
  painter.paintFaces(shadesOf(measures[measure], scales[measure], surfaces.folded));
  if (mark) tellPlace();
  redraw();
}

// What the left side is while it moves to the right one
function tellMorph() {
  const { left, right } = facts;
  const share = morph.valueAsNumber;
  const named = { 0: left.title, 0.5: middle, 1: right.title }[share];
  const text = named ?? `${Math.round(100 * share)} % of the way to ${right.title}`;
  views[0].element.querySelector("figcaption").textContent = text;
  morph.setAttribute("aria-valuetext", text);
  redraw();
}

function showMark() {
  views.forEach((view, i) => {
    const element = view.element.querySelector(".mark");
    element.hidden = !mark;
    if (!mark) return;
    const { x, y } = view.project(placeOf(surfaces, mark, morphs()[i]));
    element.style.left = `${50 + 50 * x}%`;
    element.style.top = `${50 - 50 * y}%`;
  });
}

// Takes all faces.
function showIfBehind() {
  if (!mark) return;
  views.forEach((view, i) => {
    const place = placeOf(surfaces, mark, morphs()[i]);
    const { x, y } = view.project(place);
    const seen = firstOnRay(surfaces, view.ray(x, y), morphs()[i]);
    const isSeen = seen && Math.hypot(...placeOf(surfaces, seen, morphs()[i]).map((x, k) => x - place[k])) < 1e-3;
    view.element.querySelector(".mark").classList.toggle("behind", !isSeen);
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
    showIfBehind();
  }
  requestAnimationFrame(loop);
}

function makePainter() {
  const canvas = area.querySelector("canvas");
  try {
    return new WebGLPainter(canvas, surfaces);
  } catch {
    byId("notice").textContent =
      "WebGL is missing: the sides are drawn without it, more slowly, and without the pattern.";
    byId("notice").hidden = false;
    const fresh = canvas.cloneNode(); // one that WebGL has been asked of may have no other context
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
  byId("certificate").classList.toggle("folds", !facts.one_to_one);
  views.forEach(({ element }, i) => {
    const { title } = surfaces.sides[i];
    element.querySelector("figcaption").textContent = title;
    element.setAttribute(
      "aria-label",
      `${title}. Arrow keys turn it, + and - zoom, Enter marks the place in the middle.`,
    );
  });
  const row = (tag, texts) => {
    const cells = texts.map((text, i) => Object.assign(document.createElement(i ? tag : "th"), { textContent: text }));
    const result = document.createElement("tr");
    result.append(...cells);
    return result;
  };
  const measured = measures.filter(({ statistics }) => statistics);
  const rows = measured.map((m) =>
    row("td", [m.name, ...Object.values(m.statistics).map((x) => number(x ?? Infinity))]),
  );
  byId("distortion").append(row("th", ["", ...Object.keys(measured[0].statistics)]), ...rows);
  fill(byId("summary"), facts.summary);
  const slider = morph.closest("label");
  slider.hidden = !facts.morphs;
  slider.querySelectorAll("span").forEach((mark, i) => {
    mark.textContent = mark.title = [left.title, middle, right.title][i];
  });
}

painter = makePainter();
for (const { name } of measures) colour.add(new Option(name, name, false, name === facts.measure));
if (painter instanceof WebGLPainter) {
  colour.add(new Option(facts.has_sphere ? "meridians and parallels" : "grid of the left side", "pattern"));
}
colour.add(new Option("plain", "plain"));

showSummary();
tellMorph();
colour.addEventListener("change", choose);
morph.addEventListener("input", tellMorph);
together.addEventListener("change", () => onTurn(views[0]));
byId("reset").addEventListener("click", () => {
  morph.value = 0;
  together.checked = true;
  for (const view of views) view.reset();
  tellMorph();
});
area.querySelector("canvas").addEventListener("webglcontextrestored", redraw);
new ResizeObserver(resize).observe(area);
choose();
resize();
loop();
