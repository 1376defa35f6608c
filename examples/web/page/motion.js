// How does each grain of a scene move? Reads its states; writes colours, a legend and how many there are of each.

import { find, setText } from "./controls.js";
import { colour, scale } from "./drawing.js";

/** The states of a scene by their numbers: as a colour of the theme, and as one says it. */
const MOTIONS = /** @type {const} */ ([
  ["flight", "flying"], ["contact", "in pairs"], ["rest", "asleep"], ["cluster", "in clusters"],
]);

/** This speed has the warmest colour: a fall of 4 m. */
const FAST = 9;

/** The colour of each grain: by how it moves, or how fast. @param {string} by @param {import("./carom.js").Scene} scene */
export function colouring(by, { states, velocities }) {
  if (by === "motion") {
    const inks = MOTIONS.map(([name]) => colour(name));
    return (/** @type {number} */ i) => inks[states[i]];
  }
  return (/** @type {number} */ i) => scale(Math.sqrt(Math.hypot(velocities[2 * i], velocities[2 * i + 1]) / FAST));
}

/** Shows what colours mean. @param {string} experiment @param {string} by */
export function legend(experiment, by) {
  find(`${experiment}-motions`).classList.toggle("coloured", by === "motion");
  find(`${experiment}-speeds`).hidden = by === "motion";
}

/** Shows how many grains move in each way; returns it as a sentence. @param {string} experiment @param {import("./carom.js").Scene} scene */
export function count(experiment, { states }) {
  const many = MOTIONS.map(() => 0);
  for (const state of states) many[state] += 1;
  MOTIONS.forEach(([name], k) => setText(`${experiment}-${name}`, String(many[k])));
  return MOTIONS.map(([, words], k) => `${many[k]} ${words}`).join(", ");
}
