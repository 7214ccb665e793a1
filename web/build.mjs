// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Makes dist/page.html: one file, with its style and its script in it. The server puts in the nonce and the token.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const folder = new URL(".", import.meta.url).pathname;
const made = await build({ entryPoints: [folder + "src/main.ts"], bundle: true, minify: true, write: false, target: "es2022", charset: "utf8" });
const script = made.outputFiles[0].text.replaceAll("</script", "<\\/script");
const page = readFileSync(folder + "src/page.html", "utf8")
  .replace("/*STYLE*/", () => readFileSync(folder + "src/style.css", "utf8"))
  .replace("/*SCRIPT*/", () => script);
mkdirSync(folder + "dist", { recursive: true });
writeFileSync(folder + "dist/page.html", page);
console.log(`dist/page.html, ${Math.ceil(page.length / 1024)} KiB`);
