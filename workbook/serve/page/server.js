// What the page asks the server: one thing after the other, so that nothing overtakes; answers in JSON.
import { file } from "./state.js";

export class Refused extends Error {}
export class Gone extends Refused {}

/** Post fields; return the answer. Throws Refused with the server's sentence, also where a signal ends it. @param {string} address @param {Record<string, any>} fields @param {AbortSignal} [signal] */
export async function post(address, fields = {}, signal) {
  let answer;
  try {
    answer = await fetch(address, {
      method: "POST",
      headers: { Accept: "application/json" },
      body: new URLSearchParams({ name: file.value.name, ...fields }),
      signal,
    });
  } catch {
    if (signal?.aborted) throw new Refused("Cancelled.");
    throw new Gone("The server has ended: run motionbook serve again. Nothing here is lost while this page is open.");
  }
  const words = await answer.text();
  if (!answer.ok) {
    let sentence = words;
    try {
      sentence = JSON.parse(words).error ?? words;
    } catch {
      // a line of text
    }
    throw new Refused(sentence);
  }
  return words ? JSON.parse(words) : null;
}

/** Which version of the file is on disk; null where the server does not answer. */
export async function onDisk() {
  try {
    const answer = await fetch(`/state/${encodeURIComponent(file.value.name)}`);
    return answer.ok ? await answer.text() : null;
  } catch {
    return null;
  }
}
