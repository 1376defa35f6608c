// How do up to 500 grains follow gravity? Reads pointer, keys, the device's tilt and sliders; draws a box of them, 60 times a second.

import { createScene } from "./carom.js";
import { announcer, button, choice, find, player, slider } from "./controls.js";
import { arrow, circle, colour, surface } from "./drawing.js";
import { colouring, count as countMotions, legend } from "./motion.js";
import { pacer } from "./pacing.js";
import { spins } from "./spin.js";

const G = 9.81;
/** The box is 4 m wide: grains of 5 to 8 cm fall through it in a second. */
const SIDE = 4;
/** Covered by grains: this share of the box. */
const COVERED = 0.42;
/** Steps in a contact of a cluster: as few as carom takes. How long contacts last is carom's own choice. */
const STEPS = 8;
/** @type {import("./carom.js").Scene | undefined} */
let scene;
let gravity = [0, -G];
/** @type {ReturnType<typeof spins> | undefined} */
let spun;
let latestRequest = 0, tossed = 0;
const pace = pacer("tilt");

/** @type {(seed: number) => () => number} */
const random = (seed) => () => (seed = (seed * 16807) % 2147483647) / 2147483647;

/** Grains of three sizes on a lattice. @param {number} n */
function lattice(n) {
  const next = random(20);
  const side = Math.ceil(Math.sqrt(n));
  const mean = SIDE * Math.min(Math.sqrt(COVERED / (n * Math.PI)), 0.075);
  return Array.from({ length: n }, (_, i) => ({
    radius: mean * [0.8, 1, 1.2][Math.floor(3 * next())],
    density: 1100,
    position: [((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side].map((x) => SIDE * x),
    velocity: [2 * next() - 1, 2 * next() - 1],
  }));
}

/** @param {import("./carom.js").Grain[]} grains */
function build(grains) {
  const restitution = controls.bounce.value;
  const sides = /** @type {[number, number][]} */ ([[0, SIDE], [0, SIDE]]);
  const mu = Number(controls.friction.value);
  const world = { gravity, grains, stepsPerContact: STEPS, friction: mu > 0 ? { mu } : undefined };
  if (controls.material.value === "hard") {
    const rule = /** @type {const} */ ({ material: "hard", restitution });
    return createScene({ ...world, walls: { sides, restitution }, rule });
  }
  // Rubber balls whose ε at 1 m/s is about what the slider says.
  const rule = /** @type {const} */ ({ material: "viscoelastic", young: 1e7, poisson: 0.45, outside: "hard-sphere" });
  const dissipation = 2e-3 * -Math.log(restitution);
  return createScene({ ...world, walls: { sides }, rule: { ...rule, dissipation } });
}

async function restart() {
  const request = ++latestRequest;
  const made = await build(lattice(controls.count.value));
  if (request !== latestRequest) return;
  scene = made;
  spun = spins(made);
  tossed = 0;
  pace.begin();
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
  count: slider("tilt-count", Math.round, (n) => `N = ${n}`, () => void restart()),
  bounce: slider("tilt-bounce", (x) => x, (x) => `ε = ${x.toFixed(2)}`, () => void restart()),
  material: choice("tilt-material", () => void restart()),
  friction: choice("tilt-friction", () => void restart()),
  colours: choice("tilt-colours", (by) => legend("tilt", by)),
};
const play = player("tilt-play");
button("tilt-toss", toss);
button("tilt-down", () => pull([0, -G]));
button("tilt-none", () => pull([0, 0]));
button("tilt-reset", () => void restart());

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

/** @param {number} dt */
function advance(dt) {
  if (!scene) return;
  const simulated = pace.advance(scene, dt);
  spun?.turn(simulated);
  if (tossed > 0 && (tossed -= simulated) <= 0) pull(gravity);
}

function draw() {
  view.fit();
  if (!scene) return;
  const { pen, size } = view;
  const { positions, radii } = scene;
  const zoom = size.width / SIDE;
  const ink = colouring(controls.colours.value, scene);
  for (let i = 0; i < scene.count; i++) {
    const [x, y, radius] = [positions[2 * i] * zoom, size.height - positions[2 * i + 1] * zoom, radii[i] * zoom - 0.4];
    circle(pen, x, y, radius);
    pen.fillStyle = ink(i);
    pen.fill();
    spun?.mark(pen, i, x, y, radius);
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

export async function start() {
  legend("tilt", controls.colours.value);
  await restart();
}

/** @param {number} dt */
export function frame(dt) {
  const begin = performance.now();
  if (play.playing) advance(dt);
  draw();
  if (!scene) return;
  const told = countMotions("tilt", scene);
  announce(() => `${told}. Gravity ${Math.hypot(...gravity).toFixed(1)} metres per second squared.`);
  pace.count(scene, performance.now() - begin);
}
