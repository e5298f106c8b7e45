// On every page but the design page: how long the server works already and what ends that, parts that come later,
// and what a report tells of entries leads to the design.
const PERIOD = 500; // ms
let working = null;

function rest() {
  clearInterval(working?.timer);
  working?.panel.remove();
  working = null;
}

function cancel() {
  stop(); // the server ends what it runs for a page that nobody waits for
  rest();
}

addEventListener("submit", (event) => {
  rest();
  const begun = Date.now();
  const panel = Object.assign(document.createElement("div"), { className: "busy" });
  const words = Object.assign(document.createElement("span"), { role: "status" });
  const end = Object.assign(document.createElement("button"), { type: "button", textContent: "Cancel", onclick: cancel });
  const name = (event.submitter?.textContent ?? "").trim();
  const tell = () => (words.textContent = `${name} … ${((Date.now() - begun) / 1000).toFixed(0)} s`);
  panel.append(document.createElement("progress"), words, end);
  document.body.append(panel);
  working = { panel, timer: setInterval(tell, PERIOD) };
  tell();
});
addEventListener("pageshow", rest);

const { design } = document.body.dataset;
for (const { dataset, firstElementChild: cell } of design ? document.querySelectorAll("[data-at]") : []) {
  const href = `/edit/${encodeURIComponent(design)}?at=${encodeURIComponent(dataset.at)}`;
  cell.replaceChildren(Object.assign(document.createElement("a"), { href, textContent: cell.textContent, title: `in ${design}` }));
}

/** Fetch a part of the page, again and again while it is not the last of it; the tab says OK or FAIL where it has a state. */
async function follow(place, before) {
  const answer = await fetch(place.dataset.from).catch(() => null); // null: the server has ended, or the page is left
  if (!answer && before) [place.textContent, document.title] = ["The server has ended: run motionbook again.", "Ended: motionbook"];
  const html = answer?.ok ? await answer.text() : before;
  if (answer?.ok && html !== before && !place.matches(":active")) {
    const had = place.contains(document.activeElement);
    place.innerHTML = html;
    if (had) place.querySelector("button")?.focus();
  }
  const { state, again } = place.querySelector("[data-again]")?.dataset ?? {};
  if (state) {
    document.title = `${state} motionbook watch`;
    document.head.append(Object.assign(document.querySelector("link[rel=icon]") ?? document.createElement("link"), { rel: "icon", href: `/${state}.svg` }));
  }
  if (again !== undefined) setTimeout(follow, PERIOD, place, html);
}

for (const place of document.querySelectorAll("[data-from]")) await follow(place);
