// The report in headless Chromium: opens from disk, asks for nothing, no console error, a click
// names the right line, a line lights up what it cut. Usage: node test/report_test.mjs FIXTURE
// where FIXTURE is the built report_fixture.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { open } from "./browser.mjs";

const fixture = process.argv[2] ?? "../build/tests/report_fixture";
const folder = mkdtempSync(join(tmpdir(), "mrsim-report-"));
const report = join(folder, "slots.html"), large = join(folder, "large.html");
const browser = await open();
const wide = { width: 1440, height: 900 };

async function clickPlace(page, place) {
  const p = await page.evaluate((where) => {
    const { view } = window.mrsimReport, box = document.getElementById("view").getBoundingClientRect(), q = view.project(where);
    return { x: box.left + q.x, y: box.top + q.y };
  }, place);
  await page.mouse.click(p.x, p.y);
}
const settle = (page) => page.waitForTimeout(700);
const selectedLine = (page) => page.evaluate(() => Number(document.querySelector("#code .row.selected")?.dataset.line ?? 0));
const litKeys = (page) => page.evaluate(() => {
  const { view, data } = window.mrsimReport;
  return data.keys.map((k, i) => [k.line, view.texels[4 * i + 3]]).filter(([, a]) => a === 255).map(([l]) => l);
});

// Cases by the page that they share, each on what the one before has left: a page takes seconds of a core to open.
const pages = [
  {
    async "a click on the surface shows its line"(page) {
      await page.click("[data-view=top]");
      await settle(page);
      for (let slot = 0; slot < 6; ++slot) {
        if (slot === 4) continue; // was never cut
        await clickPlace(page, [60, 14 * slot + 10, slot === 1 ? 5.9 : 6]);
        assert.equal(await selectedLine(page), 10 * (slot + 1));
        assert.deepEqual(await litKeys(page), [10 * (slot + 1)]);
      }
      await clickPlace(page, [60, 24, 5.9]);
      assert.match(await page.textContent("#picked"), /\u22120\.1000 mm/);
      await clickPlace(page, [5, 45, 10]);
      assert.match(await page.textContent("#picked"), /stock/);
    },
    async "a click on a line lights up what it cut"(page) {
      await page.click("#tab-program");
      await page.click("#code .row[data-line='20']");
      assert.deepEqual(await litKeys(page), [20]);
      assert.match(await page.textContent("#picked"), /out of tolerance/);
      await page.focus("#code");
      await page.keyboard.press("ArrowDown");
      assert.deepEqual(await litKeys(page), [30]);
    },
    async "regions fly the camera and name the line"(page) {
      await page.click("#tab-regions");
      const before = await page.evaluate(() => window.mrsimReport.view.camera.position.toArray());
      await page.click("#panel-regions tbody tr:nth-child(2)");
      await settle(page);
      assert.notDeepEqual(await page.evaluate(() => window.mrsimReport.view.camera.position.toArray()), before);
      assert.equal(await selectedLine(page), 20);
      assert.match(await page.textContent("#picked"), /N20 G1 X110 F300 ; slot 2/);
      assert.ok(await page.isVisible("#mark"));
      await page.keyboard.press("Escape");
      assert.ok(!(await page.isVisible("#picked")));
    },
  },
  {
    async "keyboard, section, schemes and themes"(page) {
      for (const [key, mode] of [["2", "line"], ["3", "tool"], ["4", "owner"], ["1", "deviation"]]) {
        await page.keyboard.press(key);
        assert.equal(await page.getAttribute(`#mode-${mode}`, "aria-checked"), "true");
      }
      await page.keyboard.press("s");
      assert.match(await page.textContent("#section-out"), /^X 60\.00 mm$/);
      await page.keyboard.press("s");
      await page.keyboard.press("n");
      assert.ok(await page.isChecked("#nominal"));
      await page.keyboard.press("n");
      await page.check("#safe");
      const theme = await page.getAttribute("html", "data-theme");
      await page.keyboard.press("t");
      assert.notEqual(await page.getAttribute("html", "data-theme"), theme);
      await page.focus("#view");
      await page.keyboard.press("ArrowLeft");
      await page.keyboard.press("+");
    },
    async "a scene that stands still is not drawn again"(page) {
      await settle(page);
      await page.evaluate(() => { const { view } = window.mrsimReport, draw = view.drawNow; window.drawn = 0; view.drawNow = function () { ++window.drawn; draw.call(this); }; });
      const drawn = () => page.evaluate(() => window.drawn);
      await page.waitForTimeout(500);
      assert.equal(await drawn(), 0);
      await page.focus("#view");
      await page.keyboard.press("ArrowLeft");
      await page.waitForTimeout(300);
      assert.equal(await drawn(), 1);
    },
    async "nothing of the program is run"(page) {
      assert.equal(await page.evaluate(() => window.evil), undefined);
      await page.click("#tab-program");
      assert.ok((await page.textContent("#code")).includes("</script><script>window.evil = true</script>"));
      await page.click("#tab-run");
      assert.match(await page.textContent("#panel-run"), /<b>check<\/b>/);
      assert.match(await page.textContent("#panel-run"), /endmill \u00d86/);
    },
  },
  {
    async "collisions come first"(page) {
      assert.match(await page.textContent("#crashes"), /2 collisions.*shank of T4, 2\.500 mm deep, in a rapid/);
      assert.equal(await page.getAttribute("#tab-collisions", "aria-selected"), "true");
      assert.equal(await page.locator(".crash:visible").count(), 2);
      // Of markers at one place the worst is on top.
      const [first, second] = await page.$$eval(".crash", (marks) => marks.map((m) => Number(getComputedStyle(m).zIndex)));
      assert.ok(first > second);
      assert.match(await page.textContent("#panel-collisions tbody"), /2\.500shank of T4, rapid1\u202f234 mm\u00b3 \u00b7 SLOTS\.MPF:31 \u00b7 at 1:23\.4, motion 17/);
      await page.click("#panel-collisions tbody tr:nth-child(2)");
      await settle(page);
      assert.match(await page.textContent("#picked"), /Collision 2 the cutter of T4, 0\.250 mm deep/);
      await page.click("#crashes");
      await settle(page);
      assert.match(await page.textContent("#picked"), /N31 G0 X115 Y85 <i>Z30<\/i>/);
      assert.equal(await selectedLine(page), 31);
      await page.click("#tab-program");
      await page.click("#code .row[data-line='45']");
      await page.waitForFunction(() => /Collision 2/.test(document.querySelector("#picked").textContent));
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
  execFileSync(fixture, [report]);
  for (const cases of pages) {
    const page = await browser.page(report, wide);
    for (const [name, body] of Object.entries(cases)) await check(name, () => body(page));
    await page.context().close();
  }
  await check("a phone's width needs no sideways scrolling", async () => {
    const page = await browser.page(report, { width: 390, height: 844 }, "dark");
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
    assert.equal(await page.getAttribute("html", "data-theme"), "dark");
    await page.context().close();
  });
  await check("a million triangles open and can be picked", async () => {
    execFileSync(fixture, [large, "1000000"]);
    const begin = Date.now(), page = await browser.page(large, wide);
    const opened = Date.now() - begin;
    const times = await page.evaluate(async () => {
      const gl = window.mrsimReport.view.renderer.getContext(), pixel = new Uint8Array(4);
      const { view } = window.mrsimReport, out = { triangles: view.part.index.length / 3 };
      let t = performance.now();
      const hit = view.pick(view.canvas.clientWidth / 2, view.canvas.clientHeight / 2);
      out.pick = performance.now() - t;
      out.deviation = hit.deviation;
      // A line for each 10 mm of height: which one is right is known, but near the borders.
      out.picked = out.wrong = 0;
      for (let y = 0.2; y < 0.81; y += 0.06) {
        const at = view.pick(view.canvas.clientWidth / 2, view.canvas.clientHeight * y);
        const band = (at.place[2] + 55) / 10;
        if (Math.abs(band - Math.round(band)) < 0.08) continue;
        ++out.picked;
        out.wrong += window.mrsimReport.data.keys[view.part.owner[at.face]].line !== 10 * (Math.floor(band) + 1);
      }
      t = performance.now();
      for (let i = 0; i < 5; ++i) { view.turn(0.1, 0); view.renderer.render(view.scene, view.camera); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); }
      out.frame = (performance.now() - t) / 5;
      return out;
    });
    console.log(`        opened in ${opened} ms, ${JSON.stringify(times)} (software rendering)`);
    assert.ok(times.triangles <= 200000);
    assert.ok(times.picked >= 5);
    assert.equal(times.wrong, 0);
    assert.ok(Math.abs(times.deviation) < 0.05);
    await page.context().close();
  });
  await check("no console error, no request", async () => assert.deepEqual(browser.problems, []));
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
process.exit(failed ? 1 : 0);
