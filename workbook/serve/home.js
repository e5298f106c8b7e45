// Tell of each description in the folder what it comes to, one after the other; what is known stands there already.
for (const place of document.querySelectorAll("[data-brief]")) {
  const answer = await fetch(`/brief/${encodeURIComponent(place.dataset.brief)}`).catch(() => null); // null: cancelled
  if (answer?.ok) place.innerHTML = await answer.text();
}
