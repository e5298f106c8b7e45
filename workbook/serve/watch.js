// Show the verdicts as they come; the tab's title and icon say OK or FAIL.
const now = document.getElementById("now");
const icon = Object.assign(document.createElement("link"), { rel: "icon" });
let held = "";

function show(html) {
  held = html;
  now.innerHTML = html;
  tellTab();
}

function tellTab() {
  const state = now.querySelector("[data-state]").dataset.state;
  document.title = `${state} motionbook watch`.trim();
  if (state) {
    icon.href = state === "OK" ? "/ok.svg" : "/fail.svg";
    document.head.append(icon);
  }
}

async function look() {
  try {
    const html = await (await fetch("/now")).text();
    if (html !== held) show(html);
  } catch {
    document.title = "Ended: motionbook watch";
  }
  setTimeout(look, 500);
}

tellTab();
look();
