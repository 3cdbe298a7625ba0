// The gallery of docs/report.md: node test/gallery.mjs MRSIM ../docs/images
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { open } from "./browser.mjs";

const [mrsim, out] = process.argv.slice(2).map((path) => resolve(path));
const data = join(dirname(fileURLToPath(import.meta.url)), "../../data");
const folder = mkdtempSync(join(tmpdir(), "mrsim-gallery-"));
const program = (name, lines) => {
  writeFileSync(join(folder, name), `${lines.join("\n")}\n`);
  return name;
};
for (const name of ["FANUC_POCKET.NC", "PRIMER_2S.MPF", "bar.stl"]) copyFileSync(join(data, name), join(folder, name));
const n = (x) => x.toFixed(3);

function relief() {
  const lines = ["G21 G90 G17", "T1 M6", "S12000 M3", "G0 X0 Y0 Z5"];
  const height = (x, y) => -4 + 2.2 * Math.sin(x / 7) * Math.cos(y / 6) + 1.2 * Math.sin((x + 2 * y) / 11);
  for (let k = 0; k <= 75; ++k)
    for (let i = 0; i <= 80; ++i) {
      const x = 1 + (k % 2 ? 80 - i : i), y = 1 + k * 0.8;
      lines.push(`G1 X${n(x)} Y${n(y)} Z${n(height(x, y))}${k + i ? "" : " F1500"}`);
    }
  return [program("relief.nc", [...lines, "G0 Z10", "M30"]), "--stock", "box:0,0,-12,82,62,0", "--tool", "1=ballmill:d=3"];
}
function fiveTools() {
  const lines = ["G21 G90 G17", "(face)", "T1 M6", "S2000 M3", "G0 X-15 Y8 Z5", "G1 Z-1 F600"];
  for (let k = 0; k < 4; ++k) lines.push(`G1 X${k % 2 ? -5 : 105} Y${8 + 16 * k}`, `G1 Y${Math.min(60, 24 + 16 * k)}`);
  lines.push("G0 Z30", "(pocket)", "T2 M6", "S5000 M3", "G0 X30 Y20 Z5");
  for (const z of [-4, -7]) {
    lines.push(`G1 Z${z} F200`);
    for (const r of [2, 6, 10]) lines.push(`G1 X${30 - r} Y${20 - r / 2} F700`, `G1 X${70 + r}`, `G1 Y${40 + r / 2}`, `G1 X${30 - r}`, `G1 Y${20 - r / 2}`);
    lines.push("G1 X30 Y20");
    for (const y of [24, 28, 32, 36]) lines.push(`G1 X70 Y${y - 4}`, `G1 Y${y}`, `G1 X30`);
    lines.push("G0 Z5", "G0 X30 Y20");
  }
  lines.push("G0 Z30", "(holes)", "T3 M6", "S3000 M3");
  for (const [x, y] of [[8, 8], [92, 8], [92, 52], [8, 52]]) lines.push(`G0 X${x} Y${y} Z5`, "G1 Z-14 F250", "G0 Z5");
  lines.push("G0 Z30", "(ball groove)", "T4 M6", "S9000 M3", "G0 X35 Y30 Z5", "G1 Z-8.5 F300", "G2 X65 Y30 I15 J0", "G2 X35 Y30 I-15 J0", "G0 Z30",
    "(chamfer)", "T5 M6", "S6000 M3", "G0 X-8 Y-0.5 Z5", "G1 Z-3 F800", "G1 X100.5", "G1 Y60.5", "G1 X-0.5", "G1 Y-8", "G0 Z30", "M30");
  return [program("five_tools.nc", lines), "--stock", "box:0,0,-18,100,60,0", "--tool", "1=endmill:d=20", "--tool", "2=endmill:d=8", "--tool", "3=drill:d=6,a=118", "--tool", "4=ballmill:d=5", "--tool", "5=chamfer:d=8,a=90"];
}
function collision() {
  const lines = ["G21 G90 G17", "T1 M6", "S3000 M3", "G0 X15 Y15 Z5"];
  for (const z of [-4, -8, -12, -16]) {
    lines.push(`G1 Z${z} F200`, "G1 X65 F600", "G1 Y25", "G1 X15", "G1 Y35", "G1 X65");
    lines.push(z === -8 ? "G0 X15 Y15 (without a retract)" : "G0 Z5", "G0 X15 Y15");
  }
  writeFileSync(join(folder, "tools.toml"), '[[tool]]\nid = "1"\ntype = "endmill"\ndiameter = 8\nflute_length = 10\nshank = [[12, 20]]\nholder = [[30, 30, 25]]\n');
  return [program("collision.nc", [...lines, "G0 Z20", "M30"]), "--stock", "box:0,0,-25,80,50,0", "--tools", "tools.toml"];
}
const parts = [
  ["pocket", ["FANUC_POCKET.NC", "--stock", "box:-45,-45,-35,45,45,0", "--tool", "1=endmill:d=10"], 0.55],
  ["relief", relief(), 0.62],
  ["turned", ["PRIMER_2S.MPF", "--stock", "bar.stl"], 0.5],
  ["five_tools", fiveTools(), 0.72],
  ["collision", collision(), 0.8],
];

const browser = await open();
try {
  for (const [name, words, share] of parts) {
    const file = join(folder, `${name}.html`);
    execFileSync(mrsim, [...words, "-q", "--report", file], { cwd: folder, stdio: ["ignore", "inherit", "ignore"] });
    const page = await browser.page(file, { width: 1200, height: 750 });
    await page.evaluate((s) => { const { timeline, play } = window.mrsimReport; timeline.go(play.atSeconds(s * play.total)); }, share);
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(out, `play_${name}.png`) });
    await page.context().close();
  }
  if (browser.problems.length) throw new Error(browser.problems.join("\n"));
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
