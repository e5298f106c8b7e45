// The form beside the text: what is entered in a field changes the text, and the text fills the fields.
import { area, ask, follow, replace } from "./text.js";

const form = document.getElementById("form");
let part = "";

function at(path) {
  return [...form.querySelectorAll("input")].find((one) => one.dataset.path === path);
}

/** The names of the parts: while they are the same, the choice of one stays, with the keys that are typed in it. */
function names(parent) {
  return [...parent.querySelectorAll("option[value^='[']")].map((one) => one.text).join("\n");
}

function fill(words) {
  const focused = document.activeElement;
  const typed = form.contains(focused) && focused.dataset.path ? { path: focused.dataset.path, value: focused.value } : null;
  const begun = typed && focused.value !== focused.defaultValue;
  const top = form.scrollTop;
  const fresh = document.createElement("div");
  fresh.innerHTML = words;
  if (names(fresh) && names(fresh) === names(form)) form.lastElementChild.replaceWith(fresh.lastElementChild);
  else form.replaceChildren(...fresh.childNodes);
  form.scrollTop = top;
  part = form.querySelector("select")?.value ?? part;
  const field = typed && at(typed.path);
  if (!field) return;
  field.focus({ preventScroll: true });
  if (begun) field.value = typed.value;
}

async function show() {
  const asked = part;
  const words = await ask("/fields", { part });
  if (words !== null && part === asked) fill(words); // else another part was chosen meanwhile
}

async function enter(path, what, value) {
  const words = await ask("/set", { path, do: what, value });
  if (words === null) return;
  const place = JSON.parse(path);
  if (what === "Add") part = path;
  if (what === "Copy" && place.length === 2) part = next(path);
  replace(words);
}

/** The part behind the last row of a list: that of a copy. */
function next(path) {
  const list = path.slice(0, path.lastIndexOf(" ") + 1);
  return `${list}"${form.querySelectorAll(`option[value^='${list}']`).length}"]`;
}

/** Scroll the text to the part that is shown. */
function turn() {
  const [name, row = 0] = JSON.parse(part);
  const lines = area.value.split("\n");
  const heads = [...lines.keys()].filter((k) => lines[k].startsWith(`[${name}]`) || lines[k].startsWith(`[[${name}]]`));
  area.scrollTop = ((heads[row] ?? 0) / lines.length) * area.scrollHeight;
}

form.addEventListener("change", (event) => {
  if (event.target.id === "part") {
    part = event.target.value;
    show();
    turn();
  } else {
    event.target.defaultValue = event.target.value;
    enter(event.target.dataset.path, "Set", event.target.value);
  }
});
form.addEventListener("click", (event) => {
  if (event.target.dataset.do) enter(event.target.dataset.path, event.target.dataset.do, "");
});
follow(show);
