// How do up to 500 grains follow gravity? Reads pointer, keys, the device's tilt and sliders; draws a box of them, 60 times a second.

import { createScene } from "./carom.js";
import { announcer, button, choice, find, player, setText, slider } from "./controls.js";
import { arrow, circle, colour, formatNumber, scale, surface } from "./drawing.js";

const G = 9.81, PLAYBACK_SPEED = 0.4, BUDGET = 9, SLICE = 128;
/** Duration of a real rubber contact, for the TC rule of hard spheres (s). */
const CONTACT = 2e-3;
/** Covered by grains: this share of the box. */
const COVERED = 0.42;

/** @type {import("./carom.js").Scene | undefined} */
let scene;
let gravity = [0, -G];
let target = 0, latestRequest = 0, tossed = 0;
/** Events and simulated time against what was due, of the last second. */
const rate = { since: 0, frames: 0, work: 0, events: 0, simulated: 0, due: 0, before: 0 };

/** @type {(seed: number) => () => number} */
const random = (seed) => () => (seed = (seed * 16807) % 2147483647) / 2147483647;

/** Grains of three sizes on a lattice. @param {number} n */
function lattice(n) {
  const next = random(20);
  const side = Math.ceil(Math.sqrt(n));
  const mean = Math.min(Math.sqrt(COVERED / (n * Math.PI)), 0.075);
  return Array.from({ length: n }, (_, i) => ({
    radius: mean * [0.8, 1, 1.2][Math.floor(3 * next())],
    density: 1100,
    position: [((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side],
    velocity: [next() - 0.5, next() - 0.5],
  }));
}

/** The grains as they are, or none if there should be others. */
function present() {
  const old = scene;
  if (!old || old.count !== controls.count.value) return null;
  return Array.from({ length: old.count }, (_, i) => ({
    radius: old.radii[i],
    density: 1100,
    position: [...old.positions.subarray(2 * i, 2 * i + 2)],
    velocity: [...old.velocities.subarray(2 * i, 2 * i + 2)],
  }));
}

/** @param {import("./carom.js").Grain[]} grains */
function build(grains) {
  const restitution = controls.bounce.value;
  const walls = { sides: /** @type {[number, number][]} */ ([[0, 1], [0, 1]]) };
  if (controls.method.value === "emd") {
    const rule = /** @type {const} */ ({ material: "hard", restitution });
    return createScene({ walls: { ...walls, restitution }, gravity, contactTime: CONTACT, rule, grains });
  }
  // Rubber balls whose ε at 1 m/s is about what the slider says.
  const rule = /** @type {const} */ ({ material: "viscoelastic", young: 2e7, poisson: 0.45, outside: "hard-sphere" });
  const dissipation = 4.4e-4 * -Math.log(restitution);
  return createScene({ walls, gravity, rule: { ...rule, dissipation }, grains });
}

async function restart(keep = true) {
  const request = ++latestRequest;
  const old = keep ? present() : null;
  let made;
  try {
    made = await build(old ?? lattice(controls.count.value));
  } catch (error) {
    // Grains in a soft contact overlap, and a world cannot start so.
    if (!old) throw error;
    made = await build(lattice(controls.count.value));
  }
  if (request !== latestRequest) return;
  scene = made;
  target = 0;
  Object.assign(rate, { since: performance.now(), frames: 0, work: 0, events: 0, simulated: 0, due: 0, before: 0 });
}

/** @param {number[]} to */
function pull(to) {
  gravity = to;
  if (scene) scene.setGravity(tossed > 0 ? to.map((g) => -2.5 * g) : to);
}

/** @param {number} radians */
function turn(radians) {
  const [c, s] = [Math.cos(radians), Math.sin(radians)];
  const size = Math.hypot(...gravity) < 0.01 ? [0, -G] : gravity;
  pull([c * size[0] - s * size[1], s * size[0] + c * size[1]]);
}

const view = surface(find("tilt-canvas"));
const canvas = find("tilt-canvas");
const announce = announcer("tilt-announcement");
const controls = {
  count: slider("tilt-count", Math.round, (n) => `N = ${n}`, () => void restart(false)),
  bounce: slider("tilt-bounce", (x) => x, (x) => `ε = ${x.toFixed(2)}`, () => void restart()),
  method: choice("tilt-method", (method) => {
    if (method === "emd*" && controls.count.value > 60) controls.count.set(60);
    void restart(false);
  }),
};
const play = player("tilt-play");
button("tilt-toss", toss);
button("tilt-down", () => pull([0, -G]));
button("tilt-none", () => pull([0, 0]));
button("tilt-reset", () => void restart(false));

function toss() {
  if (Math.hypot(...gravity) < 0.01) gravity = [0, -G];
  tossed = 0.35;
  pull(gravity);
}

/** Gravity towards the pointer: as much as it is away from the middle. @param {PointerEvent} event */
function drag(event) {
  const { width, height } = view.size;
  const { left, top } = canvas.getBoundingClientRect();
  const [x, y] = [(2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height];
  const far = Math.max(Math.hypot(x, y), 1e-6);
  const strength = far < 0.1 ? 0 : G * Math.min(far / 0.8, 1);
  pull([(strength * x) / far, (strength * y) / far]);
}
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  drag(event);
});
canvas.addEventListener("pointermove", (event) => canvas.hasPointerCapture(event.pointerId) && drag(event));

/** @type {Record<string, () => void>} */
const keys = {
  ArrowLeft: () => turn(-Math.PI / 24),
  ArrowRight: () => turn(Math.PI / 24),
  ArrowUp: () => pull([0, G]),
  ArrowDown: () => pull([0, -G]),
  " ": toss,
  0: () => pull([0, 0]),
};
canvas.addEventListener("keydown", (event) => {
  const action = keys[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});

/** Phones know where down is; some ask first whether the page may know. */
const Orientation = /** @type {any} */ (globalThis).DeviceOrientationEvent;
if (Orientation && matchMedia("(pointer: coarse)").matches) find("tilt-device").hidden = false;
button("tilt-device", async () => {
  if (Orientation.requestPermission && (await Orientation.requestPermission()) !== "granted") return;
  addEventListener("deviceorientation", ({ beta, gamma }) => {
    if (beta === null || gamma === null) return;
    const [b, c] = [beta, gamma].map((degrees) => (degrees * Math.PI) / 180);
    pull([G * Math.sin(c) * Math.cos(b), -G * Math.sin(b)]);
  });
  find("tilt-device").textContent = "Tilt the device now";
});

/** Events are computed for as long as a frame can spare; where there are too many, simulated time goes slower. @param {number} dt */
function advance(dt) {
  if (!scene) return;
  const begin = performance.now();
  const from = scene.time;
  target = Math.max(target, from) + PLAYBACK_SPEED * dt;
  while (!scene.advanceTo(Math.max(target, scene.time), SLICE) && performance.now() - begin < BUDGET);
  target = Math.min(target, scene.time + PLAYBACK_SPEED * dt);
  rate.simulated += scene.time - from;
  rate.due += PLAYBACK_SPEED * dt;
  if (tossed > 0 && (tossed -= dt) <= 0) pull(gravity);
}

function draw() {
  view.fit();
  if (!scene) return;
  const { pen, size } = view;
  const { positions, velocities, radii } = scene;
  for (let i = 0; i < scene.count; i++) {
    const speed = Math.hypot(velocities[2 * i], velocities[2 * i + 1]);
    circle(pen, positions[2 * i] * size.width, size.height * (1 - positions[2 * i + 1]), radii[i] * size.width - 0.4);
    pen.fillStyle = scale(Math.sqrt(speed / 3.5));
    pen.fill();
  }
  compass();
}

/** Where gravity points. */
function compass() {
  const { pen, size } = view;
  const middle = [size.width / 2, size.height / 2];
  const length = (0.16 * size.width) / G;
  const to = [middle[0] + gravity[0] * length, middle[1] - gravity[1] * length];
  for (const [ink, width] of /** @type {[string, number][]} */ ([["paper", 9], ["ink", 3.5]])) {
    Object.assign(pen, { strokeStyle: colour(ink), fillStyle: colour(ink), lineWidth: width, lineCap: "round", lineJoin: "round" });
    circle(pen, middle[0], middle[1], ink === "ink" ? 4 : 7);
    pen.fill();
    if (Math.hypot(...gravity) > 0.1) arrow(pen, middle, to, 14);
  }
}

/** Once a second: what it takes. @param {number} spent */
function count(spent) {
  if (!scene) return;
  rate.frames += 1;
  rate.work += spent;
  const now = performance.now();
  const passed = (now - rate.since) / 1000;
  if (passed < 1) return;
  const c = scene.statistics;
  const events = c.collisions + c.planeCollisions + c.releases + c.interrupted;
  setText("tilt-fps", (rate.frames / passed).toFixed(0));
  setText("tilt-work", `${(rate.work / rate.frames).toFixed(1)} ms`);
  setText("tilt-events", Math.round((events - rate.before) / passed).toLocaleString("en"));
  setText("tilt-speed", rate.due > 0 ? `${Math.round((100 * PLAYBACK_SPEED * rate.simulated) / rate.due)} %` : "paused");
  setText("tilt-total", events.toLocaleString("en"));
  setText("tilt-energy", `${formatNumber(scene.kineticEnergy, 2)} J`);
  const frames = rate.frames / passed;
  announce(() => `${scene?.count} grains, ${frames.toFixed(0)} frames a second, gravity ${Math.hypot(...gravity).toFixed(1)} metres per second squared.`);
  Object.assign(rate, { since: now, frames: 0, work: 0, simulated: 0, due: 0, before: events });
}

export const start = () => restart(false);

/** @param {number} dt */
export function frame(dt) {
  const begin = performance.now();
  if (play.playing) advance(dt);
  draw();
  count(performance.now() - begin);
}
