// The colour of an axis, the same everywhere; those after the sixth are dashed.
export const COLORS = 6;

/** The class that sets an axis' colours as CSS variables: `--color` for lines, `--word` for text. @param {number} index */
export const classOf = (index) => `axis-${index % COLORS}${index >= COLORS ? " dashed" : ""}`;

/** What a CSS variable comes to at an element, for a canvas. @param {Element} element @param {string} name */
export const colorAt = (element, name) => getComputedStyle(element).getPropertyValue(name).trim();

/** Call a function when the system goes over to dark or light colours; returns what ends that. @param {() => void} told */
export function followScheme(told) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", told);
  return () => dark.removeEventListener("change", told);
}

/** A number with three to four digits, as a reader takes it in. @param {number} value */
export function short(value) {
  if (!Number.isFinite(value)) return "–";
  const digits = Math.abs(value) >= 1000 ? 0 : Math.abs(value) >= 100 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
  return String(Number(value.toFixed(digits))).replace("-", "−");
}
