// Usage: node make_page.mjs NPM OUTPUT [--for-the-test]
//
// Bundles the page into OUTPUT/page_text.cpp, which is compiled into the program. Installs the required npm packages in OUTPUT; with
// --for-the-test, also those of test_page.mjs. If that fails, the program is built without the page and reports the reason; the next
// build tries again.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const [npm, output] = process.argv.slice(2);
const source = dirname(fileURLToPath(import.meta.url));
const stamp = join(output, "page.stamp");

function install() {
  mkdirSync(output, { recursive: true });
  for (const file of ["package.json", "package-lock.json"]) copyFileSync(join(source, file), join(output, file));
  const options = ["--ignore-scripts", "--no-audit", "--no-fund", "--fetch-retries=1", "--loglevel=error"];
  if (!process.argv.includes("--for-the-test")) options.push("--omit=dev");
  execFileSync(npm, ["ci", ...options], { cwd: output, stdio: ["ignore", "pipe", "pipe"], encoding: "utf8" });
}

// The licences of the packages in the bundle
function licencesOf({ inputs }) {
  const packages = new Set(
    Object.keys(inputs)
      .map((file) => file.match(/.*node_modules\/(@[^/]+\/)?[^/]+/)?.[0])
      .filter(Boolean),
  );
  const texts = [...packages].sort().map((folder) => {
    const file = join(output, "node_modules", folder.split("node_modules/").pop());
    const { name, version } = JSON.parse(readFileSync(join(file, "package.json"), "utf8"));
    return `${name} ${version}\n\n${readFileSync(join(file, "LICENSE"), "utf8").trim()}`;
  });
  return `<!--\nThis page contains:\n\n${texts.join("\n\n")}\n-->\n`;
}

function bundle() {
  const esbuild = createRequire(join(output, "package.json"))("esbuild");
  const options = {
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    absWorkingDir: source,
    nodePaths: [join(output, "node_modules")],
  };
  const script = esbuild.buildSync({
    ...options,
    entryPoints: ["page.js"],
    format: "esm",
    target: "es2022",
    legalComments: "none",
  });
  const style = esbuild.buildSync({ ...options, entryPoints: ["page.css"] });
  const parts = { STYLE: style.outputFiles[0].text.trim(), SCRIPT: script.outputFiles[0].text.trim() };
  const page = readFileSync(join(source, "page.html"), "utf8").replace(/STYLE|SCRIPT/g, (name) => parts[name]);
  return (page + licencesOf(script.metafile)).split("<!--DATA-->\n");
}

// Several literals, because compilers limit their length
function literals(text) {
  const pieces = text.match(/[^]{1,16000}/g) ?? [];
  return pieces.map((piece) => `R"page(${piece})page", `).join("") + "nullptr";
}

function write(head, tail, fault) {
  writeFileSync(
    join(output, "page_text.cpp"),
    `#include "Page_text.h"\n\nnamespace Program {\n\nconst char* const page_head[] = {${literals(head)}};\n` +
      `const char* const page_tail[] = {${literals(tail)}};\n` +
      `const char* const page_fault = R"page(${fault})page";\n\n} // namespace Program\n`,
  );
}

rmSync(stamp, { force: true });
let reason = "";
try {
  install();
} catch (error) {
  reason = (error.stderr || error.message).trim().split("\n").slice(0, 5).join("\n");
}
if (reason === "") {
  write(...bundle(), "");
  writeFileSync(stamp, "");
} else {
  console.log(`NOTICE: The program will not write pages:\n${reason}`);
  write(
    "",
    "",
    `this program was built without support for pages, because npm failed:\n${reason}\nCorrect the cause and build it again.`,
  );
}
