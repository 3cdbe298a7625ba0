// Screenshots for people to look at: node test/shots.mjs REPORT.html OUTDIR
import { open } from "./browser.mjs";

const [file, folder] = process.argv.slice(2);
const browser = await open();
for (const [name, width, height, scheme] of [["wide", 1440, 900, "light"], ["dark", 1440, 900, "dark"], ["phone", 390, 844, "light"]]) {
  const page = await browser.page(file, { width, height }, scheme);
  await page.screenshot({ path: `${folder}/${name}.png` });
  await page.keyboard.press("j");
  await page.waitForTimeout(1200);
  await page.screenshot({ path: `${folder}/${name}-region.png` });
  if (name === "wide") {
    await page.keyboard.press("Escape");
    await page.keyboard.press("2");
    await page.click("#tab-program");
    await page.keyboard.press("f");
    await page.waitForTimeout(900);
    await page.evaluate(() => document.querySelector('#code .row.cuts').click());
    await page.waitForTimeout(400);
    await page.screenshot({ path: `${folder}/wide-line.png` });
    await page.keyboard.press("Escape");
    await page.keyboard.press("1");
    await page.keyboard.press("n");
    await page.selectOption("#section-axis", "X");
    await page.click("#safe");
    await page.click("#tab-run");
    await page.waitForTimeout(500);
    await page.screenshot({ path: `${folder}/wide-section.png` });
  }
  if (name === "phone") await page.screenshot({ path: `${folder}/phone-full.png`, fullPage: true });
}
await browser.close();
