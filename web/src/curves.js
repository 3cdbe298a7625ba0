// Removal rate, load and feed along the run, with cuts in the air and collisions.
import { el, grouped } from "./dom.js";
import { kRapid } from "./play.js";

const kBins = 600;
const kNothing = 1e-3; // mm^3, a cut that removes less is in the air

/// Means of equal shares of the time: rate in mm^3/s, load (cross-section of what a cut removes) in mm^2, feed in mm/min, share of the
/// time in the air.
export function sampleRun(play) {
  const { motions, total } = play, [rate, load, feed, air, filled] = Array.from({ length: 5 }, () => new Float64Array(kBins));
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
        if (cuts && motions.length[i] > 0) load[b] += (share * motions.removed[i]) / motions.length[i];
        if (idle) air[b] += share;
      }
    }
  for (let b = 0; b < kBins; ++b) for (const row of [rate, load, feed, air]) row[b] /= filled[b] || 1;
  return { rate, load, feed, air, mostRate: Math.max(...rate), mostLoad: Math.max(...load), mostFeed: Math.max(...feed) };
}

export class Curves {
  /// `crashes`: shares of the time.
  constructor(canvas, run, crashes) {
    Object.assign(this, { canvas, run, crashes, still: document.createElement("canvas"), stillOf: "" });
  }
  /// The elements that name the colours.
  legend() {
    const { run } = this, key = (name, text) => [el("span", {}, el("i", { style: { background: `var(${name})` } }), text)];
    return [...(run.mostRate > 0 ? key("--rate", `removal, at most ${(run.mostRate * 0.06).toPrecision(3)} cm\u00b3/min`) : []), ...(run.mostLoad > 0 ? key("--load", `load, at most ${run.mostLoad.toPrecision(3)} mm\u00b2`) : []), ...key("--feed", `feed, at most ${grouped(run.mostFeed)} mm/min`),
      ...(run.air.some((a) => a > 0) ? key("--air", "cuts air") : []), ...(this.crashes.length ? key("--bad", "collision") : [])];
  }
  /// `now` and `mark` are shares of the time; a mark below 0 is none.
  draw(now, mark) {
    const { canvas, still } = this, w = canvas.clientWidth, h = canvas.clientHeight, scale = Math.min(devicePixelRatio || 1, 2);
    if (!w || !h) return;
    const of = [w, h, scale, document.documentElement.dataset.theme].join(" ");
    if (of !== this.stillOf) {
      for (const one of [canvas, still]) Object.assign(one, { width: Math.round(w * scale), height: Math.round(h * scale) });
      this.drawStill(w, h, scale);
      this.stillOf = of;
    }
    const c = canvas.getContext("2d");
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, canvas.width, canvas.height);
    c.drawImage(still, 0, 0);
    c.setTransform(scale, 0, 0, scale, 0, 0);
    if (mark >= 0) this.line(c, mark, "--focus", w, h);
    this.line(c, now, "--ink", w, h);
  }
  line(c, share, name, w, h) {
    c.fillStyle = this.color(name);
    c.fillRect(Math.min(w - 2, share * w), 0, 2, h);
  }
  // What no moment changes.
  drawStill(w, h, scale) {
    const { run } = this, c = this.still.getContext("2d"), style = getComputedStyle(document.documentElement), colors = new Map();
    this.color = (name) => colors.get(name) ?? colors.set(name, style.getPropertyValue(name).trim()).get(name);
    c.setTransform(scale, 0, 0, scale, 0, 0);
    const x = (b) => (b / kBins) * w, y = (value, most) => h - 3 - (most > 0 ? (value / most) * (h - 8) : 0);
    c.fillStyle = this.color("--air");
    for (let b = 0; b < kBins; ++b) {
      c.globalAlpha = run.air[b];
      if (run.air[b] > 0) c.fillRect(x(b), 0, w / kBins + 0.5, h);
    }
    c.globalAlpha = 1;
    const steps = (values, most) => { for (let b = 0; b < kBins; ++b) for (const end of [b, b + 1]) c.lineTo(x(end), y(values[b], most)); };
    c.fillStyle = this.color("--rate");
    c.beginPath();
    c.moveTo(0, h);
    steps(run.rate, run.mostRate);
    c.lineTo(w, h);
    c.fill();
    c.lineWidth = 1;
    for (const [name, values, most] of [["--load", run.load, run.mostLoad], ["--feed", run.feed, run.mostFeed]]) {
      if (!(most > 0)) continue;
      c.strokeStyle = this.color(name);
      c.beginPath();
      steps(values, most);
      c.stroke();
    }
    for (const share of this.crashes) this.line(c, share, "--bad", w, h);
  }
}
