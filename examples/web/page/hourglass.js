// How does sand run through an hourglass? Reads pointer, keys, buttons and sliders; turns gravity, draws glass and grains, 60 times a second.

import { createScene } from "./carom.js";
import { announcer, button, choice, find, player, setText, slider } from "./controls.js";
import { circle, colour, surface } from "./drawing.js";
import { CORNERS, G, HIGH, WIDE, hourglass, steepness } from "./glass.js";
import { colouring, count as countMotions, legend } from "./motion.js";
import { pacer } from "./pacing.js";
import { spins } from "./spin.js";

/** Half of what is seen (m): the glass fits however it is turned. */
const SEEN = 1.02 * Math.hypot(HIGH, WIDE);
/** How long turning over takes (s). */
const TURNING = 0.8;

/** @type {import("./carom.js").Scene | undefined} */
let scene;
/** @type {ReturnType<typeof spins> | undefined} */
let spun;
let latestRequest = 0;
/** How far the glass is turned, and shall be, anticlockwise (rad). */
let angle = 0, wanted = 0;

const pace = pacer("hourglass");
const canvas = find("hourglass-canvas");
const view = surface(/** @type {HTMLCanvasElement} */ (canvas));
const announce = announcer("hourglass-announcement");
const controls = {
  count: slider("hourglass-count", Math.round, (n) => `N = ${n}`, () => void restart()),
  friction: choice("hourglass-friction", () => void restart()),
  colours: choice("hourglass-colours", (by) => legend("hourglass", by)),
};
const play = player("hourglass-play");
button("hourglass-turn", turnOver);
button("hourglass-reset", () => void restart());

async function restart() {
  const request = ++latestRequest;
  const made = await createScene(hourglass(controls.count.value, Number(controls.friction.value)));
  if (request !== latestRequest) return;
  scene = made;
  spun = spins(made);
  angle = wanted = 0;
  pace.begin();
}

function turnOver() {
  wanted = Math.PI * (Math.round(wanted / Math.PI) + 1);
}

/** The glass turns, and gravity stays: so in the glass gravity turns the other way. @param {number} dt */
function turn(dt) {
  if (!scene || angle === wanted) return;
  const most = (Math.PI / TURNING) * dt;
  angle = Math.abs(wanted - angle) <= most ? wanted : angle + Math.sign(wanted - angle) * most;
  scene.setGravity([-G * Math.sin(angle), -G * Math.cos(angle)]);
}

/** The direction of the pointer from the middle. @param {PointerEvent} event */
function direction(event) {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return Math.atan2(top + height / 2 - event.clientY, event.clientX - left - width / 2);
}
let held = 0;
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  held = direction(event);
});
canvas.addEventListener("pointermove", (event) => {
  if (!canvas.hasPointerCapture(event.pointerId)) return;
  const now = direction(event);
  const by = now - held;
  wanted += by - 2 * Math.PI * Math.round(by / (2 * Math.PI));
  held = now;
});

/** @type {Record<string, () => void>} */
const keys = {
  ArrowLeft: () => (wanted += Math.PI / 24),
  ArrowRight: () => (wanted -= Math.PI / 24),
  " ": turnOver,
};
canvas.addEventListener("keydown", (event) => {
  const action = keys[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});

function draw() {
  view.fit();
  if (!scene) return;
  const { pen, size } = view;
  const zoom = size.width / (2 * SEEN);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const at = (/** @type {number} */ x, /** @type {number} */ y) =>
    [size.width / 2 + zoom * (c * x - s * y), size.height / 2 - zoom * (s * x + c * y)];
  glass(pen, CORNERS.map(([x, y]) => at(x, y)));
  const { positions, radii } = scene;
  const ink = colouring(controls.colours.value, scene);
  for (let i = 0; i < scene.count; i++) {
    const [x, y] = at(positions[2 * i], positions[2 * i + 1]);
    const radius = radii[i] * zoom - 0.4;
    circle(pen, x, y, radius);
    pen.fillStyle = ink(i);
    pen.fill();
    if (controls.friction.value !== "0") spun?.mark(pen, i, x, y, radius, angle);
  }
}

/** @param {CanvasRenderingContext2D} pen @param {number[][]} corners */
function glass(pen, corners) {
  pen.beginPath();
  for (const [x, y] of corners) pen.lineTo(x, y);
  pen.closePath();
  Object.assign(pen, { strokeStyle: colour("ink"), fillStyle: colour("card"), lineWidth: 3, lineJoin: "round" });
  pen.fill();
  pen.stroke();
}

/** How many are in the bulb that is below now. @param {import("./carom.js").Scene} scene */
function sand({ count, positions }) {
  let below = 0;
  for (let i = 0; i < count; i++) {
    if (Math.sin(angle) * positions[2 * i] + Math.cos(angle) * positions[2 * i + 1] < 0) below += 1;
  }
  setText("hourglass-below", String(below));
}

export async function start() {
  legend("hourglass", controls.colours.value);
  await restart();
}

/** @param {number} dt */
export function frame(dt) {
  const begin = performance.now();
  if (play.playing && scene) {
    turn(dt);
    spun?.turn(pace.advance(scene, dt));
  }
  draw();
  if (!scene) return;
  const told = countMotions("hourglass", scene);
  sand(scene);
  const up = Math.cos(angle);
  const degrees = (Math.atan(steepness(scene, Math.sign(up))) * 180) / Math.PI;
  const isHeap = Math.abs(up) > 0.999 && scene.states.every((state) => state === 2);
  setText("hourglass-slope", isHeap ? `${degrees.toFixed(0)}°` : "–");
  announce(() => `${told}.`);
  pace.count(scene, performance.now() - begin);
}
