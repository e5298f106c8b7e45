// The design page: top, left, middle, right and bottom; the keys that work everywhere.
import { html, render } from "./html.js";
import { BookLinks } from "./book.js";
import { Cards, choosePart, goTo } from "./cards.js";
import { AxisCharts } from "./charts.js";
import { Entries } from "./entries.js";
import { takeActive } from "./fields.js";
import { propose, redo, refigure, undo } from "./journal.js";
import { Picking } from "./picking.js";
import { compare, openFile, save } from "./save.js";
import { Refused } from "./server.js";
import { Bottom } from "./text.js";
import { TimingDiagram } from "./timing.js";
import { Top } from "./top.js";
import * as s from "./state.js";

function Middle() {
  const { axis } = s.selected.value;
  const shown = s.data.value.axes?.[axis];
  const pictures = s.verdict.value?.pictures ?? [];
  if (!s.live.value)
    return html`<main><div class="pictures">${pictures.map((svg) => html`<div class="panel" dangerouslySetInnerHTML=${{ __html: svg }}></div>`)}</div></main>`;
  return html`<main>
    <${TimingDiagram} data=${s.data} figures=${s.figures} saved=${s.saved} selected=${s.selected} cursor=${s.cursor} propose=${propose} />
    ${shown && html`<${AxisCharts} index=${axis} axis=${shown} figures=${s.figures} saved=${s.saved} cursor=${s.cursor} chosen=${s.chosen} />`}
  </main>`;
}

function Notice() {
  const notice = s.notice.value;
  if (!notice) return null;
  const { words, kind, actions = [], lines = [], isBuilt } = notice;
  const isBusy = kind === "busy";
  return html`<div class=${`notice ${kind}`} role=${isBusy ? undefined : "alert"}>
    ${isBusy && html`<progress aria-label="Building"></progress>`}<div>${words}${lines.map((line) => html`<small key=${line}>${line}</small>`)}</div>
    ${actions.map(([name, act]) => html`<button key=${name} onClick=${act}>${name}</button>`)} ${isBuilt && html`<${BookLinks} />`}
    ${!isBusy && html`<button class="close" aria-label="close" onClick=${() => (s.notice.value = null)}>×</button>`}</div>`;
}

function Page() {
  return html`<${Top} /><div class="notices"><${Picking} /><${Notice} /></div><${Cards} /><${Middle} /><${Entries} /><${Bottom} />`;
}

function options(name, words) {
  const list = document.createElement("datalist");
  list.id = `options-${name}`;
  list.append(...words.map((word) => Object.assign(document.createElement("option"), { value: word })));
  document.body.append(list);
}

addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey)) return;
  const key = event.key.toLowerCase();
  if (key === "s") save();
  else if (document.activeElement?.matches("textarea")) return;
  else if (key === "z" || key === "y") {
    takeActive();
    (key === "y" || event.shiftKey ? redo : undo)();
  } else return;
  event.preventDefault();
});

/** Show the page of what was opened. @param {any} opened @param {HTMLElement} page */
function start(opened, page) {
  s.laws.value = opened.laws;
  s.products.value = opened.products;
  for (const entry of opened.schema.flatMap((each) => each.keys)) if (entry.options.length && entry.expected.startsWith("a text")) options(entry.name, entry.options);
  page.replaceChildren();
  render(html`<${Page} />`, page);
  let last = s.selected.value.axis;
  s.selected.subscribe(({ axis }) => {
    if (axis !== last) {
      refigure();
      compare();
    }
    last = axis;
  });
  if (opened.live === false) choosePart({ part: [] }); // a kind of machine without axes of its own
  goTo(new URLSearchParams(location.search).get("at"));
}

const page = /** @type {HTMLElement} */ (document.getElementById("page"));
try {
  start(await openFile(), page);
} catch (/** @type {any} */ error) {
  if (!(error instanceof Refused)) throw error;
  const way = Object.assign(document.createElement("a"), { href: "/", textContent: "All machines" });
  page.firstElementChild?.replaceChildren(`${error.message} `, way);
}
