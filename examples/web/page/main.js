// Which of the four experiments is on the screen? Reads tabs, theme and time; writes a frame of the chosen one, again and again.

import { find } from "./controls.js";
import { readColours } from "./drawing.js";
import * as pair from "./pair.js";
import * as tilt from "./tilt.js";
import * as hourglass from "./hourglass.js";
import * as column from "./column.js";

/** @type {Record<string, { start(): Promise<void>, frame(dt: number): void }>} */
const experiments = { pair, tilt, hourglass, column };
const names = Object.keys(experiments);
/** Experiments that were opened once. @type {Map<string, Promise<void>>} */
const started = new Map();
/** Whose tab is open; and what is drawn: the same, as soon as it has started. */
let chosen = "", shown = "";

/** How long the last frames took to compute and draw, and how far apart they were, in milliseconds. */
const frames = { work: /** @type {number[]} */ ([]), apart: /** @type {number[]} */ ([]) };
Object.assign(globalThis, { caromFrames: frames });

/** @param {string} name @param {boolean} [focus] */
async function open(name, focus = false) {
  if (!experiments[name]) name = names[0];
  chosen = name;
  shown = "";
  for (const other of names) {
    const tab = find(`tab-${other}`);
    tab.setAttribute("aria-selected", String(other === name));
    tab.tabIndex = other === name ? 0 : -1;
    find(`panel-${other}`).hidden = other !== name;
  }
  if (focus) find(`tab-${name}`).focus();
  history.replaceState(null, "", `#${name}`);
  frames.work.length = frames.apart.length = 0;
  try {
    const start = started.get(name) ?? experiments[name].start();
    started.set(name, start);
    await start;
    // Another tab may have been opened meanwhile, and what is hidden has no size to be drawn in.
    if (chosen === name) shown = name;
  } catch (error) {
    started.delete(name);
    showError(error);
  }
}

/** @param {unknown} error */
function showError(error) {
  find("error").hidden = false;
  find("error").textContent = `Something went wrong: ${error instanceof Error ? error.message : error}`;
  console.error(error);
}

for (const [k, name] of names.entries()) {
  const tab = find(`tab-${name}`);
  tab.addEventListener("click", () => open(name));
  tab.addEventListener("keydown", (event) => {
    const places = { ArrowRight: k + 1, ArrowLeft: k - 1 + names.length, Home: 0, End: names.length - 1 };
    const place = places[/** @type {keyof typeof places} */ (event.key)];
    if (place === undefined) return;
    event.preventDefault();
    open(names[place % names.length], true);
  });
}
addEventListener("hashchange", () => location.hash.slice(1) !== chosen && open(location.hash.slice(1)));

const dark = matchMedia("(prefers-color-scheme: dark)");
const theme = find("theme");
/** @param {boolean} isDark */
function paint(isDark) {
  document.documentElement.dataset.theme = isDark ? "dark" : "light";
  theme.textContent = isDark ? "Light" : "Dark";
  readColours();
}
theme.addEventListener("click", () => paint(document.documentElement.dataset.theme !== "dark"));
dark.addEventListener("change", () => paint(dark.matches));
paint(dark.matches);

let last = performance.now();
/** @param {number} now */
function frame(now) {
  requestAnimationFrame(frame);
  const apart = now - last;
  last = now;
  if (!shown) return;
  const start = performance.now();
  try {
    experiments[shown].frame(Math.min(apart, 50) / 1000);
  } catch (error) {
    shown = "";
    showError(error);
  }
  frames.work.push(performance.now() - start);
  frames.apart.push(apart);
  if (frames.work.length > 3600) for (const list of [frames.work, frames.apart]) list.shift();
}
open(location.hash.slice(1) || names[0]);
requestAnimationFrame(frame);
