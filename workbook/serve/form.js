// The form beside the text: what is entered in a field changes the text, and the text fills the fields.
import { ask, follow, replace } from "./text.js";

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
  if (names(fresh) && names(fresh) === names(form)) form.lastChild.replaceWith(fresh.lastChild);
  else form.replaceChildren(...fresh.childNodes);
  form.scrollTop = top;
  part = form.querySelector("select")?.value ?? part;
  const field = typed && at(typed.path);
  if (!field) return;
  field.focus({ preventScroll: true });
  if (begun) field.value = typed.value;
}

async function show() {
  const words = await ask("/fields", { part });
  if (words !== null) fill(words);
}

async function enter(path, what, value) {
  const words = await ask("/set", { path, do: what, value });
  if (words !== null) replace(words);
}

form.addEventListener("change", (event) => {
  if (event.target.id === "part") {
    part = event.target.value;
    show();
  } else {
    event.target.defaultValue = event.target.value;
    enter(event.target.dataset.path, "Set", event.target.value);
  }
});
form.addEventListener("click", (event) => {
  if (event.target.dataset.do) enter(event.target.dataset.path, event.target.dataset.do, "");
});
follow(show);
