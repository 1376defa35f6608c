// Does the JavaScript API do what carom does? Reads dist/; checks against closed forms, carom's own messages and other runs.

import assert from "node:assert/strict";
import { readdirSync, statSync } from "node:fs";
import { test } from "node:test";
import { CaromError, createScene, MAX_GRAINS } from "../dist/carom.js";

/** @typedef {import("../page/carom.js").SceneOptions} SceneOptions */
/** @param {object} options @returns {Promise<import("../page/carom.js").Scene>} */
const scene = (options) => createScene(/** @type {SceneOptions} */ (options));
/** @param {number} x @param {number} wanted @param {number} tolerance */
const near = (x, wanted, tolerance) => assert.ok(Math.abs(x - wanted) <= tolerance, `${x}, not ${wanted}`);

const rubber = { material: "viscoelastic", young: 5e6, poisson: 0.4, dissipation: 1e-4, outside: "reject" };
const elastic = { material: "hard", restitution: 1 };

/** A lattice of grains with velocities from a fixed sequence. @param {number} n @param {number} dimension */
function lattice(n, dimension) {
  const side = Math.ceil(n ** (1 / dimension) - 1e-9);
  let seed = 7;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
  return Array.from({ length: n }, (_, i) => ({
    radius: (0.2 + 0.05 * (i % 3)) / side,
    density: 1000,
    position: Array.from({ length: dimension }, (_, a) => (Math.floor(i / side ** a) % side + 0.5) / side),
    velocity: Array.from({ length: dimension }, random),
  }));
}

test("two elastic grains swap velocities, and the next event time is known", async () => {
  const line = await scene({
    dimension: 1,
    rule: elastic,
    grains: [
      { radius: 0.5, mass: 1, position: [0], velocity: [1] },
      { radius: 0.5, mass: 1, position: [3] },
    ],
  });
  assert.equal(line.nextEventTime, 2);
  assert.equal(line.advanceTo(3), true);
  assert.deepEqual([...line.positions], [2, 4]);
  assert.deepEqual([...line.velocities], [0, 1]);
  assert.equal(line.statistics.collisions, 1);
  assert.equal(line.nextEventTime, Infinity);
  assert.equal(line.step(), false);
});

test("MP13 Fig. 6: eMD* leaves as force-based MD does, eMD 98.8 degrees away", async () => {
  const rule = { material: "linear", stiffness: 2000, damping: 0, outside: "integrate" };
  const grains = [-1, 1].map((side) => ({
    radius: 0.1,
    density: 1140,
    position: [-side * 0.03, side * 0.1 * Math.sqrt(1 - 0.09)].map((x, a) => x - 0.01 * [1.25, -side * 2.5][a]),
    velocity: [1.25, -side * 2.5],
  }));
  const angle = async (/** @type {string} */ method) => {
    const pair = await scene({ rule: { ...rule, method }, grains });
    pair.advanceTo(0.2);
    const [ax, ay, bx, by] = pair.velocities;
    return [(Math.atan2(ay - by, ax - bx) * 180) / Math.PI, pair.statistics.integrated];
  };
  const [[star, integrated], [emd]] = [await angle("emd*"), await angle("emd")];
  assert.equal(integrated, 1);
  // tests/data/fig6-path.json: the angle between the two.
  near(Math.abs(((star - emd + 540) % 360) - 180), 98.8, 0.05);
});

test("positions are views of the module's memory, not copies", async () => {
  const gas = await scene({ periodic: [[0, 1], [0, 1]], rule: rubber, grains: lattice(16, 2) });
  const { positions } = gas;
  const before = positions.slice();
  gas.advanceTo(0.01);
  assert.equal(gas.positions, positions);
  assert.notDeepEqual(positions, before);
  assert.equal(positions.length, 32);
});

test("an elastic gas keeps its energy in one, two and three dimensions", async () => {
  for (const dimension of [1, 2, 3]) {
    const grains = lattice(27, dimension);
    const gas = await scene({ dimension, periodic: Array(dimension).fill([0, 1]), rule: elastic, grains });
    const before = gas.kineticEnergy;
    gas.advanceTo(5);
    assert.ok(gas.statistics.collisions > 50);
    near(gas.kineticEnergy / before, 1, 1e-12);
  }
});

test("the digest does not depend on the number of calls, and tells two states apart", async () => {
  const options = { walls: { sides: [[0, 1], [0, 1]] }, gravity: [0, -9.81], rule: rubber, grains: lattice(30, 2) };
  const [once, often, half] = await Promise.all([scene(options), scene(options), scene(options)]);
  once.advanceTo(0.1);
  half.advanceTo(0.05);
  for (let k = 1; k <= 10; k++) while (!often.advanceTo(0.01 * k, 3));
  often.advanceTo(0.1);
  assert.match(once.digest, /^[0-9a-f]{16}$/);
  assert.equal(once.digest, often.digest);
  assert.notEqual(once.digest, half.digest);
});

test("a ball falls for sqrt(2h/g), and gravity can be turned", async () => {
  const ball = await scene({
    walls: { sides: [[0, 1], [0, 2]], restitution: 0.5 },
    gravity: [0, -9.81],
    rule: elastic,
    grains: [{ radius: 0.1, mass: 1, position: [0.5, 1.1] }],
  });
  near(ball.nextEventTime, Math.sqrt(2 / 9.81), 1e-12);
  ball.step();
  near(ball.velocities[1], 0.5 * Math.sqrt(2 * 9.81), 1e-12);
  ball.setGravity([0, 0]);
  ball.advanceTo(ball.time + 0.1);
  near(ball.positions[1], 0.1 + 0.05 * Math.sqrt(2 * 9.81), 1e-12);
});

test("a plate lifts what lies on it as soon as it falls faster than gravity", async () => {
  const ride = await scene({
    dimension: 1,
    mode: "paper",
    planes: [{ normal: [1], offset: 0, restitution: 0, vibration: { amplitude: 2e-3, frequency: 20 } }],
    gravity: [-9.81],
    rule: { material: "hard", restitution: 0 },
    grains: [{ radius: 0.5e-3, mass: 1, position: [0.5e-3] }],
  });
  const omega = 40 * Math.PI;
  const leaves = Math.asin(9.81 / (2e-3 * omega ** 2)) / omega;
  ride.advanceTo(0.999 * leaves);
  assert.equal(ride.states[0], 2);
  ride.advanceTo(1.001 * leaves);
  assert.equal(ride.states[0], 0);
  assert.equal(ride.statistics.takeOffs, 1);
});

test("a column of ten beads that crosses cells never falls through its plate", async () => {
  const [d, g, frequency] = [1e-3, 9.81, 20];
  const amplitude = (2 * g) / (2 * Math.PI * frequency) ** 2;
  const column = await scene({
    dimension: 1,
    mode: "paper",
    planes: [{ normal: [1], offset: 0, restitution: 0.7, vibration: { amplitude, frequency } }],
    gravity: [-g],
    rule: { material: "hard", restitution: 0.6 },
    grains: Array.from({ length: 10 }, (_, i) => ({ radius: d / 2, mass: 1, position: [1.001 * (i + 0.5) * d] })),
  });
  for (let k = 1; k <= 500; k++) {
    column.advanceTo(k / 1000);
    const gap = column.positions[0] - d / 2 - amplitude * Math.sin(2 * Math.PI * frequency * column.time);
    assert.ok(gap > -1e-15, `${gap} at ${column.time}`);
  }
});

test("errors are thrown with carom's own messages, and nothing traps", async () => {
  const grain = { radius: 0.1, mass: 1, position: [0.5, 0.5] };
  /** @param {object} more @param {RegExp} message */
  const refused = (more, message) =>
    assert.rejects(scene({ rule: elastic, grains: [grain], ...more }), (error) => {
      assert.ok(error instanceof CaromError);
      assert.match(error.message, message);
      return true;
    });
  await refused({ grains: [grain, grain] }, /grain 1 and grain 0 overlap: their gap is -0\.2/);
  await refused({ grains: [{ ...grain, radius: -1 }] }, /grain 0: radius is -1, must be finite and above 0/);
  await refused({ grains: [{ ...grain, mass: undefined }] }, /grain 0: mass is NaN/);
  await refused({ grains: [{ ...grain, position: [1] }] }, /grain 0: position must have 2 components/);
  await refused({ gravity: [0, NaN] }, /world: gravity is NaN/);
  await refused({ rule: { material: "hard", restitution: 2 } }, /rule: restitution is 2, must be between 0 and 1/);
  await refused({ rule: { ...rubber, young: -1 } }, /rule: young is -1, must be finite and above 0/);
  await refused({ rule: { material: "jelly" } }, /rule\.material is "jelly", must be one of hard, linear/);
  await refused({ planes: Array(9).fill({ normal: [0, 1], offset: 0 }) }, /no place left: the list of planes/);
  await refused({ periodic: [[0, 0.25], null] }, /axis 0: length is 0\.25, must be/);
  await refused({ dimension: 4 }, /dimension is 4, must be 1, 2 or 3/);
  await refused({ grains: Array(MAX_GRAINS + 1).fill(grain) }, /501 grains, must be at most 500/);
  const fine = await scene({ rule: elastic, grains: [grain] });
  fine.advanceTo(1);
  assert.throws(() => fine.advanceTo(0.5), /t = 0\.5 is in the past: it is 1 now/);
  assert.throws(() => fine.setGravity([Infinity, 0]), /gravity is inf/);
});

test("outside the table: an error, counted, or integrated, as the page chooses", async () => {
  const grains = [-1, 1].map((s) => ({ radius: 0.1, mass: 1, position: [s, 0], velocity: [-5 * s, 0] }));
  const soft = (/** @type {string} */ outside) =>
    scene({ rule: { material: "linear", stiffness: 100, damping: 0, outside }, grains });
  const rejecting = await soft("reject");
  assert.throws(() => rejecting.advanceTo(1), /outside the table's domain: e = 0/);
  for (const [outside, statistic] of [["hard-sphere", "hardSphere"], ["clamp", "clamped"]]) {
    const run = await soft(outside);
    run.advanceTo(1);
    assert.equal(/** @type {any} */ (run.statistics)[statistic], 1);
  }
});

/** Grains that fall into a heap in a box of one metre. @param {object} [more] */
const heap = (more = {}) =>
  scene({
    walls: { sides: [[0, 1], [0, 1]], restitution: 0.7 },
    gravity: [0, -9.81],
    rule: { material: "hard", restitution: 0.7 },
    stepsPerContact: 8,
    grains: lattice(40, 2),
    ...more,
  });
const many = (/** @type {import("../page/carom.js").Scene} */ { states }, /** @type {number} */ motion) => states.filter((s) => s === motion).length;

test("grains fly, are clustered, sleep, and wake when gravity turns", async () => {
  const box = await heap();
  assert.equal(many(box, 0), 40);
  box.advanceTo(1);
  assert.ok(many(box, 3) > 0, "some touch more than one other");
  box.advanceTo(30);
  assert.equal(many(box, 2), 40);
  assert.equal(box.nextEventTime, Infinity);
  assert.equal(box.kineticEnergy, 0);
  assert.ok(box.statistics.steps > 0 && box.statistics.joins >= 40);
  const { digest } = box;
  box.setGravity([4.9, -8.5]);
  assert.ok(box.nextEventTime < Infinity);
  box.advanceTo(30.5);
  assert.ok(many(box, 2) < 40);
  assert.notEqual(box.digest, digest);
});

test("rubber heaps up, too, under its own force law", async () => {
  const box = await heap({ walls: { sides: [[0, 1], [0, 1]] }, rule: { ...rubber, outside: "hard-sphere" } });
  let pairs = 0;
  for (let k = 1; k <= 20; k++) {
    box.advanceTo(0.02 * k);
    pairs += many(box, 1);
  }
  assert.ok(pairs > 0, "some are in a contact of two");
  box.advanceTo(2);
  assert.ok(many(box, 2) + many(box, 3) > 30);
});

test("how long contacts last can be chosen, within what carom takes", async () => {
  await assert.rejects(heap({ contactTime: 1 }), /contact time/);
  await assert.rejects(heap({ stepsPerContact: 7 }), /steps per contact is 7, must be between 8 and 131072/);
  await assert.rejects(heap({ mode: "fast" }), /mode is "fast", must be one of integrated, paper/);
  const [short, long] = await Promise.all([heap({ contactTime: 2e-3 }), heap({ contactTime: 2e-2 })]);
  short.advanceTo(0.6);
  long.advanceTo(0.6);
  assert.ok(short.statistics.steps > 2 * long.statistics.steps);
});

test("the modules keep to what build.sh allows, with both standard tables", () => {
  const dist = new URL("../dist/", import.meta.url);
  const kib = { "carom-line.wasm": 200, "carom-plane.wasm": 240, "carom-rough.wasm": 270, "carom-space.wasm": 210 };
  assert.deepEqual(readdirSync(dist).filter((name) => name.endsWith(".wasm")).sort(), Object.keys(kib));
  for (const [name, most] of Object.entries(kib)) {
    const { size } = statSync(new URL(name, dist));
    console.log(`${name}: ${size} bytes of ${most * 1024}`);
    assert.ok(size <= most * 1024, `${name} has ${size} bytes`);
  }
});
