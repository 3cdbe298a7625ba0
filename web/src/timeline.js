// The time line: buttons, the slider, and what the run does along it (curves.js).
import { $, clock, el, grouped } from "./dom.js";
import { Curves, sampleRun } from "./curves.js";

const kSpeeds = [[1, "real time"], [10, "\u00d7 10"], [100, "\u00d7 100"], [1000, "\u00d7 1000"], [0, "in 20 s"]];
const kWhole = 20; // s, of the last one

export class Timeline {
  /// `show(at)` brings the picture there; `crashes`: motions that collide.
  constructor(play, crashes, show) {
    Object.assign(this, { play, showAt: show, at: play.end, playing: false, mark: -1 });
    const button = (id, text, name, act) => el("button", { id, title: name, "aria-label": name, onclick: act }, text);
    this.slider = el("input", { type: "range", id: "now", min: 0, max: 10000, value: 10000, step: 1, "aria-label": "Moment of the run", oninput: () => this.scrub() });
    this.speed = el("select", { id: "speed", "aria-label": "Speed" }, kSpeeds.map(([value, name]) => el("option", { value, selected: value === 0 }, name)));
    this.output = el("output", { id: "moment" });
    this.canvas = el("canvas", { id: "curves", role: "img", "aria-label": "Removal rate, load and feed along the run" });
    this.legend = el("p", { id: "curve-legend" });
    $("timeline").append(
      el("div", { id: "transport", role: "toolbar", "aria-label": "Playing" },
        el("div", { class: "group" }, button("to-start", "|\u25c2", "Start (Home)", () => this.go(0)), button("back", "\u2039", "One line back (comma)", () => this.step(-1)), button("play", "\u25b6", "Play or pause (Space)", () => this.toggle()),
          button("forward", "\u203a", "One line on (full stop)", () => this.step(1)), button("to-end", "\u25b8|", "End (End)", () => this.go(play.end))),
        el("div", { class: "group" }, this.speed), this.output),
      el("div", { id: "track" }, this.canvas, this.slider), this.legend);
    this.curves = new Curves(this.canvas, sampleRun(play), crashes.map((i) => play.motions.begin[i] / (play.total || 1)));
    this.legend.replaceChildren(...this.curves.legend());
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    this.tell();
  }
  scrub() {
    this.pause();
    this.go(this.slider.value >= 10000 ? this.play.end : this.play.atSeconds((this.slider.value / 10000) * this.play.total));
  }
  /// Goes to a place on the time line: motions that are done, and the share of the next.
  go(at) {
    this.at = Math.min(this.play.end, Math.max(0, at));
    this.showAt(this.at);
    this.tell();
  }
  /// To the end of the next line, or of the one before.
  step(by) {
    this.pause();
    const { play } = this, whole = Math.floor(this.at + 1e-9);
    if (by > 0) return this.go(whole < play.end ? play.blockOf(whole)[1] : play.end);
    if (whole > 0) this.go(play.blockOf(this.at > whole ? whole : whole - 1)[0]);
    else this.go(0);
  }
  toggle() {
    if (this.playing) return this.pause();
    if (this.at >= this.play.end) this.go(0);
    this.playing = true;
    this.paintButton();
    let last = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      // A picture that took long to draw is followed by a short step, not by a jump.
      const factor = Number(this.speed.value) || this.play.total / kWhole, seconds = this.play.secondsAt(this.at) + Math.min(0.1, Math.max(0, now - last) / 1000) * factor;
      last = now;
      // Motions that take no time must not hold it up.
      this.go(seconds >= this.play.total ? this.play.end : Math.max(this.at, this.play.atSeconds(seconds)));
      if (this.at >= this.play.end) this.pause();
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
  pause() {
    this.playing = false;
    this.paintButton();
  }
  paintButton() { $("play").textContent = this.playing ? "\u2016" : "\u25b6"; }
  setMark(motion) {
    this.mark = motion;
    this.paint();
  }
  tell() {
    const { play, at } = this, seconds = play.secondsAt(at), i = Math.min(Math.floor(at), play.end - 1), m = play.motions;
    this.slider.value = at >= play.end ? 10000 : Math.round((seconds / (play.total || 1)) * 10000);
    const tool = play.tools[m.tool[i]]?.id, feed = m.seconds[i] > 0 ? (60 * m.length[i]) / m.seconds[i] : 0;
    const words = at >= play.end ? `${clock(play.total)}, the end` : `${clock(seconds)} of ${clock(play.total)} \u00b7 line ${m.line[i]}${tool ? ` \u00b7 T${tool}` : ""} \u00b7 ${m.kind[i] === 0 ? "rapid" : `${grouped(feed)} mm/min`}`;
    this.output.textContent = words;
    this.slider.setAttribute("aria-valuetext", words);
    this.paint();
  }
  paint() {
    const { play } = this, share = (at) => play.secondsAt(at) / (play.total || 1);
    this.curves.draw(share(this.at), this.mark >= 0 ? share(this.mark + 1) : -1);
  }
}
