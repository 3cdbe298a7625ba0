// Headless Chromium without a network, software WebGL.
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";
import { chromium } from "playwright-core";

export async function open() {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  return {
    problems: [],
    async page(file, viewport, colorScheme = "light") {
      const context = await browser.newContext({ viewport, colorScheme, offline: true });
      const page = await context.newPage();
      page.on("console", (m) => { if (m.type() === "error") this.problems.push(m.text()); });
      page.on("pageerror", (e) => this.problems.push(String(e)));
      page.on("request", (r) => { if (!/^(file|data|blob):/.test(r.url())) this.problems.push(`asked for ${r.url()}`); });
      await page.goto(pathToFileURL(resolve(file)).href);
      await page.waitForFunction(() => document.documentElement.dataset.ready === "true", null, { timeout: 120000 });
      await page.waitForTimeout(600);
      return page;
    },
    /// Seconds that the processes of each type have computed.
    async cpu() {
      const session = await browser.newBrowserCDPSession(), { processInfo } = await session.send("SystemInfo.getProcessInfo"), out = {};
      for (const { type, cpuTime } of processInfo) out[type] = (out[type] ?? 0) + cpuTime;
      await session.detach();
      return out;
    },
    close: () => browser.close(),
  };
}
