// The design's own workbook: building it, and what is done with it.
import { html } from "./html.js";
import { save } from "./save.js";
import { post, Refused } from "./server.js";
import * as s from "./state.js";

const SECOND = 1000; // ms

/** Save, and build the workbook of what is saved. */
export async function build() {
  if (!(await save())) return;
  const [ending, begun] = [new AbortController(), Date.now()];
  const working = () => {
    const words = `Building the workbook, ${((Date.now() - begun) / SECOND).toFixed(0)} s`;
    s.notice.value = { words, kind: "busy", actions: [["cancel", () => ending.abort()]] };
  };
  working();
  const timer = setInterval(working, SECOND);
  try {
    const { book, code, words, written } = await post("/build", {}, ending.signal);
    const isBuilt = code !== 2;
    if (isBuilt) s.book.value = { name: book, time: Date.now() / SECOND };
    const lines = words.split("\n").filter((/** @type {string} */ line) => !line.startsWith("Built "));
    const told = `${book}: ${written || "built, all its checks OK"}`;
    s.notice.value = { words: told, kind: code ? "bad" : "note", lines, isBuilt };
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    s.notice.value = { words: error.message, kind: "bad" };
  } finally {
    clearInterval(timer);
  }
}

/** A button that posts fields to a page of the workbook. */
function Go({ to, words, fields }) {
  const sent = Object.entries(fields).map(([name, value]) => html`<input type="hidden" name=${name} value=${value} />`);
  return html`<form action=${to} method="post">${sent}<button>${words}</button></form>`;
}

/** The ways to a book: to the file, its verdict, a controller, and what differs from the design as saved. */
export function BookLinks() {
  const { name } = s.book.value;
  const link = encodeURIComponent(name);
  return html`<a class="button" href=${`/file/${link}`}>Download</a>
    <${Go} to="/verify" words="Verify" fields=${{ name }} />
    <a class="button" href=${`/controller/${link}`}>Controller</a>
    <${Go} to="/compare" words="Compare" fields=${{ old: name, new: s.file.value.name }} />`;
}

/** At the bottom: when the book was built, and the ways to it. */
export function OwnBook() {
  const book = s.book.value;
  if (!book) return null;
  const built = new Date(SECOND * book.time).toLocaleString([], { dateStyle: "short", timeStyle: "short" });
  return html`<span class="book"><span>${book.name}, of ${built}</span><${BookLinks} /></span>`;
}
