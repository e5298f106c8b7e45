// The bottom: the text of the description in a drawer, the time of the last figures; lines that differ from a file's.
import { OwnBook } from "./book.js";
import { html, useLayoutEffect, useRef } from "./html.js";
import { replaceText } from "./journal.js";
import * as s from "./state.js";

const PAUSE = 500; // ms without a key, after which the text is a change

/** The lines of two texts: those of both, and those of one alone. */
export function differing(mine, theirs) {
  const [a, b] = [mine.split("\n"), theirs.split("\n")];
  const [inA, inB] = [new Set(a), new Set(b)];
  const rows = [...a.filter((row) => !inB.has(row)).map((row) => ["mine", row]), ...b.filter((row) => !inA.has(row)).map((row) => ["theirs", row])];
  return rows.filter(([, row]) => row.trim());
}

function Text() {
  const place = useRef(null);
  const waiting = useRef(null);
  const take = () => {
    clearTimeout(waiting.current);
    waiting.current = null;
    if (place.current.value !== s.text.value) replaceText(place.current.value);
  };
  useLayoutEffect(() => {
    const isTyping = waiting.current !== null && document.activeElement === place.current;
    if (!isTyping && place.current.value !== s.text.value) place.current.value = s.text.value;
  });
  const onInput = () => {
    clearTimeout(waiting.current);
    waiting.current = setTimeout(take, PAUSE);
  };
  return html`<textarea id="text" ref=${place} aria-label="Description as text" spellcheck=${false} onInput=${onInput} onBlur=${take}></textarea>`;
}

export function Bottom() {
  const isOpen = s.drawer.value;
  const { took } = s.figures.value;
  return html`<footer class=${isOpen ? "open" : ""}>
    ${isOpen?.theirs !== undefined
      ? html`<div class="differ"><h3>Lines that differ</h3>${differing(s.text.value, isOpen.theirs).map(([whose, row]) => html`<pre class=${whose}>${whose === "mine" ? "here: " : "on disk: "}${row}</pre>`)}</div>`
      : isOpen && html`<${Text} />`}
    <div class="foot"><button aria-expanded=${Boolean(isOpen)} onClick=${() => (s.drawer.value = !isOpen)}><b>Text</b> ${s.file.value.name} ${isOpen ? "▾" : "▴"}</button>
      ${s.broken.value && html`<span class="wrong" role="alert">${s.broken.value}; the figures are of the text before</span>`}
      <span class="took">figures of the engine${took ? `, in ${took.toFixed(0)} ms` : ""}</span><span class="sp"></span><span role="status">${s.said.value}</span><${OwnBook} /></div>
  </footer>`;
}
