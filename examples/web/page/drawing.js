// How is something drawn? Reads the theme's colours and sizes; draws on canvases and formats numbers.

/** A canvas that is as sharp as the screen: draws in CSS pixels. @param {HTMLCanvasElement} canvas */
export function surface(canvas) {
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const size = { width: 1, height: 1 };
  const fit = () => {
    const { width, height } = canvas.getBoundingClientRect();
    const scale = Math.min(globalThis.devicePixelRatio || 1, 2);
    Object.assign(size, { width: Math.max(width, 1), height: Math.max(height, 1) });
    const [w, h] = [Math.round(size.width * scale), Math.round(size.height * scale)];
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, size.width, size.height);
    return size;
  };
  return { pen, size, fit };
}

/** @type {Record<string, string>} */
let colours = {};
const NAMES = ["ink", "soft", "faint", "line", "paper", "card", "emd", "star", "md", "cold", "flight", "contact", "cluster", "rest"];

/** Reads the theme's colours anew. */
export function readColours() {
  const style = getComputedStyle(document.documentElement);
  colours = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** A colour of the theme. @param {string} name */
export const colour = (name) => colours[name];

/** Stops of a scale whose lightness grows evenly (viridis). */
const STOPS = [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]];

/** A colour between cold (never too dark for the theme) and warm. @param {number} fraction */
export function scale(fraction) {
  const cold = Number(colours.cold);
  const place = (cold + (0.94 - cold) * Math.min(Math.max(fraction, 0), 1)) * (STOPS.length - 1);
  const k = Math.min(Math.floor(place), STOPS.length - 2);
  const mix = STOPS[k].map((from, i) => Math.round(from + (STOPS[k + 1][i] - from) * (place - k)));
  return `rgb(${mix.join(" ")})`;
}

/** @param {CanvasRenderingContext2D} pen @param {number} x @param {number} y @param {number} radius */
export function circle(pen, x, y, radius) {
  pen.beginPath();
  pen.arc(x, y, Math.max(radius, 0), 0, 2 * Math.PI);
}

/** @param {CanvasRenderingContext2D} pen @param {number[]} from @param {number[]} to @param {number} head */
export function arrow(pen, [ax, ay], [bx, by], head) {
  const turn = Math.atan2(by - ay, bx - ax);
  pen.beginPath();
  pen.moveTo(ax, ay);
  pen.lineTo(bx, by);
  for (const side of [-2.6, 2.6]) {
    pen.moveTo(bx, by);
    pen.lineTo(bx + head * Math.cos(turn + side), by + head * Math.sin(turn + side));
  }
  pen.stroke();
}

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A number with so many digits, as one writes it. @param {number} x @param {number} [digits] */
export function formatNumber(x, digits = 3) {
  if (x === 0 || !Number.isFinite(x)) return String(x);
  const power = Math.floor(Math.log10(Math.abs(x)));
  if (power >= -3 && power < 5) return x.toLocaleString("en", { maximumSignificantDigits: digits });
  const raised = [...String(power)].map((c) => (c === "-" ? "⁻" : SUPERSCRIPTS[Number(c)])).join("");
  return `${(x / 10 ** power).toFixed(Math.max(digits - 2, 0))}·10${raised}`;
}

/** With a unit's prefix. @param {number} x @param {string} unit @param {number} [digits] */
export function si(x, unit, digits = 3) {
  const prefixes = ["n", "µ", "m", "", "k", "M", "G"];
  const k = Math.min(Math.max(Math.floor(Math.log10(Math.abs(x) || 1) / 3 + 1e-9), -3), 3);
  const value = (x / 1000 ** k).toLocaleString("en", { maximumSignificantDigits: digits });
  return `${value} ${prefixes[k + 3]}${unit}`;
}
