// The text of a description: whatever changes it goes through here, is shown, and can be undone.
export const area = document.getElementById("text");
const name = document.querySelector("input[name=name]").value;
const said = document.getElementById("said");
const buttons = { [-1]: document.getElementById("undo"), [1]: document.getElementById("redo") };
const SHOWN = 150; // ms after a change
const KEPT = 500; // ms without a change: a step that can be undone
const history = [area.value];
const followers = [];
let at = 0;
let showing = null;
let keeping = null;

/** Post fields with the text; return the answer's text, null where it was refused, which is told. */
export async function ask(address, fields = {}) {
  try {
    const answer = await fetch(address, { method: "POST", body: new URLSearchParams({ name, text: area.value, ...fields }) });
    const words = await answer.text();
    const page = answer.ok ? null : new DOMParser().parseFromString(words, "text/html");
    said.textContent = page ? (page.querySelector("pre") ?? page.body).textContent : "";
    return answer.ok ? words : null;
  } catch {
    said.textContent = "The server has ended: run motionbook serve again.";
    return null;
  }
}

/** Call a function now and after each change; a change while it works calls it once more. */
export function follow(show) {
  let busy = false;
  let again = false;
  const run = async () => {
    again = true;
    if (busy) return;
    busy = true;
    while (again) {
      again = false;
      await show();
    }
    busy = false;
  };
  followers.push(run);
  run();
}

/** Show a change; it can be undone as one step with those around it, unless more of the same is to come. */
export function changed(whole = true) {
  showing ??= setTimeout(show, SHOWN);
  clearTimeout(keeping);
  if (whole) keeping = setTimeout(keep, KEPT);
  enable();
}

export function replace(words) {
  area.value = words;
  changed();
}

function show() {
  showing = null;
  followers.forEach((run) => run());
}

function keep() {
  clearTimeout(keeping);
  if (area.value !== history[at]) {
    history.splice(at + 1, history.length, area.value);
    at += 1;
  }
  enable();
}

function enable() {
  buttons[-1].disabled = at === 0 && area.value === history[0];
  buttons[1].disabled = at + 1 === history.length;
}

function go(step) {
  keep();
  if (history[at + step] === undefined) return;
  at += step;
  area.value = history[at];
  enable();
  show();
}

for (const step of [-1, 1]) buttons[step].addEventListener("click", () => go(step));
document.addEventListener("keydown", (event) => {
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || (key !== "z" && key !== "y") || event.target.matches("input")) return;
  event.preventDefault();
  go(key === "y" || event.shiftKey ? 1 : -1);
});
enable();
