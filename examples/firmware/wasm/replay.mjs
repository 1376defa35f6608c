// Which digests does WebAssembly get in Node? Reads the module's path and, if asked, a scene, a scalar and a range; prints lines.
import { readFile } from "node:fs/promises";

const [path, scene, scalar, from, last] = process.argv.slice(2);
const scalars = ["f32", "f64", "I32F32"];
const { instance } = await WebAssembly.instantiate(await readFile(path));
const { run, digest, letter } = instance.exports;

const scenes = [];
for (let name; (name = nameOf(scenes.length)) !== ""; ) scenes.push(name);

function nameOf(scene) {
  const letters = [];
  for (let code; (code = letter(scene, letters.length)) !== 0; ) letters.push(String.fromCharCode(code));
  return letters.join("");
}

function print(scene, scalar, from, last, every) {
  const count = run(scenes.indexOf(scene), scalars.indexOf(scalar), from, last, every);
  if (count < 0) throw new Error(`${scene} in ${scalar}: an error`);
  for (let i = 0; i < count; i++) {
    const hex = BigInt.asUintN(64, digest(i)).toString(16).padStart(16, "0");
    console.log(`${scene} ${scalar} ${from + (i + 1) * every} ${hex}`);
  }
}

if (scene) print(scene, scalar, Number(from), Number(last), 1);
else for (const one of scenes) for (const kind of scalars) print(one, kind, 0, 10_000, 1000);
