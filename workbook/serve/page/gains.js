// What each single change would gain in the highest rate; a click tries one, and undo takes it back.
import { html, useState } from "./html.js";
import { replaceText, settled } from "./journal.js";
import { Popup } from "./popup.js";
import { post, Refused } from "./server.js";
import * as s from "./state.js";

export function Gains() {
  const [asked, ask] = useState(/** @type {any} */ (null));
  const isNow = asked?.text === s.text.value; // the rows are of no later text
  const opened = async () => {
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
  const isDone = ["OK", "FAIL"].includes(s.verdict.value?.verdict);
  const words = !isNow ? "" : asked.rows ? "No single change gains." : "Working out what each change would gain …";
  const rows = (isNow && asked.rows) || [];
  return html`<${Popup} name="Faster …" title="What would help most: a click tries it, undo takes it back" words=${words} opened=${isDone && opened}
    rows=${rows.map(({ sentence, text }) => [sentence, () => replaceText(text)])} />`;
}
