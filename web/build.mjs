// Builds dist/report.html, one file with everything inside. With --check: fails where the committed
// file is not what the sources give.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build, transformSync } from "esbuild";

const root = dirname(fileURLToPath(import.meta.url));
const output = join(root, "dist/report.html");
const read = (name) => readFileSync(join(root, name), "utf8");

const bundle = await build({
  entryPoints: [join(root, "src/boot.js")], bundle: true, minify: true, write: false, format: "iife", target: "es2020",
  legalComments: "inline", charset: "ascii",
});
const style = transformSync(read("src/style.css"), { loader: "css", minify: true }).code;
const script = bundle.outputFiles[0].text.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
// Functions, because "$&" in a replacement string would be read as a pattern.
const html = read("src/index.html").replace("/*STYLE*/", () => style).replace("/*SCRIPT*/", () => script);

if (html.split('"MRSIM-DATA"').length !== 2) throw new Error("the place for the data must occur once");
if (process.argv.includes("--check")) {
  if (read("dist/report.html") !== html) {
    console.error("web/dist/report.html is not what web/src gives: run npm run build in web/ and commit it");
    process.exit(1);
  }
  console.log("web/dist/report.html is up to date");
} else {
  writeFileSync(output, html);
  console.log(`${output}: ${(html.length / 1024).toFixed(0)} KiB`);
}
