// One key for each thing that the page does; arrows, plus and minus where the picture has the focus.
import { $ } from "./dom.js";

/// `acts` by key; letters of either case.
export function listenToKeys(acts, view) {
  addEventListener("keydown", (e) => {
    if (e.ctrlKey || e.metaKey || e.altKey || e.target.matches?.("select, input[type=range]")) return;
    if (e.key === " " && e.target.matches?.("button, input, [tabindex='0'] tr, tr")) return;
    const act = acts[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    if (act) { act(); if (e.key === " ") e.preventDefault(); return; }
    if (!view || e.target !== $("view")) return;
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    if (turns[e.key]) { view.turn(...turns[e.key]); e.preventDefault(); }
    if (e.key === "+" || e.key === "=") view.zoom(0.88);
    if (e.key === "-") view.zoom(1.14);
  });
}
