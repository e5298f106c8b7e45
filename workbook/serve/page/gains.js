// What would help most: the single changes that gain, each worked out exactly, to be tried and undone.
import { html, useState } from "./html.js";
import { replaceText, settled } from "./journal.js";
import { post, Refused } from "./server.js";
import * as s from "./state.js";

export function Gains() {
  const [asked, ask] = useState(null);
  const isOpen = asked?.text === s.text.value; // the rows are of no later text
  const open = async () => {
    if (isOpen) return ask(null);
    await settled();
    const text = s.text.value;
    ask({ text, rows: null });
    try {
      const rows = await post("/gains", { text });
      ask((now) => (now?.text === text ? { text, rows } : now));
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      ask(null);
      s.notice.value = { kind: "bad", words: error.message };
    }
  };
  const words = asked?.rows ? "No single change gains." : "Working out what each change would gain …";
  return html`<span class="verdict"><button title="What would help most" aria-expanded=${isOpen} onClick=${open}>Faster …</button>
    ${isOpen && html`<div class="list">${asked.rows?.length ? asked.rows.map(({ sentence, text }) => html`<button key=${sentence} title="Try it; undo takes it back" onClick=${() => replaceText(text)}>${sentence}</button>`) : words}</div>`}</span>`;
}
