// Can the package be used? Packs dist/, installs it into a project of its own; runs it in Node and through a bundler, checks its types.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { createScene } from "../dist/carom.js";

const web = fileURLToPath(new URL("..", import.meta.url));
const project = mkdtempSync(join(tmpdir(), "carom-package-"));
const bin = (/** @type {string} */ name) => join(web, "node_modules", ".bin", name);
/** @param {string} command @param {string[]} words */
const run = (command, ...words) => execFileSync(command, words, { cwd: project, encoding: "utf8" });

/** A scene of each dimension, as text: the same in every program of this test. */
const SCENES = `[1, 2, 3].map((dimension) => ({
  dimension,
  walls: { sides: Array.from({ length: dimension }, () => [0, 1]), restitution: 0.9 },
  rule: { material: "hard", restitution: 0.8 },
  grains: [0.2, 0.7].map((x) => ({
    radius: 0.1, mass: 1, position: Array(dimension).fill(x), velocity: Array(dimension).fill(0.6 - x),
  })),
}))`;
const PROGRAM = `import { createScene } from "carom";
const digests = await Promise.all(${SCENES}.map(async (options) => {
  const scene = await createScene(options);
  scene.advanceTo(5);
  return scene.digest;
}));
console.log(digests.join(" "));
`;

async function expected() {
  const digest = async (/** @type {any} */ options) => {
    const scene = await createScene(options);
    scene.advanceTo(5);
    return scene.digest;
  };
  const scenes = /** @type {object[]} */ (new Function(`return ${SCENES}`)());
  return (await Promise.all(scenes.map(digest))).join(" ");
}

before(() => {
  execFileSync(join(web, "package.sh"), [project]);
  const [packed] = readdirSync(project).filter((name) => name.endsWith(".tgz"));
  writeFileSync(join(project, "package.json"), '{ "name": "user", "private": true, "type": "module" }');
  run("npm", "install", "--silent", "--no-audit", "--no-fund", "--offline", `./${packed}`);
  writeFileSync(join(project, "main.js"), PROGRAM);
});
after(() => rmSync(project, { recursive: true, force: true }));

test("the package runs in Node with the same bits", async () => {
  assert.equal(run(process.execPath, "main.js").trim(), await expected());
});

test("a bundler finds the modules, and the bundle has the same bits", async () => {
  const config = `export default {
    base: "./", logLevel: "error",
    build: { target: "esnext", assetsInlineLimit: 0, rollupOptions: { input: "main.js" } },
  };`;
  writeFileSync(join(project, "vite.config.js"), config);
  run(bin("vite"), "build");
  const assets = readdirSync(join(project, "dist", "assets"));
  assert.equal(assets.filter((name) => name.endsWith(".wasm")).length, 4, assets.join(" "));
  const [bundle] = assets.filter((name) => name.endsWith(".js"));
  assert.equal(run(process.execPath, join("dist", "assets", bundle)).trim(), await expected());
});

test("TypeScript finds the types, and what is wrong with a scene", () => {
  const right = `import { createScene, type Scene } from "carom";
const scene: Scene = await createScene({ rule: { material: "hard", restitution: 1 }, grains: [] });
export const time: number = scene.time;
`;
  writeFileSync(join(project, "right.ts"), right);
  writeFileSync(join(project, "wrong.ts"), right.replace('"hard"', '"soft"'));
  const check = (/** @type {string} */ resolution, /** @type {string} */ file) => {
    const module = resolution === "bundler" ? "esnext" : "nodenext";
    return run(bin("tsc"), "--noEmit", "--strict", "--target", "es2023", "--lib", "es2023,dom",
      "--module", module, "--moduleResolution", resolution, file);
  };
  for (const resolution of ["bundler", "nodenext"]) {
    check(resolution, "right.ts");
    assert.throws(() => check(resolution, "wrong.ts"), (/** @type {any} */ error) => /"soft"/.test(error.stdout));
  }
});
