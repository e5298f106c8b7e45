// What the page shows: signals that its parts read. Only journal.js and server.js set what comes from the server.
import { computed, signal } from "./html.js";

export const file = signal({ name: "", disk: "", target: "", saved: "" }); // disk: which version was opened
export const text = signal("");
export const data = signal({}); // the description as a tree, with what is not answered yet
export const faults = signal({}); // by the key of an entry, what is wrong with it
export const refused = signal({}); // by key: what was typed and could not be taken, and why
export const waiting = signal({}); // by key: what was typed and is not answered yet
export const broken = signal(null); // why the text is no TOML
export const live = signal(true); // whether its axes have figures without a book
export const schema = signal([]);
export const laws = signal([]); // that come with motionbook, with their shapes
export const products = signal({ motor: [], reducer: [] }); // that come with it, with their figures
export const figures = signal({ axes: {}, gaps: {}, machine: null, took: 0 });
export const saved = signal({ axes: {}, machine: null, data: null });
export const verdict = signal(null);
export const book = signal(null); // the design's own: its name, when it was written (s); null where there is none
export const sought = signal(""); // the key of an entry that a report led to
export const selected = signal({ axis: 0, phase: null, part: null }); // part: another table than an axis
export const cursor = signal(null);
export const chosen = signal("both");
export const notice = signal(null); // { words, kind, actions: [[label, function]] } above the page
export const said = signal(""); // for screen readers, and in the footer
export const picked = signal(null); // the entries that a study is to vary, by their keys with their names, while they are chosen
export const steps = signal({ undo: false, redo: false });
export const drawer = signal(false);

export const isChanged = computed(() => text.value !== file.value.saved || file.value.target !== file.value.name);

export const get = (tree, path) => path.reduce((at, part) => at?.[part], tree);
/** Whether an entry is chosen for a study, as an attribute. @param {string} key */
export const isPicked = (key) => Boolean(picked.value?.[key]) || undefined;
export const keyOf = (path) => path.join(".");

/** A copy of a tree with another value at a path. @param {any} tree @param {any[]} path @param {any} value @returns {any} */
export function put(tree, path, value) {
  const [first, ...rest] = path;
  const copy = Array.isArray(tree) ? [...tree] : { ...tree };
  const key = Array.isArray(tree) ? ({ start: 0, stop: 1 }[first] ?? first) : first; // a time as [from, to]
  if (rest.length) copy[key] = put(copy[key] ?? {}, rest, value);
  else if (value === null || value === undefined) delete copy[key];
  else copy[key] = value;
  return copy;
}

/** The period of a description: a turn, with its time at the rate, or a cycle of its own. @param {any} tree */
export function periodOf(tree) {
  const { cycle, rate, unit } = tree?.master ?? {};
  if (cycle > 0) return { unit: unit ?? "s", length: cycle, ms: null };
  return { unit: "°", length: 360, ms: rate > 0 ? 60000 / rate : null };
}

export const period = computed(() => periodOf(data.value));
