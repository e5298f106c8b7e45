// Tell of each description in the folder what it comes to, one after the other.
for (const place of document.querySelectorAll("[data-short]")) {
  const answer = await fetch(`/short/${encodeURIComponent(place.dataset.short)}`);
  place.textContent = answer.ok ? await answer.text() : "–";
}
