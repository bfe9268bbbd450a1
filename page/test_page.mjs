// Usage: node test_page.mjs BROWSER PROGRAM OUTPUT
//
// Opens a page that PROGRAM has written in a BROWSER without windows, and uses it as a person does: with a mouse and keys. OUTPUT
// is where make_page.mjs has installed what that takes.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [browserFile, program, output] = process.argv.slice(2);
for (const [needed, what] of [
  [browserFile, "Chromium is not installed"],
  [join(output, "page.stamp"), "The program has no page"],
]) {
  if (existsSync(needed)) continue;
  console.log(`NOTICE: ${what}: the page is not tested.`);
  process.exit(77);
}
const puppeteer = createRequire(join(output, "package.json"))("puppeteer-core");
const folder = mkdtempSync(join(tmpdir(), "spherical_parameterization_"));
const file = (name) => join(folder, name);

// A grid of longitudes and latitudes around a body, whose distance from the middle depends on both
function makeMesh(rows, columns, radiusOf) {
  const points = [];
  const add = (latitude, longitude) => {
    const radius = radiusOf(latitude, longitude),
      s = Math.sin(latitude);
    return (
      points.push([s * Math.cos(longitude), Math.cos(latitude), s * Math.sin(longitude)].map((x) => radius * x)) - 1
    );
  };
  for (let i = 1; i < rows; ++i)
    for (let j = 0; j < columns; ++j) add((Math.PI * i) / rows, (2 * Math.PI * j) / columns);
  const north = add(0, 0),
    south = add(Math.PI, 0);
  const at = (i, j) => i * columns + (j % columns);
  const faces = [];
  for (let j = 0; j < columns; ++j) {
    faces.push([north, at(0, j + 1), at(0, j)], [south, at(rows - 2, j), at(rows - 2, j + 1)]);
    for (let i = 0; i < rows - 2; ++i)
      faces.push([at(i, j), at(i, j + 1), at(i + 1, j)], [at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)]);
  }
  return { points, faces };
}

function makeTorus(rows, columns) {
  const angle = (k, n) => (2 * Math.PI * k) / n;
  const points = [];
  const faces = [];
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < columns; ++j) {
      const radius = 3 + Math.cos(angle(j, columns));
      points.push([radius * Math.cos(angle(i, rows)), radius * Math.sin(angle(i, rows)), Math.sin(angle(j, columns))]);
      const at = (k, l) => (k % rows) * columns + (l % columns);
      faces.push([at(i, j), at(i + 1, j), at(i, j + 1)], [at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return { points, faces };
}

function writeOff(name, { points, faces }) {
  const rows = [...points.map((p) => p.join(" ")), ...faces.map((face) => [3, ...face].join(" "))];
  writeFileSync(file(name), `OFF\n${points.length} ${faces.length} 0\n${rows.join("\n")}\n`);
}

function readPoints(name) {
  const [, count, , , ...numbers] = readFileSync(file(name), "utf8").split(/\s+/);
  return Array.from({ length: Number(count) }, (_, i) => numbers.slice(3 * i, 3 * i + 3).map(Number));
}

const minus = (p, q) => p.map((x, k) => x - q[k]);
const dot = (p, q) => p.reduce((sum, x, k) => sum + x * q[k], 0);
const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];

// The face of a mesh that contains a point of it, and its barycentric coordinates
function locate(point, { points, faces }) {
  for (const [face, corners] of faces.entries()) {
    const [a, b, c] = corners.map((v) => points[v]);
    const [u, v, w] = [minus(b, a), minus(c, a), minus(point, a)];
    const normal = cross(u, v),
      area = dot(normal, normal);
    const second = dot(cross(w, v), normal) / area,
      third = dot(cross(u, w), normal) / area;
    const weights = [1 - second - third, second, third];
    if (Math.min(...weights) >= -1e-9 && Math.abs(dot(w, normal)) < 1e-9 * area ** 0.75) return { face, weights };
  }
  assert.fail(`the mesh does not contain ${point}`);
}

// A GIFTI file with the label 7, called hill, for the first half of the vertices, and none for the others
function writeLabels(name, { points }) {
  const keys = points.map((_, v) => (2 * v < points.length ? 7 : 0)).join(" ");
  writeFileSync(
    file(name),
    `<GIFTI Version="1.0" NumberOfDataArrays="1"><LabelTable><Label Key="0">???</Label>
    <Label Key="7" Red="1" Green="0.5" Blue="0" Alpha="1">hill</Label></LabelTable>
    <DataArray Intent="NIFTI_INTENT_LABEL" DataType="NIFTI_TYPE_INT32" ArrayIndexingOrder="RowMajorOrder"
    Dimensionality="1" Dim0="${points.length}" Encoding="ASCII" Endian="LittleEndian"><Data>${keys}</Data>
    </DataArray></GIFTI>`,
  );
}

// The number of colours of a picture, the share of pixels that differ from those of another one, and the share of those that are
// neither grey, black nor white
function examine(page, picture, other = picture) {
  const read = async (pictures) => {
    const [pixels, others] = await Promise.all(
      pictures.map(async (picture) => {
        const bytes = Uint8Array.from(atob(picture), (character) => character.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes]));
        const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
        context.drawImage(image, 0, 0);
        return new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
      }),
    );
    const isColoured = (pixel) => {
      const bytes = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
      return Math.max(...bytes) - Math.min(...bytes) > 25;
    };
    return {
      colours: new Set(pixels).size,
      changed: pixels.filter((pixel, i) => pixel !== others[i]).length / pixels.length,
      coloured: pixels.filter(isColoured).length / pixels.length,
    };
  };
  return page.evaluate(read, [picture, other]);
}

// Rounding may change some pixels, and nobody sees it.
const isSame = async (page, picture, other) => (await examine(page, picture, other)).changed < 0.005;

const body = makeMesh(
  40,
  48,
  (latitude, longitude) => 1 + 0.3 * Math.sin(3 * longitude) * Math.sin(latitude) ** 3 + 0.5 * Math.cos(latitude) ** 2,
);
const sphere = makeMesh(9, 12, () => 1);
const enlarge = ([x, y, z]) => [1.5 * x + 0.2, 1.5 * y, 1.5 * z];

async function open(browser, name, faults) {
  const page = await browser.newPage();
  page.on("pageerror", (error) => faults.push(error.message));
  page.on(
    "request",
    (request) => request.url().startsWith("file:") || faults.push(`The page asks for ${request.url()}`),
  );
  await page.setViewport({ width: 1200, height: 800 });
  await page.goto(pathToFileURL(file(name)).href);
  await page.waitForSelector("#histogram rect");
  return page;
}

// Waits until the page has drawn again.
const settle = (page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

async function look(page, selector) {
  await settle(page);
  return (await page.$(selector)).screenshot({ encoding: "base64" });
}

// Points at the places of the sphere that the program has looked up, and at where they are marked on the body.
async function checkPicking(page) {
  const facts = JSON.parse(await page.$eval("#facts", (script) => script.textContent));
  const box = await page.$eval("#view-right", (view) => view.getBoundingClientRect().toJSON());
  const images = readPoints("sphere.off").map((p) => p.map((x) => x / Math.hypot(...p)));
  const told = () => page.$eval("#place", ({ dataset }) => ({ ...dataset }));
  const marked = [];
  for (const place of readPoints("places.off")) {
    const { face, weights } = locate(place, body);
    const image = [0, 1, 2].map((k) =>
      dot(
        weights,
        body.faces[face].map((v) => images[v][k]),
      ),
    );
    const [x, y, z] = [0, 3, 6].map((row) => dot(facts.right.rotation.slice(row, row + 3), image));
    // The body is thinnest along z, from where it is looked at; 1.05 is what is seen of a sphere of radius 1. A pointer has no
    // more than some digits.
    if (z < 0.2 || Math.min(...weights) < 0.01) continue;
    const scale = Math.min(box.width, box.height) / 2.1;
    await page.mouse.move(box.x + box.width / 2 + scale * x, box.y + box.height / 2 - scale * y);
    const expected = { face: String(face), vertex: String(body.faces[face][weights.indexOf(Math.max(...weights))]) };
    assert.deepEqual(await told(), expected);
    await settle(page);
    const mark = await page.$("#view-left .mark:not(.behind)");
    if (mark) marked.push([await mark.boundingBox(), expected]);
  }
  assert.ok(marked.length >= 20, `${marked.length} places`);
  for (const [{ x, y, width, height }, expected] of marked) {
    await page.mouse.move(x + width / 2, y + height / 2);
    assert.deepEqual(await told(), expected);
  }
  return marked.length;
}

async function drag(page, selector) {
  const { x, y } = await page.$eval(selector, (view) => view.getBoundingClientRect().toJSON());
  await page.mouse.move(x + 100, y + 100);
  await page.mouse.down();
  await page.mouse.move(x + 180, y + 130, { steps: 3 });
  await page.mouse.up();
}

async function checkControls(page) {
  const [left, right] = [await look(page, "#view-left"), await look(page, "#view-right")];
  await page.focus("#morph");
  await page.keyboard.press("End");
  assert.equal(await page.$eval("#morph", (slider) => slider.valueAsNumber), 1);
  assert.ok(!(await isSame(page, await look(page, "#view-left"), left)), "the slider does not change the surface");
  assert.ok(await isSame(page, await look(page, "#view-right"), right), "the slider changes the sphere");
  await page.click("#reset");
  assert.ok(await isSame(page, await look(page, "#view-left"), left), "the surface is not reset");

  await page.click("#together");
  await page.focus("#view-left");
  await page.keyboard.press("ArrowLeft");
  assert.ok(await isSame(page, await look(page, "#view-right"), right), "the sphere turns along");
  await page.click("#together");
  assert.ok(!(await isSame(page, await look(page, "#view-right"), right)), "the sphere does not turn along");

  await drag(page, "#view-left");
  const turned = [await look(page, "#view-left"), await look(page, "#view-right")];
  assert.ok(
    !(await isSame(page, turned[0], left)) && !(await isSame(page, turned[1], right)),
    "dragging does not turn both",
  );
  await page.click("#reset");
  assert.ok(await isSame(page, await look(page, "#view-right"), right), "the sphere is not reset");

  for (const paint of ["D_area", "D_angle", "pattern", "plain"]) {
    const before = await look(page, "#view-right");
    await page.select("#colour", paint);
    assert.ok(!(await isSame(page, await look(page, "#view-right"), before)), `${paint} changes nothing`);
  }
}

async function checkDrawing(page) {
  for (const side of ["#view-left", "#view-right"]) {
    const { colours } = await examine(page, await look(page, side));
    assert.ok(colours > 2000, `${side} has ${colours} colours`);
  }
}

// A body and one that is larger by half and elsewhere: sizes, places and how far each place moves are seen.
async function checkSizes(page) {
  const texts = (selector) => page.$$eval(selector, (all) => all.map((one) => one.textContent));
  assert.deepEqual(await texts("#title"), ["body.off and large.off"]);
  assert.deepEqual(await texts("figcaption"), ["body.off", "large.off"]);
  assert.deepEqual(await texts(".slider span"), ["body.off", "mean", "large.off"]);

  const size = async (selector) => Math.sqrt((await examine(page, await look(page, selector))).coloured);
  const [small, large] = [await size("#view-left"), await size("#view-right")];
  assert.ok(Math.abs(large / small - 1.5) < 0.05, `the larger side is drawn ${large / small} times as large`);

  const moves = body.faces.map((face) => {
    const middle = [0, 1, 2].map((k) => face.reduce((sum, v) => sum + body.points[v][k], 0) / 3);
    return Math.hypot(...minus(enlarge(middle), middle));
  });
  const average = moves.reduce((sum, x) => sum + x, 0) / moves.length;
  const [name, ...statistics] = await texts("#distortion tr:nth-child(2) > *");
  assert.equal(name, "displacement");
  for (const [k, expected] of [Math.max(...moves), average].entries())
    assert.ok(Math.abs(statistics[k] - expected) < 1e-4 * expected, `${statistics[k]} in the place of ${expected}`);
  assert.match((await texts("#measure"))[0], /^displacement: .* in the unit of the files$/);
  const most = [...moves].sort((x, y) => x - y)[Math.floor(0.99 * (moves.length - 1))];
  const ticks = (await texts("#histogram text")).slice(0, 4);
  const [third, twoThirds, end] = [1 / 3, 2 / 3, 1].map((t) => String(Number((t * most).toPrecision(3))));
  assert.deepEqual(ticks, ["0", third, twoThirds, `\u2265 ${end}`]);
  await page.focus("#view-left");
  await page.keyboard.press("Enter");
  const { face } = await page.$eval("#place", ({ dataset }) => ({ ...dataset }));
  const told = (await texts("#place dd"))[3];
  assert.ok(Math.abs(told - moves[face]) < 1e-4, `${told} in the place of ${moves[face]}`);

  await page.$eval("#morph", (slider) => {
    slider.value = 0.5;
    slider.dispatchEvent(new Event("input"));
  });
  assert.deepEqual(await texts("figcaption"), ["mean", "large.off"]);
  const half = await size("#view-left");
  assert.ok(Math.abs(half / small - 1.25) < 0.05, `the mean is drawn ${half / small} times as large`);
  await page.focus("#morph");
  await page.keyboard.press("End");
  assert.deepEqual(await texts("figcaption"), ["large.off", "large.off"]);
  const right = await look(page, "#view-right");
  assert.ok(await isSame(page, await look(page, "#view-left"), right), "the slider does not end at the right side");
  await page.focus("#view-left");
  await page.keyboard.press("ArrowLeft");
  assert.ok(!(await isSame(page, await look(page, "#view-right"), right)), "the right side does not turn along");
  assert.ok(
    await isSame(page, await look(page, "#view-left"), await look(page, "#view-right")),
    "the sides do not turn alike",
  );
  assert.equal(await page.$eval("#colour [value=pattern]", (option) => option.textContent), "grid of the left side");
}

async function withBrowser(args, uses) {
  const browser = await puppeteer.launch({ executablePath: browserFile, args: ["--no-sandbox", ...args] });
  const faults = [];
  try {
    for (const [name, use] of Object.entries(uses)) await use(await open(browser, name, faults));
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
  }
}

try {
  writeOff("body.off", body);
  writeOff("directions.off", sphere);
  // The vertices of the remesh are the places that the program finds for the directions.
  const run = (...words) => execFileSync(program, [...words, "--quiet"]);
  const [surface, directions, map] = [file("body.off"), file("directions.off"), file("sphere.off")];
  run("map", surface, "--prefer", "sampling", "-o", map, "--page", file("page.html"));
  run("remesh", surface, directions, "--initial", map, "--iterations", "0", "-o", file("places.off"));

  run("match", surface, directions, "--page", file("two.html"));

  writeLabels("labels.gii", body);
  run("map", surface, "--page", file("classes.html"), "--labels", file("labels.gii"), "--convention", "cortex");

  writeOff("large.off", { points: body.points.map(enlarge), faces: body.faces });
  run("show", surface, "-o", file("beside.html"), "--beside", file("large.off"));

  const torus = makeTorus(24, 8);
  writeOff("torus.off", torus);
  const { status, stdout } = spawnSync(program, ["show", file("torus.off"), "-o", file("torus.html")]);
  assert.equal(status, 0);
  assert.match(String(stdout), /A path of 8 edges around a handle/);

  // A processor draws where there is no other device.
  await withBrowser(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"], {
    "page.html": async (page) => {
      await checkDrawing(page);
      console.log(`${await checkPicking(page)} places agree`);
      await checkControls(page);
    },
    "two.html": async (page) => {
      await checkDrawing(page);
      await page.focus("#view-right");
      await page.keyboard.press("Enter");
      assert.match(
        await page.$eval("#place", (place) => place.textContent),
        /^Faces\d+ of body.off, \d+ of directions.off/,
      );
      const before = await look(page, "#view-right");
      await page.select("#colour", "pattern");
      assert.ok(!(await isSame(page, await look(page, "#view-right"), before)), "the grid is not drawn");
    },
    "classes.html": async (page) => {
      assert.match(await page.$eval("#histogram", (svg) => svg.textContent), /^hill(49|50|51)\.\d %/);
      const before = await look(page, "#view-left");
      await page.select("#colour", "folds");
      assert.match(await page.$eval("#histogram", (svg) => svg.textContent), /furrow/);
      assert.ok(!(await isSame(page, await look(page, "#view-left"), before)), "the folds are not drawn");
      await page.focus("#view-left");
      await page.keyboard.press("Enter");
      assert.match(await page.$eval("#place", (place) => place.textContent), /labels(hill|no label).*folds(ridge|furrow)/);
    },
    "beside.html": async (page) => {
      await checkDrawing(page);
      assert.match(await page.$eval("#certificate", (text) => text.textContent), /^The same faces/);
      await checkSizes(page);
    },
    "torus.html": async (page) => {
      await checkDrawing(page);
      assert.match(await page.$eval("#certificate", (text) => text.textContent), /^A handle keeps/);
      assert.ok(await page.$eval("#morph", (slider) => slider.closest("label").hidden));
    },
  });
  await withBrowser(["--disable-gpu", "--disable-3d-apis"], {
    "page.html": async (page) => {
      assert.match(await page.$eval("#notice", (notice) => notice.textContent), /WebGL is missing/);
      await checkDrawing(page);
    },
  });
} finally {
  rmSync(folder, { recursive: true });
}
