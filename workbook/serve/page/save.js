// Saving: under its name, or another; a file that changed on disk, a draft that was kept, leaving the page.
import { begin, settled } from "./journal.js";
import { figuresOf, onDisk, opening, post, Refused } from "./server.js";
import { takeActive } from "./fields.js";
import * as s from "./state.js";

const LOOK = 2000; // ms between two looks at the file

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
    document.body.dataset.name = given.name;
    if (given.name !== name) s.book.value = null;
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

function show(opened) {
  s.schema.value = opened.schema;
  s.book.value = opened.book;
  s.file.value = { name: document.body.dataset.name ?? "", target: opened.target, disk: opened.state, saved: opened.saved };
  begin(opened);
}

/** Show the description that the page is of; tell of a draft that was kept. */
export async function openFile() {
  const { study } = document.body.dataset;
  const opened = await opening;
  show(opened);
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
  const given = await figuresOf(saved, axis);
  if (saved !== s.file.value.saved) return;
  const axes = { ...given.axes };
  for (const [k, own] of Object.entries(s.saved.value.axes)) axes[k] = { ...axes[k], charts: axes[k]?.charts ?? own.charts };
  s.saved.value = { axes, machine: given.machine, data: given.data };
}

async function reload() {
  show(await post("/open", { discard: 1 }));
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

