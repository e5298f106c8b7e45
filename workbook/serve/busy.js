// While the server works at what a form asked for: how long already, and what ends it. What a report tells leads to the design.
const PERIOD = 500; // ms
let told = null;

function rest() {
  clearInterval(told?.timer);
  told?.panel.remove();
  told = null;
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
  told = { panel, timer: setInterval(tell, PERIOD) };
  tell();
});
addEventListener("pageshow", rest);

const { design } = document.body.dataset;
for (const { dataset, firstElementChild: cell } of design ? document.querySelectorAll("[data-at]") : []) {
  const href = `/edit/${encodeURIComponent(design)}?at=${encodeURIComponent(dataset.at)}`;
  cell.replaceChildren(Object.assign(document.createElement("a"), { href, textContent: cell.textContent, title: `in ${design}` }));
}
