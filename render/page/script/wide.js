// What is wider than its box fades at the end where there is more. Charts fit a narrow screen whole, small, and are
// enlarged on request.
const tellWidth = (box) => {
  const tell = () => {
    const hidden = box.scrollWidth - box.clientWidth;
    box.classList.toggle("more-before", box.scrollLeft > 1);
    box.classList.toggle("more-after", hidden - box.scrollLeft > 1);
  };
  box.addEventListener("scroll", tell, { passive: true });
  new ResizeObserver(tell).observe(box);
  return tell;
};

const LEGIBLE = 600;  // px: narrower, the letters of a chart are too small to read without enlarging

const prepareWidths = () => {
  for (const table of document.querySelectorAll(".table")) tellWidth(table);
  for (const stage of document.querySelectorAll(".stage")) {
    const tell = tellWidth(stage);
    const row = element("p", { class: "fit", hidden: "" });
    const button = row.appendChild(element("button", { type: "button", "aria-pressed": "false" }, "Larger"));
    const words = row.appendChild(element("span", {}));
    stage.after(row);
    const show = () => {
      const large = stage.classList.contains("large");
      button.textContent = large ? "Whole chart" : "Larger";
      button.setAttribute("aria-pressed", String(large));
      words.textContent = large ? " ↔ Wider than the screen: move it sideways." : "";
      tell();
    };
    button.addEventListener("click", () => {
      stage.classList.toggle("large");
      show();
    });
    new ResizeObserver(() => { row.hidden = stage.clientWidth >= LEGIBLE; }).observe(stage);
    show();
  }
};
