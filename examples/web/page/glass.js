// What is in the hourglass? Reads how many grains and their friction; returns the scene, and how steep the heap is.

/** Gravity (m/s²). */
export const G = 9.81;
/** Half of the glass: its width, its height, where the bulbs narrow, half of the neck's opening (m). */
export const WIDE = 0.95, HIGH = 1.9, SHOULDER = 1, NECK = 0.16;
/** The most grains that it is filled with. */
export const MOST = 300;
const RADIUS = 0.034;

/** The corners of the glass from the lower left on, anticlockwise. */
export const CORNERS = [
  [-WIDE, -HIGH], [WIDE, -HIGH], [WIDE, -SHOULDER], [NECK, 0], [WIDE, SHOULDER],
  [WIDE, HIGH], [-WIDE, HIGH], [-WIDE, SHOULDER], [-NECK, 0], [-WIDE, -SHOULDER],
];

/** @type {(seed: number) => () => number} */
const random = (seed) => () => (seed = (seed * 16807) % 2147483647) / 2147483647;

/** Grains of three sizes in loose rows from below the lid down. @param {number} n */
function grains(n) {
  const next = random(20);
  const cell = 2.45 * RADIUS;
  /** @type {import("./carom.js").Grain[]} */
  const all = [];
  for (let y = HIGH - 0.6 * cell; y > 0; y -= cell) {
    // Half of the room at this height, less what a grain needs along a slanted side.
    const slant = NECK + ((WIDE - NECK) * Math.min(y, SHOULDER)) / SHOULDER;
    const room = slant - 1.8 * RADIUS;
    const row = Math.floor((2 * room) / cell);
    for (let k = 0; k < row && all.length < n; k++) {
      const position = [(k - (row - 1) / 2) * cell, y];
      all.push({ radius: RADIUS * [0.85, 1, 1.15][Math.floor(3 * next())], density: 2500, position, velocity: [next() - 0.5, 0] });
    }
  }
  return all;
}

/** An hourglass whose sand is above. @param {number} n @param {number} mu @returns {import("./carom.js").SceneOptions} */
export const hourglass = (n, mu) => ({
  gravity: [0, -G],
  stepsPerContact: 8,
  obstacles: [{ points: CORNERS, closed: true }],
  friction: { mu, beta0: 0 },
  rule: { material: "hard", restitution: 0.5 },
  grains: grains(n),
});

/** How steep the heap below is: the slope of a line through its highest grains in each part of the width, over the distance from the middle. @param {import("./carom.js").Scene} scene @param {number} [up] -1 where the glass is upside down */
export function steepness({ count, positions }, up = 1) {
  const parts = 20;
  /** @type {number[][]} */
  const tops = Array.from({ length: parts }, () => []);
  for (let i = 0; i < count; i++) {
    const [x, y] = [positions[2 * i], up * positions[2 * i + 1]];
    const part = tops[Math.floor(((x + WIDE) / (2 * WIDE)) * parts)];
    if (part && y < -0.1 && (part.length === 0 || y > part[1])) part.splice(0, 2, Math.abs(x), y);
  }
  const points = tops.filter((top) => top.length > 0);
  if (points.length < 3) return 0;
  const mean = [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / points.length);
  const sum = (/** @type {number} */ a, /** @type {number} */ b) =>
    points.reduce((all, point) => all + (point[a] - mean[a]) * (point[b] - mean[b]), 0);
  return -sum(0, 1) / sum(0, 0);
}
