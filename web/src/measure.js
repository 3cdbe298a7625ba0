// The distance of two points on the part; near a corner or an edge the point snaps to it.
import { $, el, plain } from "./dom.js";

const kCorner = 10, kEdge = 7; // pixels

export class Measure {
  /// `pick(x, y)` gives the place under a place of the canvas, or null.
  constructor(view, pick) {
    Object.assign(this, { view, pick, points: [] });
    $("measure").addEventListener("change", () => { this.clear(); this.place(); });
  }
  get active() { return $("measure").checked; }
  clear() {
    this.points = [];
    this.place();
  }
  add(x, y) {
    const hit = this.pick(x, y);
    if (!hit) return;
    if (this.points.length === 2) this.points = [];
    this.points.push(this.snapped(hit, x, y));
    this.place();
  }
  // The nearest end of an edge, else the nearest place on one, that lies close to the surface there.
  snapped(hit, x, y) {
    const { part, bounds } = this.view, { crease, position } = part, near = 0.05 * bounds.size;
    let corner = null, edge = null, cornerAt = kCorner, edgeAt = kEdge;
    for (let i = 0; i < crease.length; i += 2) {
      const a = [...position.subarray(3 * crease[i], 3 * crease[i] + 3)], b = [...position.subarray(3 * crease[i + 1], 3 * crease[i + 1] + 3)];
      const d = a.map((v, k) => b[k] - v), square = d[0] ** 2 + d[1] ** 2 + d[2] ** 2;
      const t = square > 0 ? Math.min(1, Math.max(0, hit.reduce((s, v, k) => s + (v - a[k]) * d[k], 0) / square)) : 0;
      const foot = a.map((v, k) => v + t * d[k]);
      if (Math.hypot(...foot.map((v, k) => v - hit[k])) > near) continue;
      const seen = (p) => { const q = this.view.project(p); return Math.hypot(q.x - x, q.y - y); };
      const apart = seen(foot);
      if (apart < edgeAt) { edgeAt = apart; edge = foot; }
      for (const end of [a, b]) { const far = seen(end); if (far < cornerAt) { cornerAt = far; corner = end; } }
    }
    return corner ?? edge ?? hit;
  }
  place() {
    const box = $("ruler");
    if (!this.active) return box.replaceChildren();
    const at = this.points.map((p) => this.view.project(p)), svg = el("svg", { "aria-hidden": "true" });
    if (at.length === 2) svg.append(el("line", { x1: at[0].x, y1: at[0].y, x2: at[1].x, y2: at[1].y }));
    for (const p of at) svg.append(el("circle", { cx: p.x, cy: p.y, r: 4 }));
    const [a, b] = this.points, d = b ? a.map((v, k) => b[k] - v) : null;
    box.replaceChildren(svg, el("p", { role: "status", id: "distance" }, !a ? "Click two points of the part" : !b ? "Click the second point" : `${plain(Math.hypot(...d), 3)} mm \u00b7 X ${plain(d[0], 3)} Y ${plain(d[1], 3)} Z ${plain(d[2], 3)}`));
  }
}
