// Show how far a study is, until it is done.
const panel = document.getElementById("study");
const PERIOD = 1000; // ms

async function follow() {
  try {
    const answer = await fetch(`/progress/${encodeURIComponent(panel.dataset.name)}`);
    panel.innerHTML = await answer.text();
    if (panel.querySelector("[data-running]")) setTimeout(follow, PERIOD);
  } catch {
    panel.textContent = "The server has ended: run motionbook serve again.";
  }
}

follow();
