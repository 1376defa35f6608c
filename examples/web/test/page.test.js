// Does the page work? Opens dist/ in Chromium; checks that all controls work, by mouse, keyboard and touch, without an error.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, serve } from "./browser.js";

/** @type {Awaited<ReturnType<typeof serve>>} */ let server;
/** @type {import("playwright-core").Browser} */ let browser;
before(async () => {
  server = await serve();
  browser = await launch();
});
after(async () => {
  await browser.close();
  server.close();
});

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** Opens an experiment, does something, and sees that there was no message, and nothing left the page's own folder. */
async function visit(/** @type {string} */ experiment, /** @type {object} */ options, /** @type {(page: import("playwright-core").Page) => Promise<void>} */ action) {
  const page = await browser.newPage(options);
  /** @type {string[]} */
  const messages = [];
  page.on("console", (message) => message.type() !== "log" && messages.push(message.text()));
  page.on("pageerror", (error) => messages.push(String(error)));
  page.on("request", (request) => request.url().startsWith(server.url) || request.url().startsWith("data:") || messages.push(request.url()));
  await page.goto(`${server.url}#${experiment}`);
  await page.waitForFunction(() => /** @type {any} */ (globalThis).caromFrames?.work.length > 3);
  await action(page);
  const error = page.locator("#error");
  assert.equal((await error.isVisible()) ? await error.textContent() : "", "");
  assert.deepEqual(messages, []);
  await page.close();
}

/** @typedef {import("playwright-core").Page} Page */
const text = (/** @type {Page} */ page, /** @type {string} */ id) => page.locator(`#${id}`).textContent();

/** Does something until what is shown has changed. @param {Page} page @param {string[]} ids @param {() => Promise<unknown>} action */
async function changes(page, ids, action) {
  const old = await Promise.all(ids.map((id) => text(page, id)));
  await action();
  await page.waitForFunction(
    ([ids, old]) => ids.some((id, i) => document.getElementById(/** @type {string} */ (id))?.textContent !== old[i]),
    [ids, old],
    { timeout: 20_000 },
  );
}

/** Where the middle of what is drawn lies in a canvas: from 0, the top left corner, to 1. @param {Page} page @param {string} id */
const middle = (page, id) =>
  page.evaluate((id) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    copy?.drawImage(canvas, 0, 0);
    const data = copy?.getImageData(0, 0, width, height).data ?? [];
    let [n, x, y] = [0, 0, 0];
    for (let k = 0; k < width * height; k += 7) if (data[4 * k + 3]) [n, x, y] = [n + 1, x + (k % width), y + Math.floor(k / width)];
    return { x: x / n / width, y: y / n / height };
  }, id);

/** Where an element is, brought onto the screen. @param {Page} page @param {string} id */
async function place(page, id) {
  await page.locator(`#${id}`).evaluate((element) => element.scrollIntoView({ block: "start" }));
  const box = await page.locator(`#${id}`).boundingBox();
  assert.ok(box);
  return box;
}

/** Waits until the grains are where they should be. @param {Page} page @param {(at: { x: number, y: number }) => boolean} there */
async function settles(page, there) {
  for (let k = 0; k < 100; k++) {
    if (there(await middle(page, "tilt-canvas"))) return;
    await page.waitForTimeout(100);
  }
  assert.fail(`the grains are at ${JSON.stringify(await middle(page, "tilt-canvas"))}`);
}

test("tabs and theme: mouse, arrow keys, address", () =>
  visit("pair", { colorScheme: "light" }, async (page) => {
    await page.locator("#tab-pair").focus();
    for (const [key, experiment] of [["ArrowRight", "tilt"], ["ArrowRight", "hourglass"], ["End", "column"], ["ArrowRight", "pair"], ["ArrowLeft", "column"]]) {
      await page.keyboard.press(key);
      assert.equal(await page.locator(`#panel-${experiment}`).isVisible(), true);
      assert.equal(await page.locator("[role=tabpanel]:visible").count(), 1);
      assert.match(page.url(), new RegExp(`#${experiment}$`));
    }
    await page.click("#tab-tilt");
    assert.equal(await page.locator("#tab-tilt").getAttribute("aria-selected"), "true");
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await paper();
    await page.click("#theme");
    assert.notEqual(await paper(), light);
  }));

test("an experiment that loads slowly is not drawn once another tab is open", () =>
  visit("pair", {}, async (page) => {
    let loaded = () => {};
    const slow = new Promise((ready) => (loaded = () => ready(null)));
    await page.route("**/carom-line.wasm", (route) => slow.then(() => route.continue()));
    const asked = page.waitForRequest("**/carom-line.wasm");
    const came = page.waitForResponse("**/carom-line.wasm");
    await page.click("#tab-column");
    await asked;
    await page.click("#tab-pair");
    loaded();
    await (await came).finished();
    await page.waitForTimeout(500);
    const said = page.locator("output[for=pair-time]");
    const old = await said.textContent();
    await page.waitForTimeout(500);
    assert.notEqual(await said.textContent(), old);
  }));

test("everything has a name that can be read out, and all that can be used can be reached by key", () =>
  visit("pair", {}, async (page) => {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll("input, button, canvas")]
        .filter((e) => !(e.ariaLabel || e.textContent?.trim() || /** @type {HTMLInputElement} */ (e).labels?.length))
        .map((e) => e.id));
    assert.deepEqual(nameless, []);
    for (const experiment of ["pair", "tilt", "hourglass", "column"]) {
      await page.click(`#tab-${experiment}`);
      const wanted = page.locator(`#panel-${experiment} :is(button, input[type=range], canvas[tabindex]):visible`);
      const ids = await wanted.evaluateAll((all) => all.map((e) => e.id));
      const reached = new Set();
      for (let k = 0; k < ids.length + 6; k++) {
        await page.keyboard.press("Tab");
        reached.add(await page.evaluate(() => document.activeElement?.id));
      }
      assert.deepEqual(ids.filter((id) => !reached.has(id)), []);
    }
  }));

test("two grains: Fig. 6, sliders by key, law, time, drag", () =>
  visit("pair", {}, async (page) => {
    assert.equal(await text(page, "pair-emd-angle"), "98.8°");
    assert.equal(await text(page, "pair-star-angle"), "< 0.1°");
    assert.match((await text(page, "pair-source")) ?? "", /integrated/);
    const result = ["pair-emd-angle", "pair-tau", "pair-emd-off"];
    for (const id of ["pair-impact", "pair-stiffness"]) {
      await page.focus(`#${id}`);
      await changes(page, result, () => page.keyboard.press("ArrowRight"));
    }
    await page.focus("#pair-bounce");
    await changes(page, result, () => page.keyboard.press("PageDown"));
    await changes(page, result, () => page.check("input[value=viscoelastic]"));
    await page.fill("#pair-stiffness", "6.5");
    await page.waitForFunction(() => document.getElementById("pair-source")?.textContent === "the standard table");
    assert.ok(Number.parseFloat((await text(page, "pair-emd-angle")) ?? "") < 10, "stiff grains leave as hard ones");
    await changes(page, result, () => page.click("#pair-preset"));
    await page.waitForFunction(() => document.getElementById("pair-emd-angle")?.textContent === "98.8°");
    await page.click("#pair-play");
    assert.equal(await text(page, "pair-play"), "Play");
    await page.focus("#pair-time");
    const here = await middle(page, "pair-canvas");
    await page.fill("#pair-time", "0.15");
    await page.waitForTimeout(100);
    assert.notDeepEqual(await middle(page, "pair-canvas"), here);
    const box = await place(page, "pair-canvas");
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await changes(page, result, () => page.mouse.move(box.x + 260, box.y + 200, { steps: 4 }));
    await page.mouse.up();
  }));

/** How many pixels of a canvas have each colour by which grains are drawn that move so. @param {Page} page @param {string} id */
const inks = (page, id) =>
  page.evaluate((id) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(id));
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    copy?.drawImage(canvas, 0, 0);
    const data = copy?.getImageData(0, 0, width, height).data ?? [];
    const style = getComputedStyle(document.documentElement);
    const names = ["flight", "contact", "cluster", "rest", "paper"];
    const wanted = names.map((name) => Number.parseInt(style.getPropertyValue(`--${name}`).trim().slice(1), 16));
    const found = names.map(() => 0);
    for (let k = 0; k < data.length; k += 4) {
      const place = wanted.indexOf((data[k] << 16) | (data[k + 1] << 8) | data[k + 2]);
      if (place >= 0) found[place] += 1;
    }
    return Object.fromEntries(names.map((name, i) => [name, found[i]]));
  }, id);

/** Prints how long frames took since the last call. @param {Page} page @param {string} what */
async function tellFrames(page, what) {
  const { work, apart } = await page.evaluate(() => {
    const { work, apart } = /** @type {any} */ (globalThis).caromFrames;
    return { work: work.splice(0), apart: apart.splice(0) };
  });
  const at = (/** @type {number[]} */ all, /** @type {number} */ share) => [...all].sort((a, b) => a - b)[Math.floor(share * (all.length - 1))].toFixed(1);
  const three = (/** @type {number[]} */ all) => [0.5, 0.99, 1].map((share) => at(all, share)).join(", ");
  const said = ["tilt-time", "tilt-speed", "tilt-behind"].map((id) => text(page, id));
  const [time, speed, behind] = await Promise.all(said);
  console.log(`tilt box, ${what}: ${work.length} frames take ${three(work)} ms (median, 99 %, maximum), are ${three(apart)} ms apart; ` +
    `simulated ${time}, ${speed} of real time, ${behind} behind`);
}

test("tilt box: 500 grains fall, heap up, fall asleep, wake when tilted; colours tell", { timeout: 300_000 }, () =>
  visit("tilt", { colorScheme: "light" }, async (page) => {
    const number = async (/** @type {string} */ id) => Number((await text(page, id)) ?? "");
    const until = (/** @type {string} */ said) => page.waitForFunction(said, null, { timeout: 200_000, polling: 50 });
    const shown = (/** @type {string} */ id) => `Number(document.getElementById("${id}").textContent)`;
    const falling = await inks(page, "tilt-canvas");
    assert.ok(falling.flight > 1000 && falling.rest === 0, JSON.stringify(falling));
    await until(`${shown("tilt-cluster")} > 450`);
    await tellFrames(page, "500 hard grains fall");
    assert.ok((await inks(page, "tilt-canvas")).cluster > 1000);
    await until(`${shown("tilt-rest")} === 500`);
    const asleep = Number.parseFloat((await text(page, "tilt-time")) ?? "");
    await tellFrames(page, "they settle until all are asleep");
    assert.ok(asleep < 200, `asleep after ${asleep} s of simulated time`);
    await settles(page, ({ y }) => y > 0.65);
    await page.waitForTimeout(1500);
    await tellFrames(page, "they sleep");
    const still = await inks(page, "tilt-canvas");
    assert.ok(still.rest > 1000 && still.flight + still.cluster === 0, JSON.stringify(still));
    await page.check("input[name=tilt-colours][value=speed]");
    await page.waitForTimeout(100);
    assert.equal((await inks(page, "tilt-canvas")).rest, 0);
    assert.equal(await page.locator("#tilt-speeds").isVisible(), true);
    await page.check("input[name=tilt-colours][value=motion]");
    await page.focus("#tilt-canvas");
    for (let k = 0; k < 4; k++) await page.keyboard.press("ArrowRight");
    await until(`${shown("tilt-rest")} < 250`);
    await settles(page, ({ x }) => x > 0.55);
    await tellFrames(page, "they slide by 30 degrees");
    const names = ["flight", "contact", "cluster", "rest"];
    await page.click("#tilt-play");
    await page.waitForTimeout(100);
    const all = await Promise.all(names.map((name) => number(`tilt-${name}`)));
    assert.equal(all.reduce((sum, n) => sum + n), 500);
  }));

test("tilt box: keys, drag, buttons, sliders, rubber", () =>
  visit("tilt", {}, async (page) => {
    await settles(page, ({ y }) => y > 0.65);
    await page.focus("#tilt-canvas");
    await page.keyboard.press("ArrowUp");
    await settles(page, ({ y }) => y < 0.4);
    for (let k = 0; k < 12; k++) await page.keyboard.press("ArrowRight");
    await settles(page, ({ x, y }) => Math.abs(x - 0.5) > 0.12 && y < 0.7);
    await page.click("#tilt-down");
    await settles(page, ({ y }) => y > 0.6);
    const box = await place(page, "tilt-canvas");
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 8, box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    await settles(page, ({ x }) => x < 0.4);
    await changes(page, ["tilt-energy"], () => page.click("#tilt-toss"));
    await page.click("#tilt-none");
    await page.focus("#tilt-bounce");
    await page.keyboard.press("ArrowLeft");
    await page.focus("#tilt-count");
    await page.keyboard.press("Home");
    assert.equal(await page.locator("output[for=tilt-count]").textContent(), "N = 10");
    await changes(page, ["tilt-total"], () => page.check("input[name=tilt-material][value=rubber]"));
    await changes(page, ["tilt-total"], () => page.click("#tilt-reset"));
    await page.click("#tilt-play");
    await page.waitForFunction(() => document.getElementById("tilt-speed")?.textContent === "paused");
  }));

test("tilt box: grains with friction show how they turn", () =>
  visit("tilt", {}, async (page) => {
    // The compass is edged in the same colour.
    const smooth = (await inks(page, "tilt-canvas")).paper;
    await page.check("input[name=tilt-friction][value='0.5']");
    await page.click("#tilt-none");
    await page.waitForTimeout(500);
    assert.ok((await inks(page, "tilt-canvas")).paper > smooth + 500);
  }));

test("hourglass: sand runs down, turns over by key and button and pointer; friction, colours, marks", { timeout: 120_000 }, () =>
  visit("hourglass", { colorScheme: "light" }, async (page) => {
    const below = async () => Number(await text(page, "hourglass-below"));
    const until = (/** @type {string} */ said) => page.waitForFunction(said, null, { timeout: 100_000, polling: 50 });
    const shown = `Number(document.getElementById("hourglass-below").textContent)`;
    assert.ok((await below()) < 100);
    assert.ok((await inks(page, "hourglass-canvas")).paper > 300);
    await until(`${shown} > 240`);
    await page.focus("#hourglass-canvas");
    await page.keyboard.press("Space");
    await until(`${shown} < 100`);
    await page.click("#hourglass-turn");
    await page.check("input[name=hourglass-friction][value='0']");
    await until(`${shown} > 250`);
    assert.equal((await inks(page, "hourglass-canvas")).paper, 0);
    // A quarter turn by the pointer: sand lies along a side.
    const box = await place(page, "hourglass-canvas");
    await page.mouse.move(box.x + 0.9 * box.width, box.y + box.height / 2);
    await page.mouse.down();
    for (const angle of [15, 30, 45, 60, 75, 90]) {
      const [c, s] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
      await page.mouse.move(box.x + (0.5 + 0.4 * c) * box.width, box.y + (0.5 - 0.4 * s) * box.height);
    }
    await page.mouse.up();
    await until(`document.getElementById("hourglass-slope").textContent === "–"`);
    await page.check("input[name=hourglass-colours][value=speed]");
    assert.equal(await page.locator("#hourglass-speeds").isVisible(), true);
    await page.focus("#hourglass-count");
    await page.keyboard.press("Home");
    assert.equal(await page.locator("output[for=hourglass-count]").textContent(), "N = 50");
    await page.click("#hourglass-reset");
    await until(`${shown} === 0`);
    await page.click("#hourglass-play");
    await page.waitForFunction(() => document.getElementById("hourglass-speed")?.textContent === "paused");
  }));

test("tilt box on a phone: a finger, and the device's tilt", () =>
  visit("tilt", PHONE, async (page) => {
    const box = await place(page, "tilt-canvas");
    await page.touchscreen.tap(box.x + box.width / 2, box.y + 6);
    await settles(page, ({ y }) => y < 0.45);
    await page.tap("#tilt-device");
    // As a device does: again and again.
    await page.evaluate(() => {
      setInterval(() => dispatchEvent(new DeviceOrientationEvent("deviceorientation", { beta: 0, gamma: -80 })), 50);
    });
    await settles(page, ({ x }) => x < 0.42);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
  }));

test("shaken column: forces detach the beads, events do not; sliders and presets act", () =>
  visit("column", {}, async (page) => {
    const numbers = async () => (await Promise.all(["column-md-gaps", "column-ed-gaps"].map((id) => text(page, id)))).map((x) => Number.parseFloat(x ?? ""));
    await page.waitForTimeout(4000);
    const [md, ed] = await numbers();
    assert.ok(md > 0.5 && ed < 0.01, `gaps of ${md} d and ${ed} d`);
    const result = ["column-md-gaps", "column-ed-high"];
    for (const id of ["column-contact", "column-bounce", "column-beads", "column-shake"]) {
      await page.focus(`#${id}`);
      const said = `output[for=${id}]`;
      const old = await page.locator(said).textContent();
      await changes(page, result, () => page.keyboard.press("PageUp"));
      assert.notEqual(await page.locator(said).textContent(), old);
    }
    for (const id of ["column-short", "column-gas", "column-long"]) await changes(page, result, () => page.click(`#${id}`));
    await page.click("#column-play");
    assert.equal(await text(page, "column-play"), "Play");
  }));
