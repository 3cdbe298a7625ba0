import { $, el, place, signed } from "./dom.js";
import { css, deviationColor, kCutColor, kStockColor, listColor } from "./colors.js";
import { decodeMesh } from "./decode.js";
import { collisionRow, paintCollisions, paintCrashes, paintFigures, paintRegions, paintRun, paintVerdict } from "./panels.js";
import { ProgramPane } from "./program.js";
import { PartView } from "./scene.js";

const data = JSON.parse($("data").textContent);
const c = data.comparison, band = c.tolerance, keys = data.keys;
const state = { mode: data.compared ? "deviation" : "line", safe: false, region: -1, mark: null };
const tools = [...new Set(keys.filter((k) => !k.stock).map((k) => k.tool))];
const figuresOf = new Map(c.lines.map((l, i) => [i, l])); // in the order of the keys

// --- what a line cut ---
const byLine = new Map();
keys.forEach((k, i) => {
  const id = `${k.file}:${k.line}`;
  if (!k.stock) byLine.set(id, [...(byLine.get(id) ?? []), i]);
});
const keysOf = (file, line) => byLine.get(`${file}:${line}`) ?? [];

function colorOfKey(i) {
  const k = keys[i];
  if (state.mode === "owner") return k.stock ? kStockColor : kCutColor;
  if (k.stock) return kStockColor;
  return listColor(state.mode === "tool" ? tools.indexOf(k.tool) : i);
}
// Beside a line: the worst of what it cut, or the colour it has on the part.
function chip(list) {
  if (state.mode !== "deviation") return colorOfKey(list[0]);
  const worst = list.map((i) => figuresOf.get(i)).filter(Boolean).flatMap((l) => [l.min, l.max]).reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
  return deviationColor(worst, band, state.safe);
}

const notes = new Map();
for (const d of data.facts.diagnostics) if (d.line && d.severity !== "note") notes.set(`${d.file.split("/").pop()}:${d.line}`, d.text);
const noteOf = (file, line) => notes.get(`${file.split("/").pop()}:${line}`);

// --- panes ---
$("title").textContent = data.facts.title || c.part || "Part";
document.title = `${$("title").textContent} \u2013 mrsim`;
$("subtitle").textContent = data.compared ? `${c.part || "part"} against ${c.nominal || "nominal"}` : "Part as cut";
paintVerdict(c, data.compared);
const hasProgram = data.programs.some((p) => p.lines.length);
const program = hasProgram ? new ProgramPane(data.programs, keysOf, chip, noteOf, chooseLine) : null;
let regionRows = [];

// --- collisions come first: the worst is number 1 ---
const crashes = data.collisions.lines, crashCount = crashes.length + data.collisions.more;
const crashOf = (file, line) => crashes.find((k) => k.line === line && k.file.split("/").pop() === file.split("/").pop());
paintCrashes(crashCount, crashes[0], () => { openTab("collisions"); chooseCollision(0); });
const crashRows = crashes.length ? paintCollisions(data.collisions, chooseCollision) : [];
const crashMarks = crashes.map((k, i) => el("button", { class: "crash", title: collisionRow(k), "aria-label": `Collision ${i + 1}: ${collisionRow(k)}`, onclick: () => chooseCollision(i) }, String(i + 1)));
$("crash-marks").append(...crashMarks);

const tabs = [["collisions", crashCount ? `Collisions (${crashCount})` : null], ["regions", data.compared ? `Regions (${c.region_count})` : null], ["program", hasProgram ? "Program" : null], ["run", "Run"]].filter(([, name]) => name);
$("tabs").append(...tabs.map(([id, name]) => el("button", { role: "tab", id: `tab-${id}`, "aria-controls": `panel-${id}`, onclick: () => openTab(id) }, name)));
const panels = ["collisions", "regions", "program", "run"];
for (const id of panels) $(`panel-${id}`).setAttribute("aria-labelledby", `tab-${id}`);
function openTab(id) {
  for (const t of panels) {
    $(`panel-${t}`).hidden = t !== id;
    $(`tab-${t}`)?.setAttribute("aria-selected", String(t === id));
  }
  if (id === "program") program?.show(program.file, program.line);
}

// --- the picture ---
let view = null;
try {
  const part = decodeMesh(data.part, data.grid, data.deviationStep);
  view = new PartView($("view"), part, data.nominal ? decodeMesh(data.nominal, data.grid, 1) : null, keys.length, placeMark);
} catch (error) {
  $("no-gl").hidden = false;
  $("bar").hidden = true;
}

const modes = [["deviation", "Deviation"], ["line", "Line"], ["tool", "Tool"], ["owner", "Origin"]];
$("modes").append(...modes.map(([id, name], i) => el("button", { role: "radio", id: `mode-${id}`, title: `Key ${i + 1}`, disabled: id === "deviation" && !data.compared, onclick: () => setMode(id) }, name)));

function setMode(mode) {
  if (mode === "deviation" && !data.compared) return;
  state.mode = mode;
  for (const [id] of modes) $(`mode-${id}`).setAttribute("aria-checked", String(id === mode));
  repaint();
}

function repaint() {
  view?.setScheme(state.safe, band);
  view?.setColors(state.mode === "deviation", (i) => colorOfKey(i), keys.length);
  if (data.compared) {
    paintFigures(c, state.safe);
    regionRows = paintRegions(c, state.safe, chooseRegion);
    if (state.region >= 0) regionRows[state.region]?.setAttribute("aria-selected", "true");
  }
  program?.paint();
  paintLegend();
}

function paintLegend() {
  const box = $("legend");
  if (state.mode === "deviation") {
    const w = band.hi - band.lo, steps = [band.hi + w, band.hi + w / 2, band.hi + w / 50, 0, band.lo - w / 50, band.lo - w / 2, band.lo - w];
    const names = [`${signed(band.hi + w, 3)} mm and more`, "material left", signed(band.hi, 3), "in tolerance", signed(band.lo, 3), "gouge", `${signed(band.lo - w, 3)} mm and less`];
    box.replaceChildren(el("div", { class: "ramp" }, steps.flatMap((d, i) => [el("i", { style: { background: css(deviationColor(d, band, state.safe)) } }), el("span", {}, names[i])])));
    return;
  }
  const items = state.mode === "owner" ? [["cut", kCutColor], ["stock", kStockColor]]
    : state.mode === "tool" ? [...tools.map((t, i) => [keys.find((k) => k.tool === t && !k.stock).toolName || "tool", listColor(i)]).map(([n, col]) => [`tool ${n}`, col]), ["stock", kStockColor]]
    : [["stock", kStockColor]];
  box.replaceChildren(el("div", { class: "keys" }, items.slice(0, 12).flatMap(([name, color]) => [el("i", { style: { background: css(color) } }), el("span", {}, name)])),
    state.mode === "line" ? el("span", { class: "dim" }, "a colour for each line") : "");
}

// --- selection: a place, a line or a region ---
function placeMark() {
  crashes.forEach((k, i) => {
    const p = view?.project(k.at);
    crashMarks[i].hidden = !p?.front;
    if (p) Object.assign(crashMarks[i].style, { left: `${p.x}px`, top: `${p.y}px` });
  });
  const mark = $("mark");
  if (!state.mark || !view) { mark.hidden = true; return; }
  const p = view.project(state.mark);
  mark.hidden = !p.front;
  mark.style.left = `${p.x}px`;
  mark.style.top = `${p.y}px`;
}

function setMark(where) {
  state.mark = where;
  placeMark();
}

function showPicked(headline, lines, color) {
  const box = $("picked");
  box.hidden = !headline;
  $("stage").classList.toggle("has-pick", Boolean(headline));
  if (!headline) return;
  box.style.borderLeftColor = color;
  box.replaceChildren(el("b", {}, headline), ...lines);
}

const textOf = (file, line) => {
  const p = data.programs[file], at = p ? p.numbers.indexOf(line) : -1;
  return at >= 0 ? p.lines[at].trim() : "";
};

function describeKey(i) {
  const k = keys[i];
  if (k.stock) return [el("span", {}, " on the stock: no line cut here")];
  return [el("span", {}, ` ${k.name}${k.line > 0 ? `:${k.line}` : ""}${k.toolName ? ` \u00b7 tool ${k.toolName}` : ""}`), textOf(k.file, k.line) ? el("code", {}, textOf(k.file, k.line)) : null];
}

function choosePlace(x, y) {
  const hit = view.pick(x, y);
  if (!hit) return clear();
  const i = view.part.owner[hit.face], k = keys[i];
  clearRegion();
  setMark(hit.place);
  view.select(k.stock ? [] : keysOf(k.file, k.line));
  const color = css(state.mode === "deviation" ? deviationColor(hit.deviation, band, state.safe) : colorOfKey(i));
  showPicked(data.compared ? `${signed(hit.deviation, 4)} mm` : place(hit.place), [...describeKey(i), data.compared ? el("div", {}, el("span", {}, place(hit.place))) : null].filter(Boolean), color);
  if (!k.stock && program) { openTab("program"); program.show(k.file, k.line); }
}

function chooseLine(file, line) {
  const list = keysOf(file, line);
  clearRegion();
  setMark(null);
  program.show(file, line, true);
  view?.select(list);
  const crash = crashOf(data.programs[file].file, line);
  if (crash) return showCollision(crashes.indexOf(crash));
  if (!list.length) return showPicked(`Line ${line}`, [el("span", {}, " cut nothing that is still there")], "currentColor");
  const f = list.map((i) => figuresOf.get(i)).filter(Boolean);
  const area = f.reduce((s, l) => s + l.area, 0), out = f.reduce((s, l) => s + l.out_area, 0);
  const range = data.compared && f.length ? el("div", {}, el("span", {}, `${area.toFixed(1)} mm\u00b2, ${signed(Math.min(...f.map((l) => l.min)))} to ${signed(Math.max(...f.map((l) => l.max)))} mm${out > 0 ? `, ${out.toFixed(1)} mm\u00b2 out of tolerance` : ", in tolerance"}`)) : null;
  showPicked(`Line ${line}`, [el("code", {}, textOf(file, line)), range].filter(Boolean), css(chip(list)));
}

function showCollision(i) {
  const k = crashes[i];
  setMark(k.at);
  crashRows.forEach((row, at) => row.setAttribute("aria-selected", String(at === i)));
  showPicked(`Collision ${i + 1}`, [el("span", {}, ` ${collisionRow(k)}`), el("code", {}, k.text.trim()), el("div", {}, el("span", {}, place(k.at)))], "var(--bad)");
}

function chooseCollision(i) {
  clearRegion();
  const k = crashes[i];
  view?.select([]);
  view?.flyTo(k.at, [0, 0, 1], [k.at, k.at]);
  showCollision(i);
  crashRows[i].scrollIntoView({ block: "nearest" });
  const file = data.programs.findIndex((p) => p.file.split("/").pop() === k.file.split("/").pop());
  if (program && file >= 0) program.show(file, k.line);
}

function chooseRegion(i) {
  clearRegion();
  const r = c.regions[i];
  state.region = i;
  regionRows[i].setAttribute("aria-selected", "true");
  regionRows[i].scrollIntoView({ block: "nearest" });
  view?.select([]);
  view?.flyTo(r.at, r.normal, r.extent);
  setMark(r.at);
  const l = r.lines[0];
  showPicked(`${signed(r.worst, 4)} mm`, [el("span", {}, r.kind === "gouge" ? " cut too deep" : " left standing"),
    ...r.lines.slice(0, 3).map((b) => el("code", {}, `${b.role === "beside" ? "next to " : ""}${b.file}:${b.line}  ${b.text.trim()}`)), el("div", {}, el("span", {}, place(r.at)))], css(deviationColor(r.worst, band, state.safe)));
  if (l && program) program.show(Math.max(0, data.programs.findIndex((p) => p.file === l.file)), l.line);
}

function clearRegion() {
  if (state.region >= 0) regionRows[state.region]?.setAttribute("aria-selected", "false");
  state.region = -1;
  crashRows.forEach((row) => row.setAttribute("aria-selected", "false"));
}
function clear() {
  clearRegion();
  setMark(null);
  view?.select([]);
  showPicked("", [], "");
  program?.show(program.file, 0, false);
}

// --- controls ---
$("safe").addEventListener("change", (e) => { state.safe = e.target.checked; repaint(); });
$("edges").addEventListener("change", (e) => view.showEdges(e.target.checked));
$("nominal").addEventListener("change", (e) => view.showNominal(e.target.checked));
$("nominal-box").hidden = !data.nominal;
$("figures").hidden = $("safe").parentElement.hidden = !data.compared;
for (const b of $("views").children) b.addEventListener("click", () => view.look(b.dataset.view));

function section() {
  const axis = $("section-axis").value, slider = $("section-at");
  slider.hidden = $("section-out").hidden = !axis;
  const at = view.setPlane(axis, slider.value / 1000);
  $("section-out").textContent = axis ? `${axis} ${at.toFixed(2)} mm` : "";
}
$("section-axis").addEventListener("change", section);
$("section-at").addEventListener("input", section);

if (view) {
  const canvas = $("view");
  let down = null;
  canvas.addEventListener("pointerdown", (e) => { down = [e.clientX, e.clientY]; });
  canvas.addEventListener("pointerup", (e) => {
    if (!down || Math.hypot(e.clientX - down[0], e.clientY - down[1]) > 4) return;
    const box = canvas.getBoundingClientRect();
    choosePlace(e.clientX - box.left, e.clientY - box.top);
  });
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  const style = getComputedStyle(document.documentElement);
  view?.setInk(style.getPropertyValue("--ink").trim(), style.getPropertyValue("--dim").trim());
}
const dark = matchMedia("(prefers-color-scheme: dark)");
dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));
const flipTheme = () => setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
$("theme").addEventListener("click", flipTheme);

const toggle = (id) => { const box = $(id); if (!box.disabled && !box.closest("[hidden]")) box.click(); };
const shortcuts = {
  1: () => setMode("deviation"), 2: () => setMode("line"), 3: () => setMode("tool"), 4: () => setMode("owner"),
  j: () => c.regions.length && chooseRegion((state.region + 1) % c.regions.length),
  k: () => c.regions.length && chooseRegion((Math.max(state.region, 0) - 1 + c.regions.length) % c.regions.length),
  n: () => toggle("nominal"), e: () => toggle("edges"), f: () => view?.look("iso"), t: flipTheme, Escape: clear,
  s: () => { const axis = $("section-axis"); axis.value = axis.value ? "" : "X"; section(); },
};
addEventListener("keydown", (e) => {
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.matches?.('select, input[type=range]')) return;
  const act = shortcuts[e.key.length === 1 ? e.key.toLowerCase() : e.key];
  if (act) { act(); return; }
  if (!view || e.target !== $("view")) return;
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
  if (turns[e.key]) { view.turn(...turns[e.key]); e.preventDefault(); }
  if (e.key === "+" || e.key === "=") view.zoom(0.88);
  if (e.key === "-") view.zoom(1.14);
});

paintRun(data, (file, line) => {
  const at = data.programs.findIndex((p) => p.file.split("/").pop() === file.split("/").pop());
  if (at >= 0) { openTab("program"); chooseLine(at, line); }
});
if (view) section();
setTheme(dark.matches ? "dark" : "light");
setMode(state.mode);
openTab(crashCount ? "collisions" : data.compared && c.region_count > 0 ? "regions" : hasProgram ? "program" : "run");
document.documentElement.dataset.ready = "true";
// For tests: where a point of the part is on the screen, and what has been chosen.
window.mrsimReport = { view, data, state };
