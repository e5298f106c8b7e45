// Show beside a description what it comes to, as it is typed.
const text = document.getElementById("text");
const panel = document.getElementById("live");
const name = document.querySelector("input[name=name]").value;
const PAUSE = 200; // ms without a key
let edits = 0;
let busy = false;

async function refresh() {
  if (busy) return;
  busy = true;
  let shown;
  do {
    shown = edits;
    try {
      const body = new URLSearchParams({ name, text: text.value });
      const answer = await fetch("/live", { method: "POST", body });
      panel.innerHTML = await answer.text();
    } catch {
      panel.textContent = "The server has ended: run motionbook serve again.";
    }
  } while (shown !== edits);
  busy = false;
}

text.addEventListener("input", () => {
  edits += 1;
  setTimeout(refresh, PAUSE);
});
refresh();
