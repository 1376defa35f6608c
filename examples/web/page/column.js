// Does a column of beads stay together on a vibrating plate? Reads sliders; draws it by force-based MD and event by event (L94 Fig. 5).

import { createScene } from "./carom.js";
import { announcer, button, find, player, setText, slider } from "./controls.js";
import { colour, scale, si, surface } from "./drawing.js";
import { Column, G } from "./md.js";

const DIAMETER = 1e-3, FREQUENCY = 20, SLOWER = 20;
/** The diagrams show so much of the past, in periods; the figures are means over the last of them. */
const PERIODS = 10;
const SPAN = PERIODS / FREQUENCY;

/** @typedef {{ time: number, plate: number, md: Float64Array, ed: Float64Array }} Sample */
/** @type {{ md: Column, ed: import("./carom.js").Scene, beads: number, contactTime: number, samples: Sample[] } | undefined} */
let run;
let latestRequest = 0;

async function restart() {
  const request = ++latestRequest;
  const [beads, restitution] = [controls.beads.value, controls.bounce.value];
  const contactTime = controls.contact.value;
  const amplitude = (controls.shake.value * G) / (2 * Math.PI * FREQUENCY) ** 2;
  const heights = Array.from({ length: beads }, (_, i) => (i + 0.5) * DIAMETER + (i + 1) * 1e-3 * DIAMETER);
  const md = new Column({ beads, diameter: DIAMETER, restitution, contactTime, amplitude, frequency: FREQUENCY, heights });
  const [pair, wall] = md.restitutions;
  const ed = await createScene({
    dimension: 1,
    mode: "paper",
    planes: [{ normal: [1], offset: 0, restitution: wall, vibration: { amplitude, frequency: FREQUENCY } }],
    gravity: [-G],
    rule: { material: "hard", restitution: pair },
    grains: heights.map((z) => ({ radius: DIAMETER / 2, mass: 1, position: [z] })),
  });
  if (request === latestRequest) run = { md, ed, beads, contactTime, samples: [] };
}

const view = surface(find("column-canvas"));
const announce = announcer("column-announcement");
const changed = () => void restart();
const controls = {
  beads: slider("column-beads", Math.round, (n) => `N = ${n}`, changed),
  bounce: slider("column-bounce", (x) => x, (x) => `ε = ${x.toFixed(2)}`, changed),
  contact: slider("column-contact", (x) => 10 ** x, (x) => si(x, "s", 2), changed),
  shake: slider("column-shake", (x) => x, (x) => `α = ${x.toFixed(1)} g`, changed),
};
const play = player("column-play");
/** @param {number} contact @param {number} [bounce] @param {number} [shake] */
function preset(contact, bounce = 0.6, shake = 2) {
  controls.beads.set(10);
  controls.bounce.set(bounce);
  controls.contact.set(Math.log10(contact));
  controls.shake.set(shake);
  changed();
}
button("column-long", () => preset(0.7e-3));
button("column-short", () => preset(0.7e-5));
button("column-gas", () => preset(1e-4, 0.92, 5));

/** @param {number} dt */
function advance(dt) {
  if (!run) return;
  const { md, ed, samples } = run;
  const pieces = 3;
  for (let k = 1; k <= pieces; k++) {
    const time = ed.time + dt / pieces / SLOWER;
    ed.advanceTo(time);
    md.advanceTo(time);
    samples.push({ time, plate: md.plate(time), md: md.z.slice(), ed: ed.positions.slice() });
  }
  while (samples.length && samples[0].time < ed.time - SPAN) samples.shift();
}

/** How far apart the beads are: the sum of all gaps, in diameters. @param {ArrayLike<number>} z */
const stretch = (z) => (z[z.length - 1] - z[0]) / DIAMETER - (z.length - 1);
/** How high the centre of mass is above that of the column at rest. @param {Float64Array} z */
const rise = (z) => z.reduce((sum, x) => sum + x, 0) / z.length - (z.length * DIAMETER) / 2;

/** @param {NonNullable<typeof run>} run */
function report({ samples, beads }) {
  const mean = (/** @type {(s: Sample) => number} */ of) => samples.reduce((sum, s) => sum + of(s), 0) / samples.length;
  for (const name of /** @type {const} */ (["md", "ed"])) {
    setText(`column-${name}-gaps`, `${Math.abs(mean((s) => stretch(s[name]))).toFixed(2)} d`);
    setText(`column-${name}-most`, `${Math.max(...samples.map((s) => Math.abs(stretch(s[name])))).toFixed(2)} d`);
    setText(`column-${name}-high`, `${(1000 * mean((s) => rise(s[name]))).toFixed(2)} mm`);
  }
  announce(() => `${beads} beads. Sum of all gaps: force-based ${mean((s) => stretch(s.md)).toFixed(1)} diameters, event-driven ${mean((s) => stretch(s.ed)).toFixed(1)}.`);
}

/** @typedef {{ x: number, y: number, width: number, height: number }} Place */

/** How much height the columns need. */
let shownHeight = 0;

/** Two columns on one plate. @param {NonNullable<typeof run>} run @param {Place} place */
function columns({ md, ed, beads, samples }, place) {
  const { pen } = view;
  const now = ed.time;
  // Room for the highest bead of late; it changes gently.
  const tall = Math.max((beads + 5) * DIAMETER, ...samples.map((s) => Math.max(s.md[beads - 1], s.ed[beads - 1]) + 2.5 * DIAMETER));
  shownHeight += (tall - shownHeight) * (shownHeight ? 0.08 : 1);
  const zoom = Math.min((place.height - 78) / shownHeight, place.width / 2.6 / DIAMETER);
  const floor = place.y + place.height - 14 - 1.8 * zoom * DIAMETER;
  const plate = floor - md.plate(now) * zoom;
  /** @type {[string, ArrayLike<number>, number][]} */
  const both = [["Force-based", md.z, place.x + place.width * 0.27], ["Event-driven", ed.positions, place.x + place.width * 0.73]];
  Object.assign(pen, { fillStyle: colour("soft") });
  pen.beginPath();
  pen.roundRect(place.x + 4, plate, place.width - 8, 7, 3);
  pen.fill();
  for (const [name, heights, x] of both) {
    for (let i = 0; i < beads; i++) {
      pen.beginPath();
      pen.arc(x, floor - heights[i] * zoom, (DIAMETER / 2) * zoom - 0.5, 0, 2 * Math.PI);
      pen.fillStyle = scale(i / Math.max(beads - 1, 1));
      pen.fill();
    }
    label(name, x, place.y + 14, "center");
    label(`gaps ${Math.abs(stretch(heights)).toFixed(1)} d`, x, place.y + 32, "center", "soft");
  }
}

/** @param {string} text @param {number} x @param {number} y @param {CanvasTextAlign} [align] @param {string} [ink] */
function label(text, x, y, align = "left", ink = "ink") {
  Object.assign(view.pen, { fillStyle: colour(ink), font: `${ink === "ink" ? 600 : 400} 13px system-ui, sans-serif`, textAlign: align });
  view.pen.fillText(text, x, y);
}

/** Reduced heights against time, as in L94's Fig. 5: beads that touch are one line. @param {"md" | "ed"} name @param {string} title @param {NonNullable<typeof run>} run @param {Place} place */
function diagram(name, title, { samples, beads, ed, md }, place) {
  const { pen } = view;
  const highest = samples.map((s) => Math.max(s.md[beads - 1], s.ed[beads - 1]) - (beads - 0.5) * DIAMETER);
  const most = Math.max(3e-3, ...highest);
  const low = Math.min(-2e-3, -1.1 * md.amplitude);
  const end = Math.max(ed.time, SPAN);
  const x = (/** @type {number} */ t) => place.x + place.width * (1 - (end - t) / SPAN);
  const y = (/** @type {number} */ z) => place.y + 24 + (place.height - 30) * (1 - (z - low) / (most - low));
  label(title, place.x, place.y + 14);
  Object.assign(pen, { strokeStyle: colour("line"), lineWidth: 1 });
  for (let mm = 0; mm <= most * 1000; mm += most > 12e-3 ? 5 : 2) {
    pen.beginPath();
    pen.moveTo(place.x, y(mm / 1000));
    pen.lineTo(place.x + place.width, y(mm / 1000));
    pen.stroke();
    label(`${mm} mm`, place.x - 6, y(mm / 1000) + 4, "right", "soft");
  }
  /** @param {(s: Sample) => number} of @param {string} ink @param {number} width */
  const curve = (of, ink, width) => {
    Object.assign(pen, { strokeStyle: ink, lineWidth: width, lineJoin: "round" });
    pen.beginPath();
    for (const s of samples) pen.lineTo(x(s.time), y(of(s)));
    pen.stroke();
  };
  curve((s) => s.plate, colour("faint"), 1.5);
  for (let i = 0; i < beads; i++) {
    curve((s) => s[name][i] - (i + 0.5) * DIAMETER, scale(i / Math.max(beads - 1, 1)), 1.75);
  }
}

function draw() {
  const { width, height } = view.fit();
  if (!run) return;
  const narrow = width < 620;
  const left = narrow ? width : Math.min(0.36 * width, 300);
  const tall = narrow ? 0.5 * height : height;
  columns(run, { x: 0, y: 0, width: left, height: tall });
  const place = narrow
    ? { x: 48, y: tall + 10, width: width - 54, height: (height - tall - 10) / 2 }
    : { x: left + 70, y: 0, width: width - left - 80, height: height / 2 };
  diagram("md", "Force-based: heights of all beads", run, place);
  diagram("ed", "Event-driven: heights of all beads", run, { ...place, y: place.y + place.height });
}

export const start = restart;
let since = 0;

/** @param {number} dt */
export function frame(dt) {
  if (play.playing) advance(dt);
  draw();
  since += dt;
  if (run?.samples.length && since > 0.25) {
    report(run);
    since = 0;
  }
}
