// How does the page look? Opens each experiment on a desk and a phone, light and dark; writes screenshots/.

import { mkdirSync } from "node:fs";
import { launch, serve } from "./browser.js";

const SCREENS = /** @type {const} */ ({
  desk: { viewport: { width: 1280, height: 900 } },
  phone: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true },
});
const folder = new URL("../screenshots/", import.meta.url).pathname;
mkdirSync(folder, { recursive: true });
const only = process.argv.slice(2);
const [server, browser] = [await serve(), await launch()];
for (const [screen, options] of Object.entries(SCREENS)) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    for (const [experiment, wait] of /** @type {[string, number][]} */ ([["pair", 3300], ["tilt", 900], ["tilt-later", 4000], ["tilt-asleep", 40000], ["hourglass", 2500], ["hourglass-later", 15000], ["column", 9000]])) {
      const name = `${experiment}-${screen}-${colorScheme}`;
      if (only.length && !only.some((part) => name.includes(part))) continue;
      const page = await browser.newPage({ ...options, colorScheme });
      page.on("console", (message) => console.log(`${name}: ${message.text()}`));
      page.on("pageerror", (error) => console.log(`${name}: ${error}`));
      await page.goto(`${server.url}#${experiment.split("-")[0]}`);
      await page.waitForTimeout(wait);
      await page.screenshot({ path: `${folder}${name}.png`, fullPage: screen === "phone" });
      await page.close();
    }
  }
}
await browser.close();
server.close();
