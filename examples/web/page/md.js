// What does force-based molecular dynamics give? Reads force laws and grains; writes their motion in small steps.
// Plain JavaScript, and nothing of carom: the event-driven methods are compared with it.

/**
 * A contact force: F(compression, its rate).
 * @typedef {(x: number, rate: number) => number} Force
 */

/** Linear spring and dashpot (MP13 Eq. 40). @param {number} k @param {number} gamma @returns {Force} */
export const linear = (k, gamma) => (x, rate) => k * x + gamma * rate;

/** Viscoelastic spheres (MP13 Eq. 51). @param {number} rho @param {number} a @returns {Force} */
export const viscoelastic = (rho, a) => (x, rate) => {
  const root = Math.sqrt(Math.max(x, 0));
  return rho * root * (x + 1.5 * a * rate);
};

/**
 * One contact of two grains in a plane, from touch until the force vanishes (MP13 Eq. 10), by classical
 * Runge-Kutta steps; the end is found by bisection.
 * @param {Force} force @param {number} mass the reduced one @param {number} contactDistance l = R1 + R2
 * @param {number[]} r separation at touch @param {number[]} v its rate @param {number} step
 */
export function pairContact(force, mass, contactDistance, r, v, step) {
  const normal = (/** @type {number[]} */ s) => {
    const distance = Math.hypot(s[0], s[1]);
    return force(contactDistance - distance, -(s[0] * s[2] + s[1] * s[3]) / distance);
  };
  const slope = (/** @type {number[]} */ s) => {
    const pull = normal(s) / mass / Math.hypot(s[0], s[1]);
    return [s[2], s[3], pull * s[0], pull * s[1]];
  };
  const after = (/** @type {number[]} */ s, /** @type {number} */ h) => {
    const along = (/** @type {number[]} */ k, /** @type {number} */ f) => s.map((x, i) => x + f * k[i]);
    const a = slope(s);
    const b = slope(along(a, h / 2));
    const c = slope(along(b, h / 2));
    const d = slope(along(c, h));
    return s.map((x, i) => x + (h / 6) * (a[i] + 2 * (b[i] + c[i]) + d[i]));
  };
  const over = (/** @type {number[]} */ s) => normal(s) <= 0 && s[0] * s[2] + s[1] * s[3] > 0;
  let state = [r[0], r[1], v[0], v[1]];
  const path = [state];
  while (path.length < 100_000) {
    const next = after(state, step);
    if (over(next)) break;
    path.push((state = next));
  }
  let [low, high] = [0, step];
  for (let k = 0; k < 50; k++) {
    const middle = (low + high) / 2;
    if (over(after(state, middle))) high = middle;
    else low = middle;
  }
  const end = after(state, high);
  const tau = (path.length - 1) * step + high;
  /** The separation at a time since touch. @param {number} t */
  const at = (t) => {
    if (t <= 0) return [r[0] + v[0] * t, r[1] + v[1] * t];
    if (t >= tau) return [0, 1].map((i) => end[i] + end[i + 2] * (t - tau));
    const k = Math.min(Math.floor(t / step), path.length - 1);
    return after(path[k], t - k * step).slice(0, 2);
  };
  return { tau, end, at };
}

/** Gravity (m/s²). */
export const G = 9.81;

/**
 * A column of equal beads of mass 1 on a vibrating plate: spring and dashpot, which may pull until the
 * overlap vanishes (L94 Eqs. 5 and 6); velocity Verlet in fixed steps.
 */
export class Column {
  time = 0;

  /** @param {{ beads: number, diameter: number, restitution: number, contactTime: number, amplitude: number, frequency: number, heights: number[] }} options */
  constructor(options) {
    const mu = -Math.log(options.restitution) / options.contactTime;
    this.damping = mu;
    this.stiffness = 0.5 * ((Math.PI / options.contactTime) ** 2 + mu ** 2);
    this.diameter = options.diameter;
    this.amplitude = options.amplitude;
    this.omega = 2 * Math.PI * options.frequency;
    this.step = options.contactTime / 40;
    this.z = Float64Array.from(options.heights);
    this.v = new Float64Array(options.beads);
    this.a = new Float64Array(options.beads);
    this.old = new Float64Array(options.beads);
  }

  /** Coefficients of restitution of two beads, and of a bead and the plate (L94 Eq. 7). */
  get restitutions() {
    return [0.5, 1].map((mass) => {
      const mu = (0.5 * this.damping) / mass;
      return Math.exp((-mu * Math.PI) / Math.sqrt(this.stiffness / mass - mu * mu));
    });
  }

  /** @param {number} t */
  plate(t) {
    return this.amplitude * Math.sin(this.omega * t);
  }

  /** Accelerations, with velocities as they will be at the end of the step. @param {number} t */
  #pull(t) {
    const { z, v, a, stiffness, damping, diameter } = this;
    let below = this.plate(t) - diameter / 2;
    let speed = this.amplitude * this.omega * Math.cos(this.omega * t);
    let lifted = 0;
    for (let i = 0; i < z.length; i++) {
      const x = diameter - (z[i] - below);
      const push = x > 0 ? stiffness * x - damping * (v[i] - speed) : 0;
      if (i > 0) a[i - 1] = lifted - push - G;
      lifted = push;
      below = z[i];
      speed = v[i];
    }
    a[z.length - 1] = lifted - G;
  }

  /** @param {number} time */
  advanceTo(time) {
    const { z, v, a, old, step } = this;
    while (this.time < time) {
      for (let i = 0; i < z.length; i++) {
        v[i] += (step / 2) * a[i];
        z[i] += step * v[i];
      }
      this.time += step;
      for (let i = 0; i < z.length; i++) v[i] += (step / 2) * a[i];
      old.set(a);
      this.#pull(this.time);
      for (let i = 0; i < z.length; i++) v[i] += (step / 2) * (a[i] - old[i]);
    }
  }
}
