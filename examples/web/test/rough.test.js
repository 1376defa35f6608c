// Do rough grains and obstacles do on the page what carom does? Reads dist/; checks closed forms, the hourglass and its heap.

import assert from "node:assert/strict";
import { test } from "node:test";
import { createScene, MAX_SEGMENTS } from "../dist/carom.js";
import { G, HIGH, MOST, NECK, SHOULDER, WIDE, hourglass, steepness } from "../dist/glass.js";

/** @typedef {import("../page/carom.js").SceneOptions} SceneOptions */
/** @typedef {import("../page/carom.js").Scene} Scene */
/** @param {object} options @returns {Promise<Scene>} */
const scene = (options) => createScene(/** @type {SceneOptions} */ (options));
const hard = { material: "hard", restitution: 0.5 };

test("a ball set down sliding rolls with 5/7 of its speed", async () => {
  const floor = { points: [[-1, 0], [9, 0]] };
  const grains = [{ radius: 0.1, mass: 1, position: [0, 0.1], velocity: [1, 0] }];
  const ball = await scene({ gravity: [0, -G], rule: hard, obstacles: [floor], friction: { mu: 0.3 }, grains });
  ball.advanceTo(1);
  assert.ok(Math.abs(ball.velocities[0] - 5 / 7) < 2e-3, `${ball.velocities[0]}`);
  assert.ok(Math.abs(ball.rotations[0] + 50 / 7) < 2e-2, `${ball.rotations[0]}`);
  const smooth = await scene({ gravity: [0, -G], rule: hard, obstacles: [floor], grains });
  smooth.advanceTo(1);
  assert.deepEqual([smooth.velocities[0], smooth.rotations[0]], [1, 0]);
});

test("what is wrong with obstacles and friction is said in carom's words", async () => {
  const grains = [{ radius: 0.1, mass: 1, position: [0, 0.1] }];
  const refused = (/** @type {object} */ more, /** @type {RegExp} */ words) => assert.rejects(scene({ rule: hard, grains, ...more }), words);
  await refused({ friction: { mu: -0.1 } }, /mu is -0.1, must be between 0 and 16/);
  await refused({ friction: { mu: 0.1, beta0: 2 } }, /beta_0 is 2, must be between -1 and 1/);
  await refused({ obstacles: [{ points: [[0, 0], [0, 0]] }] }, /facet 0.*length/);
  await refused({ obstacles: [{ points: [[0, 0], [1, NaN]] }] }, /facet 0.*corner is NaN/);
  await refused({ obstacles: [{ points: [[-1, 0.1], [1, 0.1]] }] }, /grain 0 and facet 0 overlap/);
  await refused({ obstacles: [{ points: [[0, 0], [1]] }] }, /obstacle 0: a point must have 2 components/);
  await refused({ dimension: 3, friction: { mu: 0.1 } }, /dimension is 3, must be 2 where/);
  const points = Array.from({ length: MAX_SEGMENTS + 2 }, (_, k) => [k, -1]);
  await refused({ obstacles: [{ points }] }, /obstacles have 101 segments, must be at most 100/);
});

test("smooth grains have no rotation, and another module", async () => {
  const bare = await scene({ rule: hard, grains: [{ radius: 0.1, mass: 1, position: [0, 0] }] });
  assert.equal(bare.rotations.length, 0);
});

/** Whether all grains are in the glass. @param {Scene} glass */
const isWhole = ({ count, positions, radii }) => {
  const slope = (WIDE - NECK) / SHOULDER;
  return Array.from({ length: count }, (_, i) => {
    const [x, y] = [positions[2 * i], Math.abs(positions[2 * i + 1])];
    const room = Math.min(WIDE, NECK + slope * y);
    // At rest the lowest are pressed in a little.
    return Math.abs(x) < room && y + 0.9 * radii[i] < HIGH;
  }).every(Boolean);
};
const below = (/** @type {Scene} */ { count, positions }) => Array.from({ length: count }, (_, i) => i).filter((i) => positions[2 * i + 1] < 0).length;

/** The glass when all lie still. @param {number} mu */
async function settled(mu) {
  const glass = await createScene(hourglass(MOST, mu));
  assert.equal(glass.count, MOST);
  const begin = performance.now();
  let time = 0;
  while (time < 60 && (time < 2 || glass.states.some((state) => state !== 2))) glass.advanceTo((time += 0.5));
  const took = (performance.now() - begin) / 1000;
  const angle = (Math.atan(steepness(glass)) * 180) / Math.PI;
  console.log(`hourglass, μ = ${mu}: ${below(glass)} of ${MOST} below after ${time} s, computed in ${took.toFixed(1)} s; the heap's slope is ${angle.toFixed(1)}°`);
  assert.ok(isWhole(glass));
  return { glass, angle };
}

test("300 grains run down; with friction their heap is steeper; turned over they run back", { timeout: 600_000 }, async () => {
  const [smooth, rough] = [await settled(0), await settled(0.5)];
  assert.equal(below(smooth.glass), MOST);
  assert.ok(below(rough.glass) > 0.9 * MOST);
  assert.ok(rough.angle > smooth.angle + 5, `${rough.angle}°, ${smooth.angle}°`);
  for (let k = 1; k <= 48; k++) {
    const angle = (Math.PI * k) / 48;
    smooth.glass.setGravity([-G * Math.sin(angle), -G * Math.cos(angle)]);
    smooth.glass.advanceTo(smooth.glass.time + 1 / 60);
  }
  smooth.glass.advanceTo(smooth.glass.time + 8);
  assert.ok(isWhole(smooth.glass));
  assert.ok(below(smooth.glass) < 0.1 * MOST, `${below(smooth.glass)}`);
});
