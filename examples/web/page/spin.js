// How far has each grain turned? Reads angular velocities; writes a mark on each grain.

import { colour } from "./drawing.js";

/** The angles of a scene's grains, from 0 on. @param {import("./carom.js").Scene} scene */
export function spins(scene) {
  const angles = new Float64Array(scene.rotations.length);
  return {
    angles,
    /** So much simulated time has passed. @param {number} dt */
    turn(dt) {
      for (let i = 0; i < angles.length; i++) angles[i] += scene.rotations[i] * dt;
    },
    /** A mark from the middle of a grain, drawn at (x, y) with this radius, to its rim; none on smooth grains. @param {CanvasRenderingContext2D} pen @param {number} i @param {number} x @param {number} y @param {number} radius @param {number} [turned] how far the picture is turned */
    mark(pen, i, x, y, radius, turned = 0) {
      if (i >= angles.length) return;
      pen.beginPath();
      pen.moveTo(x, y);
      const angle = angles[i] + turned;
      pen.lineTo(x + radius * Math.cos(angle), y - radius * Math.sin(angle));
      Object.assign(pen, { strokeStyle: colour("paper"), lineWidth: Math.max(radius / 3, 1.6), lineCap: "butt" });
      pen.stroke();
    },
  };
}
