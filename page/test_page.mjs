// Usage: node test_page.mjs BROWSER PROGRAM OUTPUT
//
// Opens pages that PROGRAM has written in a headless BROWSER, uses them with mouse and keyboard, and checks their accessibility. OUTPUT is
// the folder in which make_page.mjs has installed the required packages.

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
const require = createRequire(join(output, "package.json"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "spherical_parameterization_"));
const file = (name) => join(folder, name);

// A grid of longitudes and latitudes on a star-shaped body; the distance from the centre depends on both
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

// A GIFTI file with the label 7, named hill, for the first half of the vertices, and no label for the others
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

// The number of colours of a picture, the fraction of pixels that differ from those of another one, and the fraction of pixels that are
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

// Rounding may change a few pixels.
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
  await waitForDrawing(page);
  return page;
}

// On a busy machine that draws by software, the first picture takes longer than a frame.
async function waitForDrawing(page) {
  const end = Date.now() + 20000;
  while ((await examine(page, await look(page, "#view-left"))).colours < 100 && Date.now() < end);
}

// Waits until the page has drawn again.
const settle = (page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

async function look(page, selector) {
  await settle(page);
  return (await page.$(selector)).screenshot({ encoding: "base64" });
}

// Points at the points of the sphere that the program has located, and at their marks on the body.
async function checkPicking(page) {
  const facts = JSON.parse(await page.$eval("#facts", (script) => script.textContent));
  const box = await page.$eval("#view-right", (view) => view.getBoundingClientRect().toJSON());
  const images = readPoints("sphere.off").map((p) => p.map((x) => x / Math.hypot(...p)));
  const selected = () => page.$eval("#point", ({ dataset }) => ({ ...dataset }));
  const marked = [];
  for (const point of readPoints("points.off")) {
    const { face, weights } = locate(point, body);
    const image = [0, 1, 2].map((k) =>
      dot(
        weights,
        body.faces[face].map((v) => images[v][k]),
      ),
    );
    const [x, y, z] = [0, 3, 6].map((row) => dot(facts.right.rotation.slice(row, row + 3), image));
    // The view is along the z-axis, the smallest extent of the body, and shows 1.05 times the unit sphere. The precision of a pointer is
    // limited.
    if (z < 0.2 || Math.min(...weights) < 0.01) continue;
    const scale = Math.min(box.width, box.height) / 2.1;
    await page.mouse.move(box.x + box.width / 2 + scale * x, box.y + box.height / 2 - scale * y);
    const expected = { face: String(face), vertex: String(body.faces[face][weights.indexOf(Math.max(...weights))]) };
    assert.deepEqual(await selected(), expected);
    await settle(page);
    const mark = await page.$("#view-left .mark:not(.behind)");
    if (mark) marked.push([await mark.boundingBox(), expected]);
  }
  assert.ok(marked.length >= 20, `${marked.length} points`);
  for (const [{ x, y, width, height }, expected] of marked) {
    await page.mouse.move(x + width / 2, y + height / 2);
    assert.deepEqual(await selected(), expected);
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
  assert.ok(await isSame(page, await look(page, "#view-right"), right), "the sphere rotates along");
  await page.click("#together");
  assert.ok(!(await isSame(page, await look(page, "#view-right"), right)), "the sphere does not rotate along");

  await drag(page, "#view-left");
  const rotated = [await look(page, "#view-left"), await look(page, "#view-right")];
  assert.ok(
    !(await isSame(page, rotated[0], left)) && !(await isSame(page, rotated[1], right)),
    "dragging does not rotate both",
  );
  await page.click("#reset");
  assert.ok(await isSame(page, await look(page, "#view-right"), right), "the sphere is not reset");

  for (const paint of ["D_area", "D_angle", "pattern", "plain"]) {
    const before = await look(page, "#view-right");
    await page.select("#colour", paint);
    assert.ok(!(await isSame(page, await look(page, "#view-right"), before)), `${paint} changes nothing`);
  }
}

// Every control is reached by the tab key and shows its focus; keys select, move and reset.
async function checkKeyboard(page) {
  await page.focus("#colour");
  const order = [];
  for (let i = 0; i < 7; ++i) {
    const [id, width] = await page.evaluate(() => {
      const { id } = document.activeElement;
      return [id, parseFloat(getComputedStyle(document.activeElement).outlineWidth)];
    });
    assert.ok(width >= 2, `${id} does not show its focus`);
    order.push(id);
    await page.keyboard.press("Tab");
  }
  assert.deepEqual(order, ["colour", "morph", "together", "reset", "view-left", "view-right", "statistics"]);

  await page.focus("#view-left");
  await page.keyboard.press("0");
  const before = await look(page, "#view-left");
  for (const key of ["ArrowUp", "ArrowRight"]) {
    await page.keyboard.down("Shift");
    await page.keyboard.press(key);
    await page.keyboard.up("Shift");
  }
  assert.ok(!(await isSame(page, await look(page, "#view-left"), before)), "Shift and arrows do not move the surface");
  await page.keyboard.press("+");
  await page.keyboard.press("0");
  assert.ok(await isSame(page, await look(page, "#view-left"), before), "0 does not reset the view");
}

// Checks with axe-core, in both colour schemes, and that nothing is cut off on a small screen.
async function checkAccessibility(page, name) {
  for (const scheme of ["light", "dark"]) {
    await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
    await settle(page);
    await page.evaluate(axe);
    const violations = await page.evaluate(async () => {
      const { violations } = await globalThis.axe.run();
      return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((node) => node.html).join(", ")}`);
    });
    assert.deepEqual(violations, [], `${name}, ${scheme}`);
  }
  for (const [width, height] of [
    [390, 844],
    [820, 1180],
  ]) {
    await page.setViewport({ width, height });
    await settle(page);
    const excess = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(excess <= 0, `${name} is ${excess} pixels too wide for ${width}`);
  }
}

async function checkDrawing(page) {
  for (const side of ["#view-left", "#view-right"]) {
    const { colours } = await examine(page, await look(page, side));
    assert.ok(colours > 2000, `${side} has ${colours} colours`);
  }
}

// A body and a translated copy that is larger by half: sizes, positions and displacements are visible.
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
    assert.ok(Math.abs(statistics[k] - expected) < 1e-4 * expected, `${statistics[k]} instead of ${expected}`);
  assert.match((await texts("#measure, #meaning")).join(": "), /^Displacement: .* in the unit of the files\.$/);
  const most = [...moves].sort((x, y) => x - y)[Math.floor(0.99 * (moves.length - 1))];
  const ticks = (await texts("#histogram text")).slice(0, 4);
  const [third, twoThirds, end] = [1 / 3, 2 / 3, 1].map((t) => String(Number((t * most).toPrecision(3))));
  assert.deepEqual(ticks, ["0", third, twoThirds, `\u2265 ${end}`]);
  await page.focus("#view-left");
  await page.keyboard.press("Enter");
  const { face } = await page.$eval("#point", ({ dataset }) => ({ ...dataset }));
  const shown = (await texts("#point dd"))[3];
  assert.ok(Math.abs(shown - moves[face]) < 1e-4, `${shown} instead of ${moves[face]}`);

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
  assert.ok(!(await isSame(page, await look(page, "#view-right"), right)), "the right side does not rotate along");
  assert.ok(
    await isSame(page, await look(page, "#view-left"), await look(page, "#view-right")),
    "the sides do not rotate alike",
  );
  assert.equal(await page.$eval("#colour [value=pattern]", (option) => option.textContent), "grid of the left side");
}

async function withBrowser(args, uses) {
  const browser = await puppeteer.launch({ executablePath: browserFile, args: ["--no-sandbox", ...args] });
  const faults = [];
  try {
    for (const [name, use] of Object.entries(uses)) {
      const page = await open(browser, name, faults);
      await use(page);
      await checkAccessibility(page, name);
    }
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
  }
}

try {
  writeOff("body.off", body);
  writeOff("directions.off", sphere);
  // The vertices of the remesh are the points that the program locates for the directions.
  const run = (...words) => execFileSync(program, [...words, "--quiet"]);
  const [surface, directions, map] = [file("body.off"), file("directions.off"), file("sphere.off")];
  run("map", surface, "--prefer", "sampling", "-o", map, "--page", file("page.html"));
  run("remesh", surface, directions, "--initial", map, "--iterations", "0", "-o", file("points.off"));

  run("match", surface, directions, "--page", file("two.html"));

  writeOff("open.off", { points: body.points, faces: body.faces.slice(7) });
  run("map", file("open.off"), "--repair", "--page", file("repaired.html"));

  writeLabels("labels.gii", body);
  run("map", surface, "--page", file("classes.html"), "--labels", file("labels.gii"), "--convention", "cortex");

  writeOff("large.off", { points: body.points.map(enlarge), faces: body.faces });
  run("show", surface, "-o", file("beside.html"), "--beside", file("large.off"));

  const torus = makeTorus(24, 8);
  writeOff("torus.off", torus);
  const { status, stdout } = spawnSync(program, ["show", file("torus.off"), "-o", file("torus.html")]);
  assert.equal(status, 0);
  assert.match(String(stdout), /A cycle of 8 edges around a handle/);

  // Software rendering, in case there is no graphics device
  await withBrowser(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"], {
    "page.html": async (page) => {
      await checkDrawing(page);
      console.log(`${await checkPicking(page)} points agree`);
      await checkControls(page);
      await checkKeyboard(page);
    },
    "two.html": async (page) => {
      await checkDrawing(page);
      await page.focus("#view-right");
      await page.keyboard.press("Enter");
      assert.match(
        await page.$eval("#point", (point) => point.textContent),
        /^Face of body.off\d+Face of directions.off\d+Point on body.off.*expected error\d/,
      );
      const summary = await page.$eval("#summary", (list) => list.textContent);
      assert.match(
        summary,
        /Alignmentby features, agreement .*Expected error.* on average, relative to the square root/,
      );
      // The alignment of a body to a sphere is ambiguous.
      assert.match(await page.$eval("#warning:not([hidden])", (text) => text.textContent), /^Ambiguous alignment/);
      await page.select("#colour", "expected error");
      assert.match(await page.$eval("#meaning", (text) => text.textContent), /the larger the value, the less reliable/);
      const before = await look(page, "#view-right");
      await page.select("#colour", "pattern");
      assert.ok(!(await isSame(page, await look(page, "#view-right"), before)), "the grid is not drawn");
    },
    "classes.html": async (page) => {
      assert.match(await page.$eval("#histogram", (svg) => svg.textContent), /^hill(49|50|51)\.\d %/);
      const before = await look(page, "#view-left");
      await page.select("#colour", "sulci");
      assert.match(await page.$eval("#histogram", (svg) => svg.textContent), /sulcus/);
      assert.ok(!(await isSame(page, await look(page, "#view-left"), before)), "the sulci are not drawn");
      await page.focus("#view-left");
      await page.keyboard.press("Enter");
      assert.match(
        await page.$eval("#point", (point) => point.textContent),
        /labels(hill|no label).*gyri and sulci(gyrus|sulcus)/,
      );
    },
    "repaired.html": async (page) => {
      const before = await look(page, "#view-left");
      await page.select("#colour", "repair");
      assert.match(await page.$eval("#histogram", (svg) => svg.textContent), /^surface of the file.* %hole patch.* %$/);
      assert.ok(!(await isSame(page, await look(page, "#view-left"), before)), "the patches are not drawn");
      assert.match(
        await page.$eval("#summary", (list) => list.textContent),
        /Repair\d+ holes? filledpatches cover .* %/,
      );
    },
    "beside.html": async (page) => {
      await checkDrawing(page);
      assert.match(await page.$eval("#certificate", (text) => text.textContent), /^Both surfaces have the same faces/);
      await checkSizes(page);
    },
    "torus.html": async (page) => {
      await checkDrawing(page);
      assert.match(await page.$eval("#certificate", (text) => text.textContent), /it has a handle\.$/);
      assert.ok(await page.$eval("#morph", (slider) => slider.closest(".slider").hidden));
    },
  });
  await withBrowser(["--disable-gpu", "--disable-3d-apis"], {
    "page.html": async (page) => {
      assert.match(await page.$eval("#notice", (notice) => notice.textContent), /WebGL is not available/);
      await checkDrawing(page);
    },
  });
} finally {
  rmSync(folder, { recursive: true });
}
