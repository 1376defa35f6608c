// Which types does carom.js have? Read by editors and the type checker.

/** Worlds of each dimension have a WebAssembly module of their own. */
export type Dimension = 1 | 2 | 3;
/** As many numbers as the scene has dimensions. */
export type Vector = ArrayLike<number>;

/** The most grains of a scene: 500. */
export const MAX_GRAINS: number;
/** The most segments of a scene's obstacles: 100. */
export const MAX_SEGMENTS: number;

/** An error of carom, with its own message: it names the field, its value and what would be right. */
export class CaromError extends Error {}

/** What grains are made of. All units SI, or any consistent ones. */
export type Material =
  /** Hard spheres with a constant coefficient of restitution. */
  | { material: "hard"; restitution: number }
  /** Linear spring-dashpot: k (N/m), γ (kg/s). MP13, Eq. (40). */
  | { material: "linear"; stiffness: number; damping: number }
  /** Viscoelastic spheres: Y (Pa), ν, A (s). MP13, Eq. (51). */
  | { material: "viscoelastic"; young: number; poisson: number; dissipation: number };

/** What grains do when they touch. */
export type Rule = Material & {
  /** `emd*` (the default): contacts last and turn. `emd`: instantaneous, with the law's ε(v). */
  method?: "emd*" | "emd";
  /**
   * Outside the domain of the law's certified table: an error, the nearest collision inside, hard
   * spheres (the default), or the contact equation integrated on the spot (counted as `integrated`).
   */
  outside?: "reject" | "clamp" | "hard-sphere" | "integrate";
};

export interface Grain {
  radius: number;
  /** Either this, or `density`. */
  mass?: number;
  /** Of a sphere, in every dimension. */
  density?: number;
  position: Vector;
  velocity?: Vector;
  material?: number;
}

/** Where normal · r ≥ offset. */
export interface Plane {
  /** A unit vector into the allowed side. */
  normal: Vector;
  offset: number;
  /** Missing: the rule decides. */
  restitution?: number;
  /** z₀(t) = amplitude · sin(2π (frequency · t + phase)), along the normal. */
  vibration?: { amplitude: number; frequency: number; phase?: number };
}

/** A box: `[low, high]` along each axis. */
export interface Walls {
  sides: [number, number][];
  /** Missing: the rule decides. */
  restitution?: number;
}

/** A chain of segments, or a polygon; grains touch it from both sides. */
export interface Obstacle {
  points: Vector[];
  /** Whether the last point is joined to the first. */
  closed?: boolean;
  /** Missing: the rule decides. */
  restitution?: number;
}

/** Rough grains, which rotate: Walton's rule. */
export interface Friction {
  /** The coefficient of friction μ. */
  mu: number;
  /** The coefficient of tangential restitution of surfaces that stick, from -1 to 1: 0 by default. */
  beta0?: number;
}

export interface SceneOptions {
  /** 2 by default. */
  dimension?: Dimension;
  walls?: Walls;
  /** Planes besides the box. */
  planes?: Plane[];
  /** `[low, high]` for each periodic axis; `null` for the others. */
  periodic?: ([number, number] | null)[];
  gravity?: Vector;
  /**
   * Contacts that last or crowd: integrated, so that heaps come to rest (the default); or as in the papers, where each is
   * an event (L94, BSFP14) or a pair's own affair (MP13).
   */
  mode?: "integrated" | "paper";
  /**
   * How long a slow contact of hard grains lasts; (R/g)^½/16 by default, at most 0.7 (R/g)^½. In the papers' mode
   * t_c of the TC rule, by default no such rule.
   */
  contactTime?: number;
  /** Steps in the shortest contact of a cluster: 32 by default, at least 8. */
  stepsPerContact?: number;
  rule: Rule;
  grains: Grain[];
  /** What stands inside, in two dimensions. No axis is periodic then. */
  obstacles?: Obstacle[];
  /** In two dimensions; grains are smooth without it. */
  friction?: Friction;
}

/** How often everything happened: carom's statistics, and contacts that were integrated. */
export type Statistics = Record<
  | "collisions" | "planeCollisions" | "releases" | "rotationRefused" | "interrupted" | "deferred"
  | "clamped" | "hardSphere" | "rests" | "takeOffs" | "withinTc" | "collapses" | "supportedCollisions"
  | "reordered" | "stale" | "cellCrossings" | "rechecks" | "epochs" | "joins" | "steps" | "crushed" | "integrated",
  number
>;

/**
 * A running world. The arrays are views of the WebAssembly memory: they always show the present, and
 * nothing is copied. A scene needs no disposal.
 */
export interface Scene {
  readonly dimension: Dimension;
  readonly count: number;
  /** `dimension` numbers for each grain; read only. */
  readonly positions: Float64Array;
  /** `dimension` numbers for each grain; read only. */
  readonly velocities: Float64Array;
  readonly radii: Float64Array;
  /** The angular velocity of each grain, anticlockwise (1/s), where there are friction or obstacles; else empty. Read only. */
  readonly rotations: Float64Array;
  /** For each grain 0: in flight, 1: in a contact of two, 2: at rest, 3: in a cluster. */
  readonly states: Uint8Array;
  readonly time: number;
  /** Nothing happens before this time; `Infinity` if nothing ever will. */
  readonly nextEventTime: number;
  readonly kineticEnergy: number;
  readonly statistics: Statistics;
  /** 16 hexadecimal digits of the whole state: equal states have equal digests on every machine. */
  readonly digest: string;
  /**
   * Everything up to and including this time happens, but no more than `maxEvents` events: false if
   * there are more to come. (With a limit, `time` may then be that of an event a little later.)
   * @throws {CaromError}
   */
  advanceTo(time: number, maxEvents?: number): boolean;
  /** The next event happens; false if nothing will ever happen again. @throws {CaromError} */
  step(): boolean;
  /** Changes gravity now, in the middle of contacts too. @throws {CaromError} */
  setGravity(gravity: Vector): void;
}

/** Loads and compiles the module of a dimension, or of rough grains and obstacles, once. `createScene` does it when needed. */
export function load(dimension: Dimension, rough?: boolean): Promise<WebAssembly.Module>;

/** Checks and starts a world. @throws {CaromError} */
export function createScene(options: SceneOptions): Promise<Scene>;
