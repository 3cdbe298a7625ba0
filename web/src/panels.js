// Figures, histogram, regions, and what is known of the run.
import { $, clock, el, grouped, place, plain, signed, volume } from "./dom.js";
import { css, deviationColor } from "./colors.js";

export function paintVerdict(c, compared) {
  const box = $("verdict");
  if (!compared) return;
  const words = { accepted: "In tolerance", rejected: "Out of tolerance", none: "No tolerance given" };
  box.className = c.verdict;
  box.replaceChildren(el("strong", {}, words[c.verdict]),
    el("span", {}, `${c.verdict === "none" ? "shown against" : "tolerance"} ${signed(c.tolerance.lo, 3)} / ${signed(c.tolerance.hi, 3)} mm`));
}

/// "the shank of T4, 2.315 mm deep, in a rapid"
export const collisionRow = (k) => `the ${k.part} of T${k.tool}, ${plain(k.depth, 3)} mm deep${k.rapid ? ", in a rapid" : ""}`;

export function paintCrashes(count, worst, open) {
  const box = $("crashes");
  if (!count) return;
  box.hidden = false;
  box.addEventListener("click", open);
  box.replaceChildren(el("strong", {}, count === 1 ? "1 collision" : `${grouped(count)} collisions`), el("span", {}, worst ? `worst: ${collisionRow(worst)}` : "beyond those listed"));
}

export function paintCollisions({ lines, more }, choose) {
  const rows = lines.map((k, i) => {
    const go = () => choose(i);
    return el("tr", { tabindex: 0, "aria-selected": "false", onclick: go, onkeydown: (e) => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); go(); } } },
      el("td", { class: "n" }, String(i + 1)), el("td", { class: "n" }, el("b", {}, plain(k.depth, 3))),
      el("td", {}, el("span", {}, `${k.part} of T${k.tool}${k.rapid ? ", rapid" : ""}`), el("div", { class: "dim" }, `${volume(k.volume)} \u00b7 ${k.file.split("/").pop()}:${k.line} \u00b7 at ${clock(k.seconds)}, motion ${grouped(k.motion)}${k.motions > 1 ? `, ${k.motions} of this line` : ""}`), k.text ? el("code", {}, k.text.trim()) : null));
  });
  $("panel-collisions").replaceChildren(el("table", { role: "grid" }, el("thead", {}, el("tr", {}, el("th", { class: "n" }, "#"), el("th", { class: "n" }, "mm deep"), el("th", {}, "What runs into material"))), el("tbody", {}, rows)),
    more ? el("p", { class: "empty" }, `${grouped(more)} more lines are not listed.`) : el("span"));
  return rows;
}

export function paintFigures(c, safe) {
  const p = c.part_to_nominal, n = c.nominal_to_part, h = c.hausdorff.symmetric;
  const pairs = [["Worst gouge", signed(Math.min(p.min, n.min, 0), 4)], ["Most left", signed(Math.max(p.max, n.max, 0), 4)],
    ["In tolerance", `${(100 * p.in_tolerance).toFixed(2)} %`], ["RMS", plain(p.rms, 4)], ["Mean", signed(p.mean, 4)], ["Median", signed(p.median, 4)],
    ["Hausdorff", `${plain(h.lower, 4)}\u2026${plain(h.upper, 4)}`], ["Volume gouged", `${grouped(c.volume.gouge, 2)} mm\u00b3`], ["Volume left", `${grouped(c.volume.excess, 2)} mm\u00b3`]];
  $("figures").replaceChildren(histogram(c.histogram, c.tolerance, safe),
    el("dl", { class: "grid" }, pairs.map(([k, v]) => el("div", {}, el("dt", {}, k), el("dd", {}, v)))),
    ...c.hints.map((hint) => el("p", { class: "hint" }, hint.text)));
}

// Square roots of the shares: a gouge is a small share, and must be seen.
function histogram(h, band, safe) {
  const w = 400, height = 96, base = 76, n = h.share.length, most = Math.sqrt(Math.max(...h.share, 1e-9));
  const x = (mm) => ((mm - h.lo) / (h.hi - h.lo)) * w;
  const svg = el("svg", { id: "hist", viewBox: `0 0 ${w} ${height}`, role: "img", "aria-label": "Share of the surface by deviation" });
  svg.append(el("rect", { x: x(band.lo), y: 0, width: x(band.hi) - x(band.lo), height: base, fill: "currentColor", opacity: 0.06 }));
  h.share.forEach((share, i) => {
    if (share <= 0) return;
    const mm = h.lo + ((i + 0.5) / n) * (h.hi - h.lo), tall = Math.max(1.5, (Math.sqrt(share) / most) * (base - 6));
    const bar = el("rect", { x: (i / n) * w + 0.5, y: base - tall, width: w / n - 1, height: tall, fill: css(deviationColor(mm, band, safe)), stroke: "currentColor", "stroke-opacity": 0.35, "stroke-width": 0.5 });
    const edge = i === 0 ? "below " : i === n - 1 ? "above " : "";
    bar.append(el("title", {}, `${edge}${signed(mm, 3)} mm: ${(100 * share).toFixed(2)} % of the surface`));
    svg.append(bar);
  });
  svg.append(el("line", { x1: 0, x2: w, y1: base, y2: base, stroke: "currentColor", "stroke-width": 1 }));
  const marks = [...new Set([band.lo, 0, band.hi])];
  for (const mm of marks) {
    svg.append(el("line", { x1: x(mm), x2: x(mm), y1: base, y2: base + 4, stroke: "currentColor" }));
    svg.append(el("text", { x: x(mm), y: base + 16, "text-anchor": "middle" }, mm === 0 ? "0" : signed(mm, 3)));
  }
  svg.append(el("text", { x: 0, y: base + 16 }, "gouge"), el("text", { x: w, y: base + 16, "text-anchor": "end" }, "left (mm)"));
  return svg;
}

export function paintRegions(c, safe, choose) {
  const panel = $("panel-regions");
  if (!c.regions.length) {
    panel.replaceChildren(el("p", { class: "empty" }, "Nothing is out of tolerance."));
    return [];
  }
  const rows = c.regions.map((r, i) => {
    const l = r.lines[0], color = css(deviationColor(r.worst, c.tolerance, safe));
    const blame = !l ? el("span", { class: "dim" }, r.stock_share > 0.5 ? "the stock itself" : "no line known")
      : el("span", {}, el("span", { class: "dim" }, `${l.role === "beside" ? "uncut, next to " : ""}${l.file}:${l.line}${l.tool ? ` \u00b7 tool ${l.tool}` : ""}`), l.text ? el("code", { title: l.text }, l.text.trim()) : null,
        r.lines.length > 1 ? el("span", { class: "dim" }, `and ${r.lines.length - 1} more line${r.lines.length > 2 ? "s" : ""}`) : null);
    const go = () => choose(i);
    return el("tr", { tabindex: 0, "aria-selected": "false", onclick: go, onkeydown: (e) => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); go(); } } },
      el("td", { class: "n" }, String(i + 1)),
      el("td", {}, el("span", { class: "swatch", style: { background: color } }), el("b", {}, signed(r.worst, 3)), el("div", { class: "dim" }, r.kind === "gouge" ? "gouge" : "left")),
      el("td", { class: "n" }, grouped(r.area || r.nominal_area, 1)), el("td", {}, blame));
  });
  panel.replaceChildren(el("table", { role: "grid" }, el("thead", {}, el("tr", {}, el("th", { class: "n" }, "#"), el("th", {}, "Worst, mm"), el("th", { class: "n" }, "mm\u00b2"), el("th", {}, "Cut by"))),
    el("tbody", {}, rows)), c.region_count > c.regions.length ? el("p", { class: "empty" }, `${c.region_count - c.regions.length} smaller regions are not listed.`) : el("span"));
  return rows;
}

const table = (title, rows) => (rows.length ? [el("h2", {}, title), el("table", {}, el("tbody", {}, rows.map((r) => el("tr", {}, r.map((cell) => el("td", {}, cell))))))] : []);

export function paintRun(data, goToLine) {
  const c = data.comparison, f = data.facts, tool = (t) => [t.id ? `T${t.id}` : "tool", [t.type, t.diameter ? `\u00d8${t.diameter}` : "", t.corner_radius ? `corner R${t.corner_radius}` : "", t.nose_radius ? `nose R${t.nose_radius}` : "", t.origin ? `(${t.origin})` : ""].filter(Boolean).join(" ")];
  const line = (d) => el("button", { class: "link", onclick: () => goToLine(d.file, d.line) }, `${d.file.split("/").pop()}:${d.line}`);
  const parts = [
    ...table("Messages", f.diagnostics.map((d) => [d.line ? line(d) : d.file, el("span", {}, el("span", { class: `severity-${d.severity}` }, `${d.severity}: `), `${d.text} [${d.code}]`)])),
    ...table("Run", f.facts), ...table("Tools", f.tools.map(tool)),
    ...table("Time", f.times.map(([name, s]) => [name, `${s.toFixed(2)} s`]))];
  if (data.compared) {
    const rows = (x) => [["Samples", `${grouped(x.samples)}, ${x.density.toPrecision(3)} a mm\u00b2, and ${grouped(x.vertices)} vertices`], ["Min", `${signed(x.min)} mm at ${place(x.min_at)}`], ["Max", `${signed(x.max)} mm at ${place(x.max_at)}`],
      ["Mean, median", `${signed(x.mean)}, ${signed(x.median)} mm`], ["Mean absolute, RMS, sigma", `${plain(x.mean_absolute)}, ${plain(x.rms)}, ${plain(x.standard_deviation)} mm`],
      ["1, 5, 95, 99 %", [1, 5, 95, 99].map((k) => signed(x.percentiles[k])).join(", ") + " mm"], ["Out: left, gouged", `${grouped(x.excess_area, 2)}, ${grouped(x.gouge_area, 2)} mm\u00b2`]];
    parts.push(...table("Part to nominal", rows(c.part_to_nominal)), ...table("Nominal to part", rows(c.nominal_to_part)));
    const v = c.volume;
    parts.push(...table("Volume", [["Part, nominal", `${grouped(v.part, 3)}, ${grouped(v.nominal, 3)} mm\u00b3`], ["Left, gouged", `${grouped(v.excess, 3)}, ${grouped(v.gouge, 3)} mm\u00b3 (\u00b1${v.error.toPrecision(2)})`]]));
    parts.push(...table("Alignment", [["Method", c.align], ["Shift", place(c.transform.shift)]]));
  }
  parts.push(...table("Report", [["Made by", data.generator], ["Shown", `${grouped(data.part.triangles)} triangles${data.reduced ? ", reduced for display" : ""}`]]),
    ...table("Keys", [["1 2 3 4", "colour by deviation, line, tool, origin"], ["Space , . Home End", "play or pause, a line back or on, start, end"], ["G", "to the moment of what is chosen"], ["J K", "next and previous region"], ["P E N S", "path, edges, nominal, section"],
      ["O M", "parallel, measure"], ["Arrows + \u2212", "turn and zoom"], ["F, Esc", "fit, clear the selection"], ["T", "light or dark"]]));
  $("panel-run").replaceChildren(...parts);
}
