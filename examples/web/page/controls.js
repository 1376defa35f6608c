// How is the page operated? Reads sliders, buttons and choices; writes their values as text beside them.

/** @template {HTMLElement} [T=HTMLElement] @param {string} id @returns {T} */
export const find = (id) => /** @type {T} */ (document.getElementById(id));

/** True where the user asked for little motion: nothing moves then until a button is pressed. */
export const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * A slider whose position means `value(position)`, shown as `format(value)`.
 * @param {string} id @param {(x: number) => number} value @param {(x: number) => string} format
 * @param {(x: number) => void} changed
 */
export function slider(id, value, format, changed) {
  const input = /** @type {HTMLInputElement} */ (find(id));
  const output = /** @type {HTMLOutputElement} */ (document.querySelector(`output[for="${id}"]`));
  const update = () => {
    const text = format(value(input.valueAsNumber));
    output.value = text;
    input.setAttribute("aria-valuetext", text);
    const share = (input.valueAsNumber - Number(input.min)) / (Number(input.max) - Number(input.min));
    input.style.setProperty("--filled", `${100 * share}%`);
  };
  input.addEventListener("input", () => {
    update();
    changed(value(input.valueAsNumber));
  });
  update();
  return {
    get value() {
      return value(input.valueAsNumber);
    },
    /** Where the slider stands, not what it means. @param {number} position */
    set(position) {
      input.valueAsNumber = position;
      update();
    },
    update,
  };
}

/** Radio buttons. @param {string} name @param {(value: string) => void} changed */
export function choice(name, changed) {
  const all = /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll(`input[name="${name}"]`));
  for (const input of all) input.addEventListener("change", () => changed(input.value));
  return {
    get value() {
      return [...all].find((input) => input.checked)?.value ?? "";
    },
    /** @param {string} value */
    set(value) {
      for (const input of all) input.checked = input.value === value;
    },
  };
}

/** @param {string} id @param {() => void} action */
export function button(id, action) {
  find(id).addEventListener("click", action);
}

/** A button that plays and pauses. @param {string} id @param {(playing: boolean) => void} [changed] */
export function player(id, changed) {
  const state = { playing: !reducedMotion };
  const update = () => {
    find(id).textContent = state.playing ? "Pause" : "Play";
    find(id).classList.toggle("playing", state.playing);
  };
  button(id, () => {
    state.playing = !state.playing;
    update();
    changed?.(state.playing);
  });
  update();
  return {
    get playing() {
      return state.playing;
    },
    /** @param {boolean} playing */
    set(playing) {
      state.playing = playing;
      update();
    },
  };
}

/** Writes a number where it is shown, if it has changed. @param {string} id @param {string} text */
export function setText(id, text) {
  const element = find(id);
  if (element.textContent !== text) element.textContent = text;
}

/** Text for screen readers, renewed no more often than every other second. */
export function announcer(/** @type {string} */ id) {
  let last = -Infinity;
  return (/** @type {() => string} */ text) => {
    const now = performance.now();
    if (now - last < 2000) return;
    last = now;
    setText(id, text());
  };
}
