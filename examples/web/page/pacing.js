// How much of a scene is computed in a frame? Reads the clock; writes how long frames take, and how far simulated time is behind.

import { setText } from "./controls.js";
import { formatNumber } from "./drawing.js";

/** Milliseconds that events may take in a frame, and in one call. */
const BUDGET = 9, CALL = 1;

/** Keeps the pace of an experiment, whose numbers are shown in elements `name-…`. @param {string} name */
export function pacer(name) {
  /** Simulated time that has not been computed in time, since the start. */
  let behind = 0;
  /** What an event takes, in milliseconds. */
  let pace = 0.05;
  /** Of the last second: frames, their work and the longest, simulated time and what was due; events before it. */
  const rate = { since: 0, frames: 0, work: 0, longest: 0, simulated: 0, due: 0, before: 0 };
  const reset = (/** @type {number} */ since, before = 0) =>
    void Object.assign(rate, { since, frames: 0, work: 0, longest: 0, simulated: 0, due: 0, before });

  /** Events for as long as a frame can spare; where there are too many, simulated time goes slower. Returns how far it went. @param {import("./carom.js").Scene} scene @param {number} dt */
  function advance(scene, dt) {
    const begin = performance.now();
    const from = scene.time;
    let [arrived, now] = [false, begin];
    while (!arrived && now - begin < BUDGET) {
      const events = Math.min(Math.max(Math.round(CALL / pace), 2), 1000);
      arrived = scene.advanceTo(Math.max(from + dt, scene.time), events);
      const then = now;
      now = performance.now();
      if (!arrived) pace += 0.3 * (Math.max((now - then) / events, 1e-4) - pace);
    }
    const simulated = scene.time - from;
    rate.simulated += simulated;
    rate.due += dt;
    behind += Math.max(dt - simulated, 0);
    return simulated;
  }

  /** Once a second: what it takes. @param {import("./carom.js").Scene} scene @param {number} spent */
  function count(scene, spent) {
    rate.frames += 1;
    rate.work += spent;
    rate.longest = Math.max(rate.longest, spent);
    const now = performance.now();
    const passed = (now - rate.since) / 1000;
    if (passed < 1) return;
    const c = scene.statistics;
    const events = c.collisions + c.planeCollisions + c.releases + c.interrupted + c.steps;
    setText(`${name}-fps`, (rate.frames / passed).toFixed(0));
    setText(`${name}-work`, `${(rate.work / rate.frames).toFixed(1)} ms`);
    setText(`${name}-longest`, `${rate.longest.toFixed(1)} ms`);
    setText(`${name}-events`, Math.round((events - rate.before) / passed).toLocaleString("en"));
    setText(`${name}-speed`, rate.due > 0 ? `${Math.round((100 * rate.simulated) / rate.due)} %` : "paused");
    setText(`${name}-behind`, `${behind.toFixed(1)} s`);
    setText(`${name}-total`, events.toLocaleString("en"));
    setText(`${name}-energy`, `${formatNumber(scene.kineticEnergy, 2)} J`);
    setText(`${name}-time`, `${scene.time.toFixed(1)} s`);
    reset(now, events);
  }

  return {
    advance,
    count,
    /** A scene begins. */
    begin() {
      behind = 0;
      reset(performance.now());
    },
  };
}
