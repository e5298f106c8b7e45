// While the server works at what a form asked for: how long already, and what ends it.
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
  panel.append(words, end);
  document.body.append(panel);
  told = { panel, timer: setInterval(tell, PERIOD) };
  tell();
});
addEventListener("pageshow", rest);
