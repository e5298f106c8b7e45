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
export const figures = signal({ number: 0, axes: {}, gaps: {}, machine: null, took: 0 });
export const saved = signal({ axes: {}, machine: null, data: null });
export const verdict = signal(null);
export const sought = signal(""); // the key of an entry that a report led to
export const selected = signal({ axis: 0, phase: null, part: null }); // part: another table than an axis
export const cursor = signal(null);
export const chosen = signal("both");
export const notice = signal(null); // { words, kind, actions: [[label, function]] } above the page
export const said = signal(""); // for screen readers, and in the footer
export const steps = signal({ undo: false, redo: false });
export const drawer = signal(false);

export const isChanged = computed(() => text.value !== file.value.saved || file.value.target !== file.value.name);

export const get = (tree, path) => path.reduce((at, part) => at?.[part], tree);
export const keyOf = (path) => path.join(".");

/** A copy of a tree with another value at a path. @param {any} tree @param {any[]} path @param {any} value @returns {any} */
export function put(tree, path, value) {
  const [first, ...rest] = path;
  const copy = Array.isArray(tree) ? [...tree] : { ...tree };
  if (rest.length) copy[first] = put(copy[first] ?? {}, rest, value);
  else if (value === null || value === undefined) delete copy[first];
  else copy[first] = value;
  return copy;
}

const number = (value) => (typeof value === "number" ? value : null);

/** A description as the drawing parts take it. @param {any} tree */
export function designOf(tree) {
  const master = tree?.master ?? {};
  const [length, rate] = [number(master.cycle) ?? 360, number(master.rate)];
  const isTurn = number(master.cycle) === null;
  const ms = isTurn && rate && rate > 0 ? 60000 / rate : null; // of a turn
  const period = { name: "cycle", unit: isTurn ? "°" : (master.unit ?? "s"), length, ms };
  const axes = (tree?.axes ?? []).map((axis, index) => ({
    index,
    name: axis.name ?? `axis ${index + 1}`,
    group: axis.group ?? "",
    unit: axis.unit ?? "mm",
    shift: number(axis.shift) ?? 0,
    shown: true,
    phases: (axis.phases ?? []).map((phase, at) => ({
      index: at,
      from: number(phase.start),
      to: number(phase.stop),
      lift: number(phase.lift) ?? 0,
      law: phase.law ?? "DWL",
      law_name: phase.law ?? "dwell",
    })),
  }));
  const ends = (on) => (Array.isArray(on) ? on : [on?.start, on?.stop]);
  const bars = (tree?.switches ?? []).map((each, index) => ({
    path: ["switches", index, "on"],
    axis: null,
    name: each.name ?? `switch ${index + 1}`,
    on: (each.on ?? []).map(ends),
  }));
  for (const [index, { name, load }] of (tree?.axes ?? []).entries())
    if (load?.windows?.length) bars.push({ path: ["axes", index, "load", "windows"], axis: index, name: `${name} force`, on: load.windows.map(ends) });
  return { title: tree?.title ?? "", period, axes, bars };
}

export const design = computed(() => designOf(data.value));
export const savedDesign = computed(() => designOf(saved.value.data));
