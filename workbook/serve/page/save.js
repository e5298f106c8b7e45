// Saving: under its name, or another; a file that changed on disk, a draft that was kept, leaving the page.
import { begin, settled } from "./journal.js";
import { onDisk, post, Refused } from "./server.js";
import { takeActive } from "./fields.js";
import * as s from "./state.js";

const LOOK = 2000; // ms between two looks at the file
const SECOND = 1000; // ms

const tell = (words, kind = "bad", actions = []) => {
  s.notice.value = { words, kind, actions };
};

/** Save what is on the page, also what stands in a field; true where it is saved. */
export async function save() {
  takeActive();
  await settled();
  const { name, target, disk } = s.file.value;
  const text = s.text.value;
  try {
    const given = await post("/save", { text, as: target, state: disk });
    s.file.value = { name: given.name, target: given.name, disk: given.state, saved: text };
    s.saved.value = { axes: {}, machine: s.figures.value.machine, data: s.data.value };
    compare();
    if (given.name !== name) history.replaceState(null, "", `/edit/${encodeURIComponent(given.name)}`);
    document.title = given.name;
    s.said.value = `${given.name} is saved, ${new Date().toLocaleTimeString()}`;
    if (s.notice.value?.kind !== "bad") s.notice.value = null;
    else if (s.notice.value.actions?.length) s.notice.value = null;
    return true;
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    const now = await onDisk();
    if (now !== null && now !== disk && target === name) tellChanged(now);
    else tell(error.message);
    return false;
  }
}

/** Save, and build the workbook of what is saved. */
export async function build() {
  if (!(await save())) return;
  const [ending, begun] = [new AbortController(), Date.now()];
  const working = () => {
    const words = `Building the workbook, ${((Date.now() - begun) / 1000).toFixed(0)} s`;
    s.notice.value = { words, kind: "busy", actions: [["cancel", () => ending.abort()]] };
  };
  working();
  const timer = setInterval(working, SECOND);
  try {
    const { book, code, words, written } = await post("/build", {}, ending.signal);
    const link = encodeURIComponent(book);
    const links = code === 2 ? [] : [["Download", `/file/${link}`], ["Verify", "/verify"], ["Controller", `/controller/${link}`]];
    const lines = words.split("\n").filter((line) => !line.startsWith("Built "));
    s.notice.value = { words: `${book}: ${written || "built, all its checks OK"}`, kind: code ? "bad" : "note", lines, links, book };
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    tell(error.message);
  } finally {
    clearInterval(timer);
  }
}

async function open(fields = {}) {
  const opened = await post("/open", fields);
  s.schema.value = opened.schema;
  s.file.value = { name: s.file.value.name, target: opened.target, disk: opened.state, saved: opened.saved };
  begin(opened);
  return opened;
}

/** Open the description that the page is of; tell of a draft that was kept. @param {HTMLElement} body */
export async function openFile(body) {
  const { name = "", study, pick } = body.dataset;
  s.file.value = { ...s.file.value, name };
  const opened = await open(study ? { study, pick } : {});
  if (opened.note && study) tell(opened.note, "note");
  else if (opened.note) tell(opened.note, "note", [["go on with them", () => (s.notice.value = null)], ["throw them away", () => reload()]]);
  compare();
  setInterval(look, LOOK);
  return opened;
}

/** Fetch the figures of the saved design for the chosen axis, which are drawn dashed. */
export async function compare() {
  const { axis } = s.selected.value;
  const { saved } = s.file.value;
  if (s.saved.value.axes[axis]?.charts || saved === "") return;
  const given = await post("/figures", { text: saved, axis });
  if (saved !== s.file.value.saved) return;
  const axes = { ...given.axes };
  for (const [k, own] of Object.entries(s.saved.value.axes)) axes[k] = { ...axes[k], charts: axes[k]?.charts ?? own.charts };
  s.saved.value = { axes, machine: given.machine, data: given.data };
}

async function reload() {
  await open({ discard: 1 });
  s.notice.value = null;
}

async function look() {
  const { disk } = s.file.value;
  const now = await onDisk();
  if (now === null || now === disk || s.file.value.disk !== disk || s.notice.value?.at === now) return;
  tellChanged(now);
}

/** Tell that the file is another; what is kept goes over this state of it alone. @param {string} at */
function tellChanged(at) {
  const keep = () => {
    s.notice.value = null;
    s.file.value = { ...s.file.value, disk: at, saved: "" };
  };
  const differ = async () => {
    const theirs = await (await fetch(`/file/${encodeURIComponent(s.file.value.name)}`)).text();
    s.drawer.value = { theirs: theirs.replaceAll("\r\n", "\n") };
  };
  s.notice.value = {
    at,
    kind: "bad",
    words: `${s.file.value.name} changed on disk since it was opened here.`,
    actions: [["load theirs", reload], ["keep mine", keep], ["see the difference", differ]],
  };
}

addEventListener("beforeunload", (event) => {
  if (s.isChanged.value && s.text.value !== "") event.preventDefault();
});

