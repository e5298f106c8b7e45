// The journal: numbered changes in their order, undo and redo. An answer older than the last change replaces no field.
import { batch } from "./html.js";
import { figuresOf, Gone, post } from "./server.js";
import * as s from "./state.js";

const IDLE = 400; // ms without a change, after which the machine is judged
const history = []; // texts, from that of the begin on
const queue = []; // entries that are not answered yet
let at = 0; // where in the history the text is
let number = 0;
let running = null;
let judging = null;
let judged = Promise.resolve(); // once no verdict is waited for
let preview = null; // changes of a drag that goes on
let previewing = false;

const tell = (error) => {
  s.notice.value = { kind: "bad", words: error.message };
};

/** Begin with what the server opened. */
export function begin(opened) {
  history.splice(0, history.length, opened.text);
  at = 0;
  show(opened);
  refigure();
}

/** Make changes: [{path, value}], or [{path, do: add, copy or remove}]; values as typed are texts. */
export function commit(changes) {
  if (!changes.length) return Promise.resolve();
  const numbers = changes.filter((each) => !each.do && typeof each.value === "number");
  batch(() => {
    s.data.value = numbers.reduce((tree, { path, value }) => s.put(tree, path, value), s.data.value);
    for (const { path, value } of changes.filter((each) => typeof each.value === "string" && !each.do))
      s.waiting.value = { ...s.waiting.value, [s.keyOf(path)]: value };
  });
  preview = null;
  return enqueue({ changes });
}

export const undo = () => enqueue({ step: -1 });
export const redo = () => enqueue({ step: 1 });
export const replaceText = (value) => enqueue({ changes: [{ path: ["text"], do: "text", value }] });

/** Wait until all changes are answered. */
export const settled = () => running ?? Promise.resolve();

function enqueue(entry) {
  number += 1;
  queue.push({ ...entry, number });
  clearTimeout(judging);
  running ??= run().finally(() => {
    running = null;
  });
  return running;
}

async function run() {
  while (queue.length) {
    const entry = queue[0];
    try {
      await answer(entry);
    } catch (error) {
      tell(error);
      if (error instanceof Gone) return; // the entry waits for the next
      batch(() => {
        s.waiting.value = {};
        s.data.value = { ...s.data.value };
      });
    }
    queue.shift();
  }
  s.steps.value = { undo: at > 0, redo: at + 1 < history.length };
  refigure();
}

async function answer(entry) {
  let { changes } = entry;
  if (entry.step) {
    const to = history[at + entry.step];
    if (to === undefined) return;
    changes = [{ path: ["text"], do: "text", value: to }];
  }
  const begun = performance.now();
  const axis = queue.length > 1 ? -1 : s.selected.value.axis; // more is to come: the figures would be overtaken
  const given = await post("/change", { text: s.text.value, changes: JSON.stringify(changes), axis });
  if (entry.step) at += entry.step;
  else if (given.text !== s.text.value) {
    history.splice(at + 1, history.length, given.text);
    at += 1;
  }
  batch(() => {
    note(changes, given.refused);
    show(given, queue.length > 1);
    merge(given, performance.now() - begun);
  });
}

/** Note what was refused of changes, and that the others are answered. */
function note(changes, sentences) {
  const [waits, refuses] = [{ ...s.waiting.value }, { ...s.refused.value }];
  for (const { path, value, do: what } of changes) {
    const key = s.keyOf(path);
    if (waits[key] === value) delete waits[key];
    delete refuses[key];
    if (!sentences[key]) continue;
    if (what) s.notice.value = { kind: "bad", words: sentences[key] };
    else refuses[key] = { typed: value, sentence: sentences[key] };
  }
  s.waiting.value = waits;
  s.refused.value = refuses;
}

function show(given, overtaken = false) {
  s.text.value = given.text;
  s.broken.value = given.error;
  if (given.data === null || overtaken) return; // the last tree stays
  s.data.value = given.data;
  s.faults.value = given.faults;
  s.live.value = given.live;
  const axes = given.data.axes?.length ?? 0;
  if (s.selected.value.axis >= axes) s.selected.value = { ...s.selected.value, axis: Math.max(0, axes - 1), phase: null };
}

/** Take figures: of axes that have none now, the last ones stay. */
function merge(given, took) {
  const before = s.figures.value;
  const names = JSON.stringify((s.data.value?.axes ?? []).map((axis) => axis.name));
  const known = before.names === names || Object.keys(before.axes).length === (s.data.value?.axes?.length ?? 0);
  const axes = known ? { ...before.axes } : {};
  for (const [k, own] of Object.entries(given.axes ?? {})) {
    const keys = own.charts?.map(({ key }) => key) ?? [];
    const last = own.stale ? (axes[k]?.charts ?? []).filter(({ key }) => !keys.includes(key)) : []; // of a faulty drive
    const use = own.stale && !own.use?.length ? axes[k]?.use : own.use;
    axes[k] = { ...axes[k], ...own, use, ...(own.charts && { charts: [...own.charts, ...last] }) };
  }
  const isThere = ([k, { name }]) => s.data.value?.clearances?.[k]?.name === name;
  const stays = Object.entries(before.gaps).filter(isThere).map(([k, gap]) => [k, given.machine ? { ...gap, stale: true } : gap]);
  const gaps = { ...Object.fromEntries(stays), ...given.gaps };
  s.figures.value = { names, axes, gaps, machine: given.machine ?? before.machine, took };
}

/** Ask for all figures, and after a while for the verdict; what is overtaken by a change is dropped. */
export async function refigure() {
  const [of, begun] = [number, performance.now()];
  clearTimeout(judging);
  try {
    const given = await figuresOf(s.text.value, s.selected.value.axis);
    if (of !== number || preview) return;
    batch(() => merge(given, performance.now() - begun));
  } catch (error) {
    return tell(error);
  }
  judging = setTimeout(judge, IDLE, of);
}

/** Ask for the verdict, once that before is there: those that a change overtook are not asked for. */
function judge(of) {
  judged = judged.then(() => askVerdict(of));
}

async function askVerdict(of) {
  if (of !== number) return;
  try {
    const given = await post("/verdict", { text: s.text.value });
    if (of === number) s.verdict.value = given;
  } catch (/** @type {any} */ error) {
    if (of === number) s.verdict.value = { verdict: "unknown", number: 0, checks: [{ sentence: error.message }], pictures: [] };
  }
}

/** What a drag proposes: figures follow it; with ``isDone`` it is a change. */
export function propose(changes, isDone) {
  if (isDone) return commit(changes);
  preview = changes.length ? changes : null;
  if (!preview) refigure();
  else if (!previewing) follow();
}

async function follow() {
  previewing = true;
  while (preview) {
    const shown = preview;
    try {
      const fields = { text: s.text.value, changes: JSON.stringify(shown), axis: s.selected.value.axis, preview: 1 };
      const given = await post("/change", fields);
      if (preview) batch(() => merge({ axes: given.axes, gaps: given.gaps }, 0));
    } catch (error) {
      tell(error);
    }
    if (preview === shown) await new Promise((resolve) => setTimeout(resolve, 30));
    if (preview === shown) break;
  }
  previewing = false;
}
