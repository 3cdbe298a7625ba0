// Playing a run in headless Chromium: node test/play_test.mjs MRSIM, the built program. The surface
// of a moment is what the program counted, the end is the exact mesh, and everything can be reached
// by keyboard and at the width of a phone.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { open } from "./browser.mjs";

const mrsim = process.argv[2] ?? "../build/bin/mrsim";
const data = join(dirname(fileURLToPath(import.meta.url)), "../../data");
const folder = mkdtempSync(join(tmpdir(), "mrsim-play-"));
const browser = await open();
const wide = { width: 1440, height: 900 };

function report(name, program, ...options) {
  const out = join(folder, `${name}.html`);
  execFileSync(mrsim, [program, ...options, "-q", "--report", out]);
  return out;
}
// Zigzag over a block in two depths, a rapid through what stands, a hostile comment.
function pocket() {
  const lines = ["G21 G90 G17", "T1 M6 ; <b>tool</b>", "S3000 M3", "G0 X10 Y10 Z5"];
  for (const z of [-2, -4]) {
    lines.push(`G1 Z${z} F200`);
    for (let k = 0; k < 11; ++k) lines.push(`G1 X${k % 2 ? 10 : 60} Y${10 + 3 * k} F800`, `G1 Y${13 + 3 * k}`);
    lines.push("G0 Z5", "G0 X10 Y10");
  }
  lines.push("G0 X70 Y45 Z-1", "G0 Z5", "G1 X40 Y20 F500", "M30 ; </script><script>window.evil = true</script>");
  const path = join(folder, "pocket.nc");
  writeFileSync(path, `${lines.join("\n")}\n`);
  return report("pocket", path, "--stock", "box:0,0,-12,80,55,0", "--tool", "1=endmill:d=6");
}

const state = (page) => page.evaluate(() => { const { timeline, play, played, view } = window.mrsimReport; return { at: timeline.at, end: play.end, seen: played.onShow.mesh.faces, whole: played.onShow === played.fine, sharpness: view.sharpness, part: view.mesh.visible, surface: played.surface.visible, playing: timeline.playing }; });
const goTo = (page, share) => page.evaluate((s) => { const { timeline, play } = window.mrsimReport; timeline.go(play.atSeconds(s * play.total)); }, share);

// In the page: what the surface of a moment, given as a share of all, encloses, mm^3. Level 0 has the
// voxels of the run, each further one those of twice the edge.
function volumeOf([level, share]) {
  const { played, play } = window.mrsimReport, { mesh } = [played.fine, ...played.coarse][level];
  mesh.widen = () => {}; // which lets quads overlap
  mesh.moment = -1;
  mesh.show(Math.round(share * play.moments));
  const p = mesh.position;
  let six = 0;
  for (let q = 0; q < mesh.quads; ++q)
    for (const [b, c] of [[3, 6], [6, 9]]) {
      const a = 12 * q, i = a + b, j = a + c;
      six += p[a] * (p[i + 1] * p[j + 2] - p[i + 2] * p[j + 1]) + p[a + 1] * (p[i + 2] * p[j] - p[i] * p[j + 2]) + p[a + 2] * (p[i] * p[j + 1] - p[i + 1] * p[j]);
    }
  return six / 6;
}

async function countsFaces(page) {
  const { checks, counts } = await page.evaluate(() => {
    const { data, played } = window.mrsimReport, counts = data.play.checks.map(([moment]) => { played.fine.mesh.show(moment); return played.fine.mesh.faces; });
    return { checks: data.play.checks, counts };
  });
  assert.equal(checks.length, 5);
  assert.deepEqual(counts, checks.map(([, count]) => count));
  assert.ok(new Set(counts).size > 1);
}

// Cases by the page that they share, each on what the one before has left: a page takes seconds of a core to open.
const pages = [
  {
    async "opens at the end with the exact mesh"(page) {
      const s = await state(page);
      assert.equal(s.at, s.end);
      assert.ok(s.part && !s.surface);
      await goTo(page, 0.5);
      const half = await state(page);
      assert.ok(!half.part && half.surface && half.seen > 0);
      await page.keyboard.press("End");
      assert.ok((await state(page)).part);
    },
    async "everything on the time line has a name"(page) {
      const names = await page.evaluate(() => [...document.querySelectorAll("#timeline button, #timeline input, #timeline select, #timeline canvas")].map((n) => n.getAttribute("aria-label")));
      assert.ok(names.length >= 8);
      assert.ok(names.every(Boolean));
    },
    async "the load of a slot is its width times its depth"(page) {
      const { load, legend } = await page.evaluate(() => {
        const { play, timeline } = window.mrsimReport, { motions, total } = play, { load } = timeline.curves.run, i = motions.line.lastIndexOf(6);
        return { load: load[Math.floor(((motions.begin[i] + 0.5 * motions.seconds[i]) / total) * load.length)], legend: document.getElementById("curve-legend").textContent };
      });
      // 6 mm wide and 2 mm deep; the half disc that the plunge took is the one more where it stops.
      assert.ok(Math.abs(load - 12) < 0.05, `${load}`);
      assert.match(legend, /removal.*load, at most .* mm\u00b2.*feed/);
    },
    async "a line that is chosen at the end is framed, with its tool"(page) {
      await page.click("#tab-program");
      await page.click("#code .row[data-line='8']");
      assert.ok(await page.isVisible("#frame"));
      assert.ok(await page.evaluate(() => window.mrsimReport.view.overlay.visible && window.mrsimReport.played.tools.some((t) => t.visible)));
      await page.keyboard.press("g");
      const s = await state(page);
      assert.ok(s.at < s.end && s.surface);
      await page.keyboard.press("End");
      await page.keyboard.press("Escape");
      assert.ok(!(await page.isVisible("#frame")));
    },
    async "without perspective equal lengths look equal"(page) {
      const lengths = () => page.evaluate(() => {
        const { view } = window.mrsimReport, at = (p) => view.project(p), apart = (a, b) => Math.hypot(at(a).x - at(b).x, at(a).y - at(b).y);
        return [apart([0, 0, 0], [80, 0, 0]), apart([0, 55, 0], [80, 55, 0])];
      });
      const [near, far] = await lengths();
      assert.ok(near / far > 1.02);
      await page.keyboard.press("o");
      await page.waitForTimeout(300);
      const [a, b] = await lengths();
      assert.ok(Math.abs(a / b - 1) < 0.003, `${a} and ${b}`);
      assert.ok(Math.abs(a / near - 1) < 0.2);
    },
    async "nothing of the program is run"(page) {
      assert.equal(await page.evaluate(() => window.evil), undefined);
      await page.click("#tab-program");
      await page.evaluate(() => { document.getElementById("code").scrollTop = 1e6; });
      await page.waitForTimeout(100);
      assert.ok((await page.textContent("#code")).includes("</script><script>window.evil = true</script>"));
    },
  },
  {
    async "keys play, step and go to both ends"(page) {
      await page.keyboard.press("Home");
      assert.equal((await state(page)).at, 0);
      let last = 0;
      for (let k = 0; k < 6; ++k) {
        await page.keyboard.press(".");
        const { at } = await state(page);
        assert.ok(at > last && Number.isInteger(at));
        last = at;
      }
      await page.keyboard.press(",");
      assert.ok((await state(page)).at < last);
      await page.keyboard.press(" ");
      assert.ok((await state(page)).playing);
      await page.keyboard.press(" ");
      assert.ok(!(await state(page)).playing);
    },
    async "the slider scrubs, and the text follows"(page) {
      await page.click("#tab-program");
      await page.evaluate(() => { const now = document.getElementById("now"); now.value = 5000; now.dispatchEvent(new Event("input")); });
      const { line, shown, share } = await page.evaluate(() => {
        const { timeline, play } = window.mrsimReport;
        return { line: play.motions.line[Math.floor(timeline.at)], shown: Number(document.querySelector("#code .row.now")?.dataset.line), share: play.secondsAt(timeline.at) / play.total };
      });
      assert.equal(shown, line);
      assert.ok(Math.abs(share - 0.5) < 1e-3);
      assert.match(await page.textContent("#moment"), new RegExp(`line ${line}\\b`));
    },
    async "a click on a line shows the tool there"(page) {
      await goTo(page, 0.9);
      await page.click("#tab-program");
      await page.evaluate(() => { document.getElementById("code").scrollTop = 0; });
      await page.waitForTimeout(100);
      await page.click("#code .row[data-line='8']");
      const { place, end } = await page.evaluate(() => {
        const { played, play } = window.mrsimReport, motion = play.motions.line.lastIndexOf(8);
        return { place: played.tools.find((t) => t.visible).position.toArray(), end: [...play.motions.end.subarray(3 * motion, 3 * motion + 3)] };
      });
      place.forEach((x, k) => assert.ok(Math.abs(x - end[k]) < 1e-3));
    },
    async "plays to the end"(page) {
      await page.selectOption("#speed", "0");
      await goTo(page, 0.9);
      await page.click("#play");
      assert.ok((await state(page)).playing);
      await page.waitForFunction(() => window.mrsimReport.timeline.at >= window.mrsimReport.play.end, null, { timeout: 60000 });
      const s = await state(page);
      assert.ok(s.part && !s.playing);
    },
    "the surface of a moment is what the program counted": countsFaces,
  },
  {
    async "measures from corner to corner"(page) {
      await page.click("[data-view=top]");
      await page.waitForTimeout(700);
      await page.check("#measure");
      const box = await page.locator("#view").boundingBox();
      for (const corner of [[0.3, 0.3, 0], [79.7, 0.3, 0]]) {
        const p = await page.evaluate((c) => window.mrsimReport.view.project(c), corner);
        await page.mouse.click(box.x + p.x, box.y + p.y);
      }
      assert.match(await page.textContent("#distance"), /^80\.000 mm \u00b7 X 80\.000 Y 0\.000 Z 0\.000$/);
      await page.keyboard.press("m");
      assert.equal(await page.locator("#distance").count(), 0);
    },
    async "a click on a face goes to its line and moment"(page) {
      await goTo(page, 0.6);
      await page.click("[data-view=top]");
      await page.waitForTimeout(700);
      const found = await page.evaluate(() => {
        const { played, view, play, data } = window.mrsimReport, box = view.canvas;
        for (let y = 0.3; y < 0.7; y += 0.02)
          for (let x = 0.3; x < 0.7; x += 0.02) {
            const hit = played.pick(x * box.clientWidth, y * box.clientHeight);
            if (hit && hit.motion >= 0) return { x: x * box.clientWidth, y: y * box.clientHeight, line: play.motions.line[hit.motion], motion: hit.motion, place: hit.place, text: data.programs[0].lines.length };
          }
        return null;
      });
      assert.ok(found);
      const box = await page.locator("#view").boundingBox();
      await page.mouse.click(box.x + found.x, box.y + found.y);
      assert.equal(await page.evaluate(() => Number(document.querySelector("#code .row.selected")?.dataset.line)), found.line);
      const { at } = await state(page);
      assert.ok(at > found.motion && at <= found.motion + 1, `${at} and motion ${found.motion}`);
    },
  },
  {
    async "at the end of a line the stock is as the line leaves it"(page) {
      // The first row is cut 2 mm deep from Y7 to Y13, with a cutter of 6 mm; the next one is not yet.
      const { heights, voxel } = await page.evaluate(() => {
        const { played, play, view, timeline } = window.mrsimReport;
        view.look("top", false);
        timeline.go(play.motions.line.lastIndexOf(6) + 1);
        return { voxel: play.voxel, heights: [[35, 10], [35, 12], [35, 14.5], [35, 5.5]].map(([x, y]) => { const p = view.project([x, y, 0]); return played.pick(p.x, p.y).place[2]; }) };
      });
      [-2, -2, 0, 0].forEach((z, k) => assert.ok(Math.abs(heights[k] - z) < voxel / 100, `${heights}`));
    },
    async "a section cuts what is played"(page) {
      await goTo(page, 0.5);
      const hits = () => page.evaluate(() => {
        const { played, view } = window.mrsimReport, c = view.canvas;
        let most = -Infinity;
        for (let x = 0.05; x < 1; x += 0.05) for (let y = 0.2; y < 0.9; y += 0.05) { const hit = played.pick(x * c.clientWidth, y * c.clientHeight); if (hit) most = Math.max(most, hit.place[0]); }
        return most;
      });
      assert.ok((await hits()) > 60);
      await page.selectOption("#section-axis", "X");
      assert.ok((await hits()) <= 40.01);
    },
  },
  {
    async "the surface played to the end has the silhouette of the exact mesh"(page) {
      const far = await page.evaluate(() => {
        const { played, play, view, timeline } = window.mrsimReport, gl = view.renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
        const mask = () => {
          const bytes = new Uint8Array(4 * w * h);
          view.renderer.render(view.scene, view.camera);
          gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          return Uint8Array.from({ length: w * h }, (_, i) => (bytes[4 * i + 3] > 127 ? 1 : 0));
        };
        document.getElementById("edges").click();
        timeline.go(play.end);
        const exact = mask();
        view.showPart(false);
        played.showSurface(play.moments);
        played.surface.visible = true;
        const shown = mask();
        // Pixels that differ lie within two voxels of where the exact silhouette ends.
        const [a, b] = [[0, 0, 0], [2 * play.voxel, 0, 0]].map((p) => view.project(p)), reach = Math.ceil(Math.hypot(a.x - b.x, a.y - b.y) * (w / view.canvas.clientWidth)) + 1;
        let solid = 0, wrong = 0;
        for (let y = 0; y < h; ++y)
          for (let x = 0; x < w; ++x) {
            const i = y * w + x;
            solid += exact[i];
            if (exact[i] === shown[i]) continue;
            let border = false;
            for (let v = Math.max(0, y - reach); v <= Math.min(h - 1, y + reach) && !border; ++v) for (let u = Math.max(0, x - reach); u <= Math.min(w - 1, x + reach); ++u) border ||= exact[v * w + u] === shown[i];
            wrong += border ? 0 : 1;
          }
        return { solid, wrong, reach };
      });
      assert.ok(far.solid > 20000 && far.reach < 12, JSON.stringify(far));
      assert.equal(far.wrong, 0, JSON.stringify(far));
    },
  },
  {
    async "what moves is drawn with fewer faces where the machine is slow, and in full at rest"(page) {
      const slow = (is) => page.evaluate((ms) => { window.mrsimReport.view.pace.whole.run = ms; }, is ? 1000 : 1);
      await slow(true);
      await goTo(page, 0.5);
      const moved = await state(page);
      await page.waitForFunction(() => !window.mrsimReport.view.pace.moves && !window.mrsimReport.view.pending);
      const rested = await state(page);
      assert.ok(!moved.whole && rested.whole && rested.sharpness === 1);
      assert.ok(moved.seen < 0.4 * rested.seen && moved.seen > 0.15 * rested.seen, `${moved.seen} of ${rested.seen}`);
      await slow(false);
      await goTo(page, 0.6);
      assert.ok((await state(page)).whole);
      for (const share of [0, 0.4, 0.8, 1]) {
        const [all, ...fewer] = [await page.evaluate(volumeOf, [0, share]), await page.evaluate(volumeOf, [1, share]), await page.evaluate(volumeOf, [2, share])];
        fewer.forEach((volume, k) => assert.ok(Math.abs(volume / all - 1) < [0.002, 0.01][k], `${volume} of ${all} at ${share}, level ${k + 1}`));
      }
    },
    async "the tabulator alone reaches every control, and each has a name"(page) {
      const focus = () => page.evaluate(() => {
        const e = document.activeElement, box = e.getBoundingClientRect();
        if (e === document.body) return null;
        e.dataset.reached = "";
        return { name: (e.getAttribute("aria-label") ?? e.labels?.[0]?.textContent ?? e.textContent).trim(), left: box.left, right: box.right, ring: getComputedStyle(e).outlineStyle };
      });
      await page.setViewportSize({ width: 390, height: 844 });
      for (let k = 0; k < 200; ++k) {
        await page.keyboard.press("Tab");
        const at = await focus();
        if (!at) break;
        assert.ok(at.name && at.left >= 0 && at.right <= 390 && at.ring !== "none", JSON.stringify(at));
      }
      const missed = await page.evaluate(() => [...document.querySelectorAll("button, select, input, canvas[tabindex], [role=tab]")].filter((e) => e.offsetParent && !e.disabled && !("reached" in e.dataset)).map((e) => e.outerHTML.slice(0, 80)));
      assert.deepEqual(missed, []);
      const tree = await page.locator("body").ariaSnapshot();
      for (const name of [/button "2 collisions/, /application "The part in three dimensions/, /slider "Moment of the run"/, /checkbox "Measure"/, /combobox "Section"/]) assert.match(tree, name);
      // Space on a check box changes it, and plays nothing.
      await page.focus("#parallel");
      await page.keyboard.press(" ");
      assert.ok(await page.isChecked("#parallel"));
      assert.ok(!(await state(page)).playing);
    },
  },
];

let failed = 0;
const check = async (name, body) => {
  try {
    await body();
    console.log(`ok      ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
};

try {
  const milled = pocket();
  for (const cases of pages) {
    const page = await browser.page(milled, wide);
    for (const [name, body] of Object.entries(cases)) await check(name, () => body(page));
    await page.context().close();
  }
  await check("a turned part plays, too", async () => {
    const page = await browser.page(report("turned", join(data, "PRIMER_2S.MPF"), "--stock", join(data, "bar.stl")), wide);
    await countsFaces(page);
    assert.ok(await page.evaluate(() => window.mrsimReport.play.halfPlane));
    // The spindle's axis lies.
    const [left, right] = await page.evaluate(() => [0, 50].map((z) => window.mrsimReport.view.project([0, 0, z])));
    assert.ok(right.x - left.x > 3 * Math.abs(right.y - left.y));
    // Faces in a row share a quad, and each has its own moment.
    const moments = await page.evaluate(() => {
      const { played, play, timeline, view } = window.mrsimReport;
      timeline.go(play.end - 1e-6);
      view.look("front", false);
      return [44, 40, 36].map((z) => { const p = view.project([15, 0, z]), hit = played.pick(p.x, p.y); return { birth: play.faces.birth[hit.face], line: play.motions.line[hit.motion] }; });
    });
    assert.deepEqual(moments.map((m) => m.line), [9, 9, 9]);
    assert.ok(moments[0].birth < moments[1].birth && moments[1].birth < moments[2].birth, JSON.stringify(moments));
    // Closed and smooth: its volume at the end is that of the part within what rings of 72 corners miss.
    const volume = await page.evaluate(volumeOf, [0, 1]);
    const told = Number(/volume ([\d. ]+) mm³/.exec(await page.textContent("#totals"))[1].replaceAll(" ", ""));
    assert.ok(Math.abs(volume / told - 1) < 0.01, `${volume} and ${told}`);
    await page.context().close();
  });
  await check("a path without a stock plays, too", async () => {
    const out = join(folder, "path.html");
    execFileSync(mrsim, ["trace", join(folder, "pocket.nc"), "--tool", "1=endmill:d=6", "-q", "-o", out]);
    const page = await browser.page(out, wide);
    assert.equal(await page.textContent("#subtitle"), "Tool path");
    const visible = () => page.evaluate(() => { const { played, play } = window.mrsimReport; return { path: played.path.visible, drawn: played.path.geometry.drawRange.count, all: 2 * play.end, chosen: played.chosen.visible, tool: played.tools.some((t) => t.visible) }; });
    assert.ok((await visible()).path && (await visible()).drawn === Infinity && !(await visible()).chosen);
    // The middle of the row at Y13, upper layer.
    const line = 8, box = await page.locator("#view").boundingBox();
    await page.click("[data-view=top]");
    await page.waitForTimeout(700);
    const p = await page.evaluate(() => window.mrsimReport.view.project([35, 13, -4]));
    await page.mouse.click(box.x + p.x, box.y + p.y);
    const text = await page.textContent("#code .row.selected");
    assert.match(text, /G1 X10 Y13 F800/);
    assert.ok((await visible()).chosen && (await visible()).tool);
    await page.click(`#code .row[data-line='${line}']`);
    await page.keyboard.press("Home");
    await page.keyboard.press(".");
    await page.keyboard.press(".");
    const part = await visible();
    assert.ok(part.path && part.drawn < part.all && part.tool);
    assert.ok(!(await page.isVisible("#modes")) && !(await page.isVisible("#section")));
    await page.context().close();
  });
  await check("at the width of a phone every button is seen", async () => {
    const page = await browser.page(milled, { width: 390, height: 844 }, "dark");
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
    const boxes = await page.evaluate(() => [...document.querySelectorAll("#timeline button, #timeline select, #now, #bar button, #bar select, #bar label")].filter((n) => n.offsetParent).map((n) => { const b = n.getBoundingClientRect(); return [b.left, b.right]; }));
    for (const [left, right] of boxes) assert.ok(left >= 0 && right <= 390, `${left} .. ${right}`);
    await page.context().close();
  });
  await check("no console error, no request", async () => assert.deepEqual(browser.problems, []));
  console.log(`        ${statSync(milled).size} bytes`);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
process.exit(failed ? 1 : 0);
