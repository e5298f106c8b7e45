// What the page asks the server, in JSON; the description itself at once, while other modules are being loaded.
const { dataset } = document.body; // name: of the file that the page is of

export class Refused extends Error {}
export class Gone extends Refused {}

/** Post fields; return the answer. Throws Refused with the server's sentence, also where a signal ends it. @param {string} address @param {Record<string, any>} fields @param {AbortSignal} [signal] */
export async function post(address, fields = {}, signal) {
  let answer;
  try {
    answer = await fetch(address, {
      method: "POST",
      headers: { Accept: "application/json" },
      body: new URLSearchParams({ name: dataset.name ?? "", ...fields }),
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

/** @type {{of: string, answer: Promise<any>|null}} */
const latest = { of: "", answer: null };

/** All figures of a text, those of an axis with its charts; the latest are not asked for again. @param {string} text @param {number} axis */
export function figuresOf(text, axis) {
  const of = `${axis} ${text}`;
  if (latest.of !== of) Object.assign(latest, { of, answer: post("/figures", { text, axis }) });
  latest.answer?.catch(() => (latest.of = ""));
  return /** @type {Promise<any>} */ (latest.answer);
}

/** Which version of the file is on disk; null where the server does not answer. */
export async function onDisk() {
  try {
    const answer = await fetch(`/state/${encodeURIComponent(dataset.name ?? "")}`);
    return answer.ok ? await answer.text() : null;
  } catch {
    return null;
  }
}

const { study = "", pick = "" } = dataset;
export const opening = post("/open", study ? { study, pick } : {});
opening.catch(() => {}); // whoever waits for it is told
