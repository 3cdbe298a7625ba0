// The program's text, only the rows in sight: programs have a million lines.
import { $, el } from "./dom.js";
import { css } from "./colors.js";

const kRow = 21;

export class ProgramPane {
  /// `keysOf(file, line)` -> indices of what that line cut; `chip(keys)` -> colour; `choose` on click.
  constructor(programs, keysOf, chip, notes, choose) {
    Object.assign(this, { programs, keysOf, chip, notes, choose, file: 0, line: 0, now: { file: -1, line: 0 } });
    this.box = el("div", { id: "code", tabindex: 0, role: "listbox", "aria-label": "Program" });
    this.rows = el("div", { class: "rows" });
    this.box.append(this.rows);
    this.box.addEventListener("scroll", () => this.paint());
    this.box.addEventListener("keydown", (e) => this.key(e));
    new ResizeObserver(() => this.paint()).observe(this.box);
    const panel = $("panel-program");
    const select = el("select", { "aria-label": "Program file", onchange: (e) => this.open(Number(e.target.value)) },
      programs.map((p, i) => el("option", { value: i }, p.file)));
    this.select = select;
    panel.append(el("div", { id: "files" }, programs.length > 1 ? select : el("span", {}, programs[0]?.file ?? ""),
      el("span", {}, "Click a line: what it cut")), this.box);
    this.open(0);
  }
  open(file) {
    if (!this.programs[file]) return;
    this.file = file;
    this.select.value = file;
    const p = this.programs[file];
    this.rows.style.height = `${p.lines.length * kRow}px`;
    this.widest = p.lines.reduce((w, l) => Math.max(w, l.length), 0);
    this.rows.style.width = `${this.widest + 12}ch`;
    this.paint();
  }
  paint() {
    const p = this.programs[this.file];
    if (!p) return;
    const first = Math.max(0, Math.floor(this.box.scrollTop / kRow) - 5);
    const last = Math.min(p.lines.length, first + Math.ceil((this.box.clientHeight || 400) / kRow) + 12);
    const rows = [];
    for (let i = first; i < last; ++i) {
      const number = p.numbers[i], keys = this.keysOf(this.file, number), note = this.notes(p.file, number);
      const color = keys.length ? css(this.chip(keys)) : "transparent";
      const chosen = number === this.line;
      rows.push(el("div", { class: `row${keys.length ? " cuts" : ""}${chosen ? " selected" : ""}${number === this.now.line && this.file === this.now.file ? " now" : ""}`, style: { top: `${i * kRow}px` },
        role: "option", "aria-selected": chosen, "data-line": number,
        onclick: () => this.choose(this.file, number) },
        el("i", { style: { background: color } }), el("u", {}, String(number)), p.lines[i], note ? el("em", {}, note) : null));
    }
    this.rows.replaceChildren(...rows);
  }
  /// Marks a line and brings it into sight.
  show(file, line, scroll = true) {
    if (file !== this.file && this.programs[file]) this.open(file);
    this.line = line;
    if (scroll) this.reach(line);
    this.paint();
  }
  /// The line that is run at the moment, kept in sight; { file: -1 } for none.
  follow(now) {
    if (now.file === this.now.file && now.line === this.now.line) return;
    this.now = now;
    if (now.file < 0) return this.paint();
    if (now.file !== this.file && this.programs[now.file]) this.open(now.file);
    this.reach(now.line);
    this.paint();
  }
  reach(line) {
    const at = this.rowOf(line);
    if (at < 0) return;
    const top = at * kRow, height = this.box.clientHeight || 400;
    if (top < this.box.scrollTop + kRow || top > this.box.scrollTop + height - 2 * kRow) this.box.scrollTop = Math.max(0, top - height / 2);
  }
  // Numbers ascend.
  rowOf(line) {
    const numbers = this.programs[this.file]?.numbers ?? [];
    let low = 0, high = numbers.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (numbers[middle] < line) low = middle + 1; else high = middle;
    }
    return numbers[low] === line ? low : -1;
  }
  key(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const p = this.programs[this.file];
    // To the next line that cut something still to be seen.
    for (let i = this.rowOf(this.line) + step; i >= 0 && i < p.numbers.length; i += step)
      if (this.keysOf(this.file, p.numbers[i]).length) return this.choose(this.file, p.numbers[i]);
  }
}
