// How does JavaScript use carom? Reads a description; writes a WebAssembly instance per scene and views of its memory.
// Types and documentation: carom.d.ts.

// Each address in full: bundlers copy the files that they find in this form.
const FILES = [
  new URL("./carom-line.wasm", import.meta.url),
  new URL("./carom-plane.wasm", import.meta.url),
  new URL("./carom-space.wasm", import.meta.url),
  // Rough grains among obstacles, in the plane.
  new URL("./carom-rough.wasm", import.meta.url),
];
const MATERIALS = ["hard", "linear", "viscoelastic"];
const OUTSIDE = ["reject", "clamp", "hard-sphere", "integrate"];
const METHODS = ["emd", "emd*"];
const MODES = ["integrated", "paper"];
const GRAINS = 0, POSITIONS = 1, VELOCITIES = 2, STATES = 3, STATISTICS = 4, CLOCK = 5, ERROR = 6, NAMES = 7, ROTATIONS = 8;
const GRAIN_FIELDS = 9;

/** The most grains of a scene, and the most segments of its obstacles. */
export const MAX_GRAINS = 500, MAX_SEGMENTS = 100;

/** An error of carom, with its own message. */
export class CaromError extends Error {
  name = "CaromError";
}

/** @param {URL} url */
async function compile(url) {
  if (url.protocol === "file:" && typeof process !== "undefined") {
    // Not `import`, which a bundler for browsers would replace.
    const { readFile } = process.getBuiltinModule("node:fs/promises");
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new CaromError(`${url.pathname} cannot be loaded: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** @type {Map<number, Promise<WebAssembly.Module>>} */
const modules = new Map();

/** @param {import("./carom.js").Dimension} dimension @param {boolean} [rough] */
export function load(dimension, rough = false) {
  const number = rough ? 3 : dimension - 1;
  if (![0, 1, 2].includes(dimension - 1)) throw new CaromError(`dimension is ${dimension}, must be 1, 2 or 3`);
  if (rough && dimension !== 2) throw new CaromError(`dimension is ${dimension}, must be 2 where there are obstacles or friction`);
  let module = modules.get(number);
  if (!module) modules.set(number, (module = compile(FILES[number])));
  return module;
}

/** @param {string} field @param {string[]} names @param {string} name */
function indexOf(field, names, name) {
  const number = names.indexOf(name);
  if (number < 0) throw new CaromError(`${field} is ${JSON.stringify(name)}, must be one of ${names.join(", ")}`);
  return number;
}

/** A vector of three numbers; what is missing is zero. @param {string} field @param {ArrayLike<number>} v @param {number} dimension */
function vector(field, v, dimension) {
  if (!v || v.length !== dimension) throw new CaromError(`${field} must have ${dimension} components`);
  return Array.from({ length: 3 }, (_, i) => (i < dimension ? Number(v[i]) : 0));
}

/** The planes of a box, two for each axis. @param {import("./carom.js").Walls} walls @param {number} dimension */
function sides({ sides, restitution }, dimension) {
  if (sides?.length !== dimension) throw new CaromError(`walls.sides must have ${dimension} pairs [low, high]`);
  return sides.flatMap(([low, high], axis) =>
    [1, -1].map((sign) => ({
      normal: Array.from({ length: dimension }, (_, i) => (i === axis ? sign : 0)),
      offset: sign > 0 ? low : -high,
      restitution,
    })),
  );
}

/** Whether a scene needs the module of rough grains and obstacles. @param {import("./carom.js").SceneOptions} options */
const isRough = ({ friction, obstacles }) => friction !== undefined || obstacles !== undefined;

/** Friction and obstacles. @param {any} wasm @param {import("./carom.js").SceneOptions} options */
function describeSurfaces(wasm, { friction, obstacles = [] }) {
  if (friction) wasm.friction(Number(friction.mu), friction.beta0 ?? 0);
  const count = obstacles.reduce((sum, { points, closed }) => sum + points.length - (closed ? 0 : 1), 0);
  if (count > MAX_SEGMENTS) throw new CaromError(`obstacles have ${count} segments, must be at most ${MAX_SEGMENTS}`);
  for (const [number, { points, closed, restitution }] of obstacles.entries()) {
    const corners = points.map((point) => vector(`obstacle ${number}: a point`, point, 2));
    if (closed) corners.push(corners[0]);
    for (let k = 1; k < corners.length; k++) {
      const [[ax, ay], [bx, by]] = [corners[k - 1], corners[k]];
      wasm.facet(ax, ay, bx, by, restitution ?? NaN);
    }
  }
}

/** @param {any} wasm @param {import("./carom.js").SceneOptions} options @param {number} dimension */
function describe(wasm, options, dimension) {
  for (const p of [...(options.walls ? sides(options.walls, dimension) : []), ...(options.planes ?? [])]) {
    const { amplitude = 0, frequency = 0, phase = 0 } = p.vibration ?? {};
    const [x, y, z] = vector("normal", p.normal, dimension);
    wasm.plane(x, y, z, p.offset, p.restitution ?? NaN, amplitude, frequency, phase);
  }
  (options.periodic ?? []).forEach((side, axis) => side && wasm.periodic(axis, side[0], side[1]));
  const rule = options.rule;
  const material = indexOf("rule.material", MATERIALS, rule?.material);
  const lasting = indexOf("rule.method", METHODS, rule.method ?? "emd*");
  const outside = indexOf("rule.outside", OUTSIDE, rule.outside ?? "hard-sphere");
  const r = /** @type {any} */ (rule);
  const numbers = [[r.restitution], [r.stiffness, r.damping], [r.young, r.poisson, r.dissipation]][material];
  wasm.rule(material, lasting, outside, numbers[0], numbers[1] ?? 0, numbers[2] ?? 0);
  wasm.contacts(indexOf("mode", MODES, options.mode ?? "integrated"), options.contactTime ?? NaN, options.stepsPerContact ?? 0);
  if (isRough(options)) describeSurfaces(wasm, options);
  wasm.gravity(...vector("gravity", options.gravity ?? [0, 0, 0].slice(0, dimension), dimension));
}

/** @param {Float64Array} table @param {import("./carom.js").Grain[]} grains @param {number} dimension */
function fill(table, grains, dimension) {
  grains.forEach((grain, i) => {
    const { radius, density, material = 0 } = grain;
    // Not `radius ** 3`: browsers differ in its last place, and grains would go other ways.
    const mass = grain.mass ?? (4 / 3) * Math.PI * radius * radius * radius * (density ?? NaN);
    const at = vector(`grain ${i}: position`, grain.position, dimension);
    const moving = vector(`grain ${i}: velocity`, grain.velocity ?? new Float64Array(dimension), dimension);
    table.set([radius, mass, material, ...at, ...moving], GRAIN_FIELDS * i);
  });
}

/** One world in one instance of the module. */
class Scene {
  #wasm;
  #clock;
  #statistics;
  #names;

  /** @param {any} wasm @param {import("./carom.js").SceneOptions} options @param {number} dimension */
  constructor(wasm, options, dimension) {
    this.#wasm = wasm;
    const count = options.grains.length;
    if (count > MAX_GRAINS) throw new CaromError(`${count} grains, must be at most ${MAX_GRAINS}`);
    describe(wasm, options, dimension);
    const table = new Float64Array(wasm.memory.buffer, wasm.address(GRAINS), GRAIN_FIELDS * count);
    fill(table, options.grains, dimension);
    /** @param {number} of @param {number} length */
    const numbers = (of, length) => new Float64Array(wasm.memory.buffer, wasm.address(of), length);
    this.dimension = dimension;
    this.count = count;
    this.radii = Float64Array.from(options.grains, (grain) => grain.radius);
    this.positions = numbers(POSITIONS, dimension * count);
    this.velocities = numbers(VELOCITIES, dimension * count);
    this.rotations = isRough(options) ? numbers(ROTATIONS, count) : new Float64Array();
    this.states = new Uint8Array(wasm.memory.buffer, wasm.address(STATES), count);
    this.#clock = numbers(CLOCK, 3);
    this.#names = this.#text(NAMES).split(",");
    this.#statistics = numbers(STATISTICS, this.#names.length);
    this.#check(wasm.start(count));
  }

  /** @param {number} of */
  #text(of) {
    const { memory, address, length } = this.#wasm;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, address(of), length(of)));
  }

  /** @param {number} status */
  #check(status) {
    if (status === 1) throw new CaromError(this.#text(ERROR));
    return status === 0;
  }

  get time() {
    return this.#clock[0];
  }

  get nextEventTime() {
    return this.#clock[1];
  }

  get kineticEnergy() {
    return this.#clock[2];
  }

  get statistics() {
    return /** @type {any} */ (Object.fromEntries(this.#names.map((name, i) => [name, this.#statistics[i]])));
  }

  get digest() {
    return BigInt.asUintN(64, this.#wasm.digest()).toString(16).padStart(16, "0");
  }

  /** @param {number} time @param {number} [maxEvents] */
  advanceTo(time, maxEvents = 0xffffffff) {
    return this.#check(this.#wasm.advance(time, maxEvents));
  }

  step() {
    return this.#check(this.#wasm.step());
  }

  /** @param {ArrayLike<number>} gravity */
  setGravity(gravity) {
    this.#check(this.#wasm.gravity(...vector("gravity", gravity, this.dimension)));
  }
}

/** @param {import("./carom.js").SceneOptions} options @returns {Promise<any>} */
export async function createScene(options) {
  const dimension = options.dimension ?? 2;
  const instance = await WebAssembly.instantiate(await load(dimension, isRough(options)), {});
  return new Scene(instance.exports, options, dimension);
}
