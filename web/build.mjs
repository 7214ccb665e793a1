// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Makes built/page.html, one file with its style and its script in it, and built/space.js, the script that draws space,
// which the program gives to pages of scenes in space only. The server puts in the nonce, the token and the kind. The
// first line says of what they were made (tests/serve/page_is_fresh.py).
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const folder = new URL(".", import.meta.url).pathname;
const sources = [...readdirSync(folder + "src").sort().map((name) => "src/" + name), "build.mjs", "package-lock.json"];
const hash = createHash("sha256");
for (const name of sources) hash.update(name + "\n").update(readFileSync(folder + name));
const made = `made of web/ ${hash.digest("hex")}`;

async function bundle(entry) {
  const out = await build({ entryPoints: [folder + entry], bundle: true, minify: true, write: false, target: "es2022", charset: "utf8", format: "iife" });
  return out.outputFiles[0].text.replaceAll("</script", "<\\/script");
}

const script = await bundle("src/main.ts");
const page = `<!-- ${made} -->\n` + readFileSync(folder + "src/page.html", "utf8")
  .replace("/*STYLE*/", () => readFileSync(folder + "src/style.css", "utf8"))
  .replace("/*SCRIPT*/", () => script);
mkdirSync(folder + "built", { recursive: true });
writeFileSync(folder + "built/page.html", page);
writeFileSync(folder + "built/space.js", await bundle("src/space.ts"));
console.log(`built/page.html, ${Math.ceil(page.length / 1024)} KiB`);
