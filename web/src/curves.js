// Removal rate and feed along the run, with cuts in the air and collisions.
import { el, grouped } from "./dom.js";
import { kRapid } from "./play.js";

const kBins = 600;
const kNothing = 1e-3; // mm^3, a cut that removes less is in the air

/// Means of equal shares of the time: rate in mm^3/s, feed in mm/min, share of the time in the air.
export function sampleRun(play) {
  const { motions, total } = play, rate = new Float64Array(kBins), feed = new Float64Array(kBins), air = new Float64Array(kBins), filled = new Float64Array(kBins);
  if (total > 0)
    for (let i = 0; i < motions.count; ++i) {
      const seconds = motions.seconds[i];
      if (!(seconds > 0)) continue;
      const begin = (motions.begin[i] / total) * kBins, end = ((motions.begin[i] + seconds) / total) * kBins;
      const cuts = motions.kind[i] !== kRapid, idle = cuts && play.stock && motions.removed[i] < kNothing;
      for (let b = Math.floor(begin); b < Math.min(kBins, end); ++b) {
        const share = Math.min(b + 1, end) - Math.max(b, begin);
        filled[b] += share;
        rate[b] += (share * motions.removed[i]) / seconds;
        if (cuts) feed[b] += (share * 60 * motions.length[i]) / seconds;
        if (idle) air[b] += share;
      }
    }
  for (let b = 0; b < kBins; ++b) for (const row of [rate, feed, air]) row[b] /= filled[b] || 1;
  return { rate, feed, air, mostRate: Math.max(...rate), mostFeed: Math.max(...feed) };
}

/// Draws them; returns the legend's elements. `now`, `mark` and `crashes` are shares of the time.
export function drawCurves(canvas, run, { now, mark, crashes }) {
  const w = canvas.clientWidth, h = canvas.clientHeight, scale = Math.min(devicePixelRatio || 1, 2);
  if (!w || !h) return [];
  if (canvas.width !== Math.round(w * scale) || canvas.height !== Math.round(h * scale)) { canvas.width = Math.round(w * scale); canvas.height = Math.round(h * scale); }
  const c = canvas.getContext("2d"), style = getComputedStyle(document.documentElement), color = (name) => style.getPropertyValue(name).trim();
  c.setTransform(scale, 0, 0, scale, 0, 0);
  c.clearRect(0, 0, w, h);
  const x = (b) => (b / kBins) * w, y = (value, most) => h - 3 - (most > 0 ? (value / most) * (h - 8) : 0);
  c.fillStyle = color("--air");
  for (let b = 0; b < kBins; ++b) {
    c.globalAlpha = run.air[b];
    if (run.air[b] > 0) c.fillRect(x(b), 0, w / kBins + 0.5, h);
  }
  c.globalAlpha = 1;
  c.fillStyle = color("--rate");
  c.beginPath();
  c.moveTo(0, h);
  for (let b = 0; b < kBins; ++b) { c.lineTo(x(b), y(run.rate[b], run.mostRate)); c.lineTo(x(b + 1), y(run.rate[b], run.mostRate)); }
  c.lineTo(w, h);
  c.fill();
  c.strokeStyle = color("--feed");
  c.lineWidth = 1;
  c.beginPath();
  for (let b = 0; b < kBins; ++b) { c.lineTo(x(b), y(run.feed[b], run.mostFeed)); c.lineTo(x(b + 1), y(run.feed[b], run.mostFeed)); }
  c.stroke();
  const line = (share, name, wide) => { c.fillStyle = color(name); c.fillRect(Math.min(w - wide, share * w), 0, wide, h); };
  for (const share of crashes) line(share, "--bad", 2);
  if (mark >= 0) line(mark, "--focus", 2);
  line(now, "--ink", 2);
  const key = (name, text) => [el("span", {}, el("i", { style: { background: `var(${name})` } }), text)];
  return [...(run.mostRate > 0 ? key("--rate", `removal, at most ${(run.mostRate * 0.06).toPrecision(3)} cm\u00b3/min`) : []), ...key("--feed", `feed, at most ${grouped(run.mostFeed)} mm/min`),
    ...(run.air.some((a) => a > 0) ? key("--air", "cuts air") : []), ...(crashes.length ? key("--bad", "collision") : [])];
}
