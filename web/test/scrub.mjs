// How long a step of the time line takes: node test/scrub.mjs PAGE.html... Moves the slider to 20
// moments, far from one another, and waits each time until the picture is drawn. Prints ms: the first
// step, the middle and the worst of the others, what they consist of, and the CPU time of all threads of
// the browser, which tells more where other programs run, too.
import { basename } from "node:path";
import { open } from "./browser.mjs";

const kSteps = 20, kSize = { width: 1200, height: 800 };

// In the page. A step is what the slider's event does, the frame that the browser draws for it, and
// a pixel of the canvas that is read then, because the drawing is not over before that.
async function scrub(steps) {
  const { view, played, timeline } = window.mrsimReport, gl = view.renderer.getContext(), pixel = new Uint8Array(4);
  const timed = (act) => { const begin = performance.now(); act(); return performance.now() - begin; };
  const showSurface = played.showSurface, out = [];
  let surface = 0;
  played.showSurface = function (...words) { surface = timed(() => showSurface.apply(this, words)); };
  for (let k = 0; k < steps; ++k) {
    const begin = performance.now();
    const script = timed(() => { timeline.slider.value = 500 + (9000 * ((7 * k) % steps)) / steps; timeline.slider.dispatchEvent(new Event("input")); });
    await new Promise(requestAnimationFrame);
    const wait = timed(() => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel));
    out.push({ step: performance.now() - begin, script, surface, wait, triangles: view.renderer.info.render.triangles, sharpness: view.sharpness });
  }
  played.showSurface = showSurface;
  return out;
}

// In the page. The last picture again, and on a single pixel: what its vertices cost.
function again() {
  const { view } = window.mrsimReport, { renderer, scene, camera, canvas } = view, gl = renderer.getContext(), pixel = new Uint8Array(4);
  const least = () => Math.min(...Array.from({ length: 5 }, () => {
    const begin = performance.now();
    renderer.render(scene, camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return performance.now() - begin;
  }));
  const drawn = least();
  renderer.setViewport(0, 0, 1, 1);
  const vertices = least();
  renderer.setViewport(0, 0, canvas.clientWidth, canvas.clientHeight);
  return { drawn, vertices };
}

const browser = await open();
const columns = [["first", 5], ["step", 7], ["worst", 7], ["script", 8], ["surface", 9], ["wait", 6], ["CPU page", 10], ["CPU GL", 8], ["drawn again", 13], ["vertices", 10], ["triangles", 11], ["sharpness", 11]];
console.log("page".padEnd(16) + columns.map(([name, width]) => name.padStart(width)).join(""));
for (const file of process.argv.slice(2)) {
  const page = await browser.page(file, kSize);
  const [first] = await page.evaluate(scrub, 1), before = await browser.cpu(), steps = await page.evaluate(scrub, kSteps), after = await browser.cpu();
  const middle = (key) => steps.map((s) => s[key]).sort((a, b) => a - b)[kSteps / 2];
  const { drawn, vertices } = await page.evaluate(again);
  const figures = [first.step, middle("step"), Math.max(...steps.map((s) => s.step)), middle("script"), middle("surface"), middle("wait"), ...["renderer", "GPU"].map((type) => (1000 * (after[type] - before[type])) / kSteps), drawn, vertices, middle("triangles")].map((x) => x.toFixed(0));
  console.log(basename(file, ".html").padEnd(16) + [...figures, middle("sharpness").toFixed(2)].map((x, i) => x.padStart(columns[i][1])).join(""));
  await page.context().close();
}
await browser.close();
