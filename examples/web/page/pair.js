// What happens to two soft grains? Reads sliders; draws the paths by force-based MD, eMD and eMD* on each other (MP13 Fig. 6).

import { createScene } from "./carom.js";
import { announcer, button, choice, find, player, setText, slider } from "./controls.js";
import { arrow, circle, colour, formatNumber, si, surface } from "./drawing.js";
import { linear, pairContact, viscoelastic } from "./md.js";

// MP13 Sec. VI A: R = 0.1 m, ρ = 1140 kg/m³, v = 5 m/s, of which the centre of mass has v/4 across.
const RADIUS = 0.1, CONTACT_DISTANCE = 0.2, DENSITY = 1140, SPEED = 5, DRIFT = 1.25;
const MASS = (4 / 3) * Math.PI * RADIUS ** 3 * DENSITY, REDUCED = MASS / 2;
const BEGIN = -0.06, END = 0.17, SAMPLES = 460, DURATION = 4;
const POISSON = 0.4;

/**
 * @typedef {{ paths: number[][][], at: (t: number) => number[][], direction: number, jump: Jump | null }} Run
 * @typedef {{ sample: number, from: number[][], to: number[][] }} Jump where eMD* puts the two, and before which sample
 * @typedef {{ md: Run, emd: Run, star: Run, tau: number, integrated: number }} Runs
 */
/** @type {Runs | undefined} */
let runs;
let time = 0, latestRequest = 0;
/** Where the pointer was while the picture is dragged. @type {number | null} */
let dragged = null;

/** Both laws have the same unit of time T at the same slider. @param {number} k */
function material(k) {
  if (controls.law.value === "linear") {
    const lost = Math.log(controls.bounce.value);
    const damping = (-2 * lost * Math.sqrt(k * REDUCED)) / Math.hypot(Math.PI, lost);
    return { rule: { material: "linear", stiffness: k, damping }, force: linear(k, damping) };
  }
  const time = Math.sqrt(REDUCED / k);
  const rho = REDUCED * (time * SPEED ** 0.2) ** -2.5;
  const young = (rho * 1.5 * (1 - POISSON ** 2)) / Math.sqrt(RADIUS / 2);
  // About this ε: to first order ε = 1 − 0.904 c_dis (Ramírez et al., Phys. Rev. E 60, 4465, 1999), c_dis = 3A/(2T).
  const dissipation = ((2 / 3) * time * -Math.log(controls.bounce.value)) / 0.904;
  return { rule: { material: "viscoelastic", young, poisson: POISSON, dissipation }, force: viscoelastic(rho, dissipation) };
}

/** Where the two are when they touch, and how they move. @param {number} e */
function atContact(e) {
  const half = [(e * CONTACT_DISTANCE) / 2, (Math.sqrt(1 - e * e) * CONTACT_DISTANCE) / 2];
  return {
    places: [[half[0], -half[1]], [-half[0], half[1]]],
    speeds: [[DRIFT, SPEED / 2], [DRIFT, -SPEED / 2]],
  };
}

const TIMES = Array.from({ length: SAMPLES + 1 }, (_, k) => BEGIN + ((END - BEGIN) * k) / SAMPLES);

/** @param {(t: number) => number[][]} at @param {Jump | null} jump @returns {Run} */
function run(at, jump) {
  const paths = [0, 1].map((i) => TIMES.map((t) => at(t)[i]));
  const [late, later] = [at(END - 0.01), at(END)];
  const moved = [0, 1].map((a) => later[0][a] - later[1][a] - late[0][a] + late[1][a]);
  return { paths, at, jump, direction: Math.atan2(moved[1], moved[0]) };
}

/** @param {number} e @param {import("./md.js").Force} force @param {number} step */
function byForces(e, force, step) {
  const { places, speeds } = atContact(e);
  const r = [0, 1].map((a) => places[0][a] - places[1][a]);
  const v = [0, 1].map((a) => speeds[0][a] - speeds[1][a]);
  const contact = pairContact(force, REDUCED, CONTACT_DISTANCE, r, v, step);
  const at = (/** @type {number} */ t) => {
    const s = contact.at(t);
    return [1, -1].map((side) => [DRIFT * t + (side * s[0]) / 2, (side * s[1]) / 2]);
  };
  return { run: run(at, null), tau: contact.tau };
}

/** The same by carom, event by event. @param {number} e @param {object} rule */
async function byEvents(e, rule) {
  const { places, speeds } = atContact(e);
  const grains = places.map((place, i) => ({
    radius: RADIUS, density: DENSITY, velocity: speeds[i], position: place.map((x, a) => x + BEGIN * speeds[i][a]),
  }));
  const scene = await createScene(/** @type {any} */ ({ mode: "paper", rule, grains }));
  const now = () => [0, 1].map((i) => [scene.positions[2 * i], scene.positions[2 * i + 1]]);
  /** Between events grains fly straight: so the events are the whole path. */
  const legs = [{ from: scene.time, places: now(), speeds: [...scene.velocities] }];
  for (let k = 0; k < 8 && scene.step(); k++) legs.push({ from: scene.time, places: now(), speeds: [...scene.velocities] });
  const at = (/** @type {number} */ t) => {
    const leg = legs.findLast((leg) => leg.from <= t - BEGIN) ?? legs[0];
    return leg.places.map((place, i) => place.map((x, a) => x + leg.speeds[2 * i + a] * (t - BEGIN - leg.from)));
  };
  const [before, after] = legs;
  const sample = TIMES.findIndex((t) => t - BEGIN >= after.from);
  const from = before.places.map((place, i) => place.map((x, a) => x + before.speeds[2 * i + a] * (after.from - before.from)));
  return { run: run(at, { sample, from, to: after.places }), integrated: scene.statistics.integrated };
}

async function compute() {
  const request = ++latestRequest;
  const [e, k] = [controls.impact.value, controls.stiffness.value];
  const { rule, force } = material(k);
  const outside = "integrate";
  const [emd, star] = await Promise.all(["emd", "emd*"].map((method) => byEvents(e, { ...rule, method, outside })));
  if (request !== latestRequest) return;
  const md = byForces(e, force, (Math.sqrt(REDUCED / k) * Math.PI) / 1500);
  runs = { md: md.run, tau: md.tau, emd: emd.run, star: star.run, integrated: star.integrated };
  report(runs);
}

/** How far a run is from MD at the end, in units of l. @param {Run} run @param {Run} md */
const deviation = (run, md) => Math.max(...[0, 1].map((i) => Math.hypot(...[0, 1].map((a) => run.at(END)[i][a] - md.at(END)[i][a])))) / CONTACT_DISTANCE;

/** The angle between two directions, in degrees. @param {Run} run @param {Run} md */
const angleBetween = (run, md) => Math.abs((((run.direction - md.direction) * 180) / Math.PI + 540) % 360 - 180);

/** @param {Runs} runs */
function report({ md, emd, star, tau, integrated }) {
  for (const [name, run] of /** @type {[string, Run][]} */ ([["emd", emd], ["star", star]])) {
    const degrees = angleBetween(run, md);
    const angle = degrees < 0.05 ? "< 0.1°" : `${degrees.toFixed(1)}°`;
    setText(`pair-${name}-angle`, angle);
    setText(`pair-${name}-off-by`, `${angle} off`);
    setText(`pair-${name}-off`, `${formatNumber(deviation(run, md), 2)} l`);
  }
  setText("pair-tau", si(tau, "s"));
  setText("pair-source", integrated ? "integrated (softer than the standard table reaches)" : "the standard table");
  announce(() => `eMD leaves ${angleBetween(emd, md).toFixed(1)} degrees off the force-based path, eMD star ${angleBetween(star, md).toFixed(2)} degrees.`);
}

const announce = announcer("pair-announcement");
const view = surface(find("pair-canvas"));
const changed = () => void compute();
const controls = {
  impact: slider("pair-impact", (x) => x, (x) => `d/l = ${x.toFixed(2)}`, changed),
  stiffness: slider("pair-stiffness", (x) => 10 ** x, (x) => `k = ${si(x, "N/m")}`, changed),
  bounce: slider("pair-bounce", (x) => x, (x) => `ε ≈ ${x.toFixed(2)}`, changed),
  time: slider("pair-time", (x) => x, (x) => `${(1000 * x).toFixed(0)} ms`, (x) => {
    time = x;
    play.set(false);
  }),
  law: choice("pair-law", changed),
};
const play = player("pair-play");
button("pair-preset", () => {
  controls.impact.set(0.3);
  controls.stiffness.set(Math.log10(2000));
  controls.bounce.set(1);
  controls.law.set("linear");
  changed();
});

/** Dragging sideways in the picture is the impact parameter too. */
const canvas = find("pair-canvas");
canvas.addEventListener("pointerdown", (event) => {
  dragged = event.clientX;
  canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener("pointermove", (event) => {
  if (dragged === null) return;
  controls.impact.set(controls.impact.value + (1.5 * (event.clientX - dragged)) / view.size.width);
  dragged = event.clientX;
  changed();
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (dragged = null));

/** Metres to pixels. */
function camera() {
  const { width, height } = view.size;
  const zoom = Math.min(width / 0.86, height / 0.84);
  /** @param {number[]} place @returns {[number, number]} */
  const at = ([x, y]) => [width / 2 + (x - 0.1) * zoom, height / 2 - y * zoom];
  return { zoom, at };
}

/** @param {Run} run @param {string} ink @param {number} width @param {ReturnType<typeof camera>} lens */
function trace(run, ink, width, lens) {
  const { pen } = view;
  Object.assign(pen, { strokeStyle: ink, lineWidth: width, lineJoin: "round", lineCap: "round" });
  const { jump } = run;
  run.paths.forEach((path, i) => {
    const line = (/** @type {number[][]} */ points) => {
      pen.beginPath();
      for (const point of points) pen.lineTo(...lens.at(point));
      pen.stroke();
    };
    if (!jump) return line(path);
    line([...path.slice(0, jump.sample), jump.from[i]]);
    line([jump.to[i], ...path.slice(jump.sample)]);
    pen.setLineDash([2, 6]);
    line([jump.from[i], jump.to[i]]);
    pen.setLineDash([]);
  });
}

/** The paper's dots: 0 at the touch, 7 at the end of the contact. @param {Run} md @param {number} tau @param {ReturnType<typeof camera>} lens */
function dots(md, tau, lens) {
  const { pen } = view;
  if (tau * DRIFT * lens.zoom < 40) return;
  Object.assign(pen, { fillStyle: colour("ink"), font: "600 11px system-ui, sans-serif", textAlign: "center" });
  for (let k = 0; k <= 7; k++) {
    md.at((k * tau) / 7).forEach((point, i) => {
      const [x, y] = lens.at(point);
      circle(pen, x, y, 3.5);
      pen.fill();
      pen.fillText(String(k), x + (i ? -11 : 11), y + 4);
    });
  }
}

/** @param {Run} run @param {string} ink @param {boolean} solid @param {ReturnType<typeof camera>} lens */
function grains(run, ink, solid, lens) {
  const { pen } = view;
  for (const place of run.at(time)) {
    const [x, y] = lens.at(place);
    circle(pen, x, y, RADIUS * lens.zoom - 1);
    Object.assign(pen, { strokeStyle: ink, fillStyle: ink, lineWidth: solid ? 1.5 : 2.5 });
    pen.globalAlpha = solid ? 0.14 : 0.07;
    pen.fill();
    pen.globalAlpha = 1;
    pen.stroke();
    circle(pen, x, y, 4);
    pen.fill();
  }
}

function draw() {
  view.fit();
  if (!runs) return;
  const { pen } = view;
  const lens = camera();
  pen.setLineDash([5, 5]);
  Object.assign(pen, { strokeStyle: colour("faint"), lineWidth: 1.25 });
  for (const place of atContact(controls.impact.value).places) {
    const [x, y] = lens.at(place);
    circle(pen, x, y, RADIUS * lens.zoom);
    pen.stroke();
  }
  pen.setLineDash([]);
  trace(runs.md, colour("md"), 7, lens);
  trace(runs.emd, colour("emd"), 2.5, lens);
  trace(runs.star, colour("star"), 2.5, lens);
  dots(runs.md, runs.tau, lens);
  grains(runs.md, colour("ink"), true, lens);
  grains(runs.emd, colour("emd"), false, lens);
  grains(runs.star, colour("star"), false, lens);
  Object.assign(pen, { strokeStyle: colour("soft"), lineWidth: 1.5 });
  const low = lens.at([-0.25, -0.36]);
  arrow(pen, low, lens.at([-0.15, -0.36]), 8);
  Object.assign(pen, { fillStyle: colour("soft"), font: "12px system-ui, sans-serif", textAlign: "left" });
  pen.fillText("10 cm, the way both drift", low[0], low[1] - 8);
}

export async function start() {
  await compute();
  time = play.playing ? BEGIN : 0.03;
  controls.time.set(time);
}

/** @param {number} dt */
export function frame(dt) {
  if (play.playing) {
    time += (dt * (END - BEGIN)) / DURATION;
    if (time > END) time = BEGIN;
    controls.time.set(time);
  }
  draw();
}
