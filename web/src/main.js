import { $, clock, el, place, signed } from "./dom.js";
import { css, deviationColor, kCutColor, kStockColor, rampColor, toolColor } from "./colors.js";
import { data } from "./data.js";
import { decodeMesh } from "./decode.js";
import { collisionRow, paintCollisions, paintCrashes, paintFigures, paintRegions, paintRun, paintVerdict } from "./panels.js";
import { listenToKeys } from "./keyboard.js";
import { Keys } from "./keys.js";
import { Measure } from "./measure.js";
import { Play } from "./play.js";
import { PlayView } from "./play_view.js";
import { ProgramPane } from "./program.js";
import { PartView } from "./scene.js";
import { Timeline } from "./timeline.js";

const c = data.comparison, band = c.tolerance, keys = data.keys;
const state = { mode: data.compared ? "deviation" : "line", safe: false, region: -1, mark: null, motion: -1, framed: null };
const play = data.play ? new Play(data.play) : null;
const lineKeys = new Keys(data, play), { tools, rank, rankCount } = lineKeys, keyOfMoment = lineKeys.ofMoment;
const pathOnly = Boolean(play && !play.stock);
const figuresOf = new Map(c.lines.map((l, i) => [i, l])); // in the order of the keys

const keysOf = (file, line) => lineKeys.of(file, line);

function colorOfKey(i) {
  const k = keys[i];
  if (state.mode === "owner") return k.stock ? kStockColor : kCutColor;
  if (k.stock) return kStockColor;
  return state.mode === "tool" ? toolColor(tools.indexOf(k.tool)) : rampColor(rank[i], rankCount);
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
let measure = null; // made with the picture
$("title").textContent = data.facts.title || c.part || "Part";
document.title = `${$("title").textContent} \u2013 mrsim`;
$("subtitle").textContent = data.compared ? `${c.part || "part"} against ${c.nominal || "nominal"}` : pathOnly ? "Tool path" : "Part as cut";
$("totals").append(...data.facts.facts.filter(([name]) => ["Volume", "Removed", "Cycle"].includes(name)).map(([name, value]) => el("span", {}, `${name.toLowerCase()} ${value}`)));
paintVerdict(c, data.compared);
const hasProgram = data.programs.some((p) => p.lines.length);
const program = hasProgram ? new ProgramPane(data.programs, keysOf, chip, noteOf, chooseLine) : null;
let regionRows = [];

// --- collisions come first: the worst is number 1 ---
const crashes = data.collisions.lines, crashCount = crashes.length + data.collisions.more;
const crashOf = (file, line) => crashes.find((k) => k.line === line && k.file.split("/").pop() === file.split("/").pop());
paintCrashes(crashCount, crashes[0], () => { openTab("collisions"); chooseCollision(0); });
const crashRows = crashes.length ? paintCollisions(data.collisions, chooseCollision) : [];
const crashMarks = crashes.map((k, i) => el("button", { class: "crash", style: { zIndex: crashes.length - i }, title: collisionRow(k), "aria-label": `Collision ${i + 1}: ${collisionRow(k)}`, onclick: () => chooseCollision(i) }, String(i + 1)));
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
const lies = data.facts.facts.some(([name, value]) => name === "Machine" && value === "lathe");
let view = null;
try {
  const part = decodeMesh(data.part, data.grid, data.deviationStep);
  if (pathOnly) part.bounds = play.bounds();
  view = new PartView($("view"), part, data.nominal ? decodeMesh(data.nominal, data.grid, 1) : null, keys.length, placeMark, lies);
} catch (error) {
  $("no-gl").append(` (${error.message})`);
  $("no-gl").hidden = false;
  $("bar").hidden = true;
}

// --- playing ---
let played = null, timeline = null;
if (view && play && play.end > 0) {
  played = new PlayView(view, play, c.transform, (moment) => keyOfMoment[moment]);
  const motionOf = (k) => Math.min(play.end, Math.max(1, k.motion)) - 1;
  $("timeline").hidden = false;
  timeline = new Timeline(play, crashes.map(motionOf), (at) => view.pace.move(() => {
    played.show(at, state.motion);
    const i = Math.min(Math.floor(at), play.end - 1);
    program?.follow(at < play.end ? { file: play.motions.file[i], line: play.motions.line[i] } : { file: -1, line: 0 });
  }));
}
// A line's last motion, -1 where it has none.
const lastMotion = new Map();
if (play) for (let i = 0; i < play.end; ++i) lastMotion.set(`${play.motions.file[i]}:${play.motions.line[i]}`, i);
const motionOfLine = (file, line) => lastMotion.get(`${file}:${line}`) ?? -1;

/// Marks a motion on the time line. At the end its tool is shown; else the run goes there.
function chooseMotion(motion, goes = false) {
  state.motion = motion;
  timeline?.setMark(motion);
  if (!timeline) return;
  if (goes || timeline.at < play.end) { if (motion >= 0) timeline.go(motion + 1 < play.end || !goes ? motion + 1 : play.end - 1e-6); } else played.show(play.end, motion);
}
const goButton = (motion) => (timeline && motion >= 0 ? el("div", {}, el("button", { class: "link", id: "go", title: "Key G", onclick: () => chooseMotion(motion, true) }, `show it at ${clock(play.secondsAt(motion + 1))}`)) : null);

if (view) measure = new Measure(view, (x, y) => (timeline && timeline.at < play.end ? played.pick(x, y) : view.pick(x, y))?.place ?? null);

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
    : state.mode === "tool" ? [...tools.map((t, i) => [keys.find((k) => k.tool === t && !k.stock).toolName || "tool", toolColor(i)]).map(([n, col]) => [`tool ${n}`, col]), ["stock", kStockColor]]
    : [["stock", kStockColor]];
  box.replaceChildren(el("div", { class: "keys" }, items.slice(0, 12).flatMap(([name, color]) => [el("i", { style: { background: css(color) } }), el("span", {}, name)])),
    state.mode === "line" ? el("div", { class: "along" }, el("span", {}, "first line"), el("i", { style: { background: `linear-gradient(90deg, ${Array.from({ length: 9 }, (_, k) => css(rampColor(2 * k, 17))).join(",")})` } }), el("span", {}, "last")) : "");
}

// --- selection: a place, a line or a region ---
function placeMark() {
  placeFrame();
  measure?.place();
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

// On the surface of a moment before the end: the line and the moment of the face.
function choosePlayed(x, y) {
  const hit = played.pick(x, y);
  if (!hit) return clear();
  setMark(hit.place);
  const i = keyOfMoment[play.faces.birth[hit.face]], k = keys[i];
  view.select(k.stock ? [] : keysOf(k.file, k.line));
  showPicked(place(hit.place), describeKey(i), css(colorOfKey(i)));
  if (hit.motion < 0) return;
  if (program) { openTab("program"); program.show(k.file, k.line); }
  state.motion = hit.motion;
  timeline.setMark(hit.motion);
  timeline.go(play.atMoment(play.faces.birth[hit.face]));
}

// Of a page without a stock: the line of the path that is nearest.
function choosePath(x, y) {
  const hit = played.pickPath(x, y);
  if (!hit) return clear();
  const { file, line } = play.motions;
  if (program) openTab("program");
  chooseLine(file[hit.motion], line[hit.motion], hit.motion);
  setMark(hit.place);
}

function choosePlace(x, y) {
  if (!pathOnly && timeline && timeline.at < play.end) return choosePlayed(x, y);
  if (pathOnly) return choosePath(x, y);
  const hit = view.pick(x, y);
  if (!hit) return clear();
  const i = view.part.owner[hit.face], k = keys[i];
  clearRegion();
  setMark(hit.place);
  view.select(k.stock ? [] : keysOf(k.file, k.line));
  const motion = k.stock ? -1 : motionOfLine(k.file, k.line);
  chooseMotion(motion);
  const color = css(state.mode === "deviation" ? deviationColor(hit.deviation, band, state.safe) : colorOfKey(i));
  showPicked(data.compared ? `${signed(hit.deviation, 4)} mm` : place(hit.place), [...describeKey(i), data.compared ? el("div", {}, el("span", {}, place(hit.place))) : null, goButton(motion)].filter(Boolean), color);
  if (!k.stock && program) { openTab("program"); program.show(k.file, k.line); }
}

// A frame about what a line cut, so that a tiny patch is found.
function frameKeys(list) {
  state.framed = list.length && (!timeline || timeline.at >= play.end) ? view?.boundsOfKeys(list) ?? null : null;
  placeFrame();
}
function placeFrame() {
  const frame = $("frame");
  frame.hidden = !state.framed || !view;
  if (frame.hidden) return;
  const { lo, hi } = state.framed, xs = [], ys = [];
  for (let k = 0; k < 8; ++k) {
    const p = view.project([k & 1 ? hi[0] : lo[0], k & 2 ? hi[1] : lo[1], k & 4 ? hi[2] : lo[2]]);
    xs.push(p.x); ys.push(p.y);
  }
  const x = Math.min(...xs) - 5, y = Math.min(...ys) - 5;
  Object.assign(frame.style, { left: `${x}px`, top: `${y}px`, width: `${Math.max(...xs) + 5 - x}px`, height: `${Math.max(...ys) + 5 - y}px` });
}

function chooseLine(file, line, motion = motionOfLine(file, line)) {
  const list = keysOf(file, line);
  clearRegion();
  setMark(null);
  program?.show(file, line, true);
  view?.select(list);
  chooseMotion(motion);
  frameKeys(list);
  const crash = crashOf(data.programs[file].file, line);
  if (crash) return showCollision(crashes.indexOf(crash));
  if (!list.length) return showPicked(`Line ${line}`, [el("span", {}, " cut nothing that is still there")], "currentColor");
  const f = list.map((i) => figuresOf.get(i)).filter(Boolean);
  const area = f.reduce((s, l) => s + l.area, 0), out = f.reduce((s, l) => s + l.out_area, 0);
  const range = data.compared && f.length ? el("div", {}, el("span", {}, `${area.toFixed(1)} mm\u00b2, ${signed(Math.min(...f.map((l) => l.min)))} to ${signed(Math.max(...f.map((l) => l.max)))} mm${out > 0 ? `, ${out.toFixed(1)} mm\u00b2 out of tolerance` : ", in tolerance"}`)) : null;
  showPicked(`Line ${line}`, [el("code", {}, textOf(file, line)), range, goButton(motion)].filter(Boolean), css(chip(list)));
}

function showCollision(i) {
  const k = crashes[i];
  setMark(k.at);
  crashRows.forEach((row, at) => row.setAttribute("aria-selected", String(at === i)));
  showPicked(`Collision ${i + 1}`, [el("span", {}, ` ${collisionRow(k)}`), el("code", {}, k.text.trim()), el("div", {}, el("span", {}, place(k.at))), goButton(k.motion - 1)].filter(Boolean), "var(--bad)");
}

function chooseCollision(i) {
  clearRegion();
  const k = crashes[i];
  view?.select([]);
  // From the side, so far away that the tool is seen, too.
  const reach = played?.toolRadius(k.motion - 1) ?? 0;
  view?.flyTo(k.at, view.inWorld([0.2, -1, 0.1]).toArray(), [-reach, reach].map((by) => k.at.map((x) => x + by)));
  chooseMotion(k.motion - 1);
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
  frameKeys([]);
  measure?.clear();
  view?.select([]);
  state.motion = -1;
  timeline?.setMark(-1);
  if (timeline && timeline.at >= play.end) played.show(play.end);
  showPicked("", [], "");
  program?.show(program.file, 0, false);
}

// --- controls ---
$("safe").addEventListener("change", (e) => { state.safe = e.target.checked; repaint(); });
// Edges tell nothing where they are everywhere.
if (data.part.creases > Math.min(20000, Math.max(5000, 0.15 * data.part.triangles))) { $("edges").checked = false; view?.showEdges(false); }
$("edges").addEventListener("change", (e) => view.showEdges(e.target.checked));
$("nominal").addEventListener("change", (e) => view.showNominal(e.target.checked));
for (const id of ["path", "stock"]) {
  $(`${id}-box`).hidden = !played || pathOnly;
  if (played) $(id).checked = played[`${id}Wanted`];
  $(id).addEventListener("change", (e) => { played[`${id}Wanted`] = e.target.checked; timeline.go(timeline.at); });
}
$("nominal-box").hidden = !data.nominal;
for (const id of ["modes", "section", "legend"]) $(id).hidden = pathOnly;
for (const id of ["edges", "measure"]) $(id).closest("label").hidden = pathOnly;
$("figures").hidden = $("safe").parentElement.hidden = !data.compared;
for (const b of document.querySelectorAll("[data-view]")) b.addEventListener("click", () => view.look(b.dataset.view));
$("parallel").addEventListener("change", (e) => view.setParallel(e.target.checked));

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
    const x = e.clientX - box.left, y = e.clientY - box.top;
    if (measure.active) measure.add(x, y);
    else { frameKeys([]); choosePlace(x, y); }
  });
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  const style = getComputedStyle(document.documentElement);
  view?.setInk(style.getPropertyValue("--ink").trim(), style.getPropertyValue("--dim").trim());
  played?.setInk(view.edges.material.uniforms.ink.value, theme === "dark");
  timeline?.paint();
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
  n: () => toggle("nominal"), p: () => toggle("path"), o: () => toggle("parallel"), m: () => toggle("measure"), g: () => $("go")?.click(), " ": () => timeline?.toggle(), ",": () => timeline?.step(-1), ".": () => timeline?.step(1),
  Home: () => timeline?.go(0), End: () => timeline?.go(play.end), e: () => toggle("edges"), f: () => view?.look("iso"), t: flipTheme, Escape: clear,
  s: () => { const axis = $("section-axis"); axis.value = axis.value ? "" : "X"; section(); },
};
listenToKeys(shortcuts, view);

paintRun(data, (file, line) => {
  const at = data.programs.findIndex((p) => p.file.split("/").pop() === file.split("/").pop());
  if (at >= 0) { openTab("program"); chooseLine(at, line); }
});
if (view) { section(); view.look("iso", false); }
setTheme(dark.matches ? "dark" : "light");
setMode(state.mode);
openTab(crashCount ? "collisions" : data.compared && c.region_count > 0 ? "regions" : hasProgram ? "program" : "run");
played?.warmUp();
document.documentElement.dataset.ready = "true";
// For tests: where a point of the part is on the screen, and what has been chosen.
window.mrsimReport = { view, data, state, play, played, timeline };
