// Say that the server works at what was asked for: a workbook takes some seconds to build or to verify.
addEventListener("submit", (event) => {
  event.submitter?.classList.add("busy");
});
addEventListener("pageshow", () => {
  for (const one of document.querySelectorAll(".busy")) one.classList.remove("busy");
});
