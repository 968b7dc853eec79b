// What is wider than the screen says so, and fades at the end where there is more.
const tellWidth = (box, hint) => {
  const tell = () => {
    const hidden = box.scrollWidth - box.clientWidth;
    box.classList.toggle("more-before", box.scrollLeft > 1);
    box.classList.toggle("more-after", hidden - box.scrollLeft > 1);
    if (hint) hint.hidden = hidden <= 1;
  };
  box.addEventListener("scroll", tell, { passive: true });
  new ResizeObserver(tell).observe(box);
};

const prepareWidths = () => {
  for (const table of document.querySelectorAll(".table")) tellWidth(table, null);
  for (const stage of document.querySelectorAll(".stage")) {
    const hint = element("p", { class: "sideways", hidden: "" }, "Wider than the screen: move it sideways.");
    stage.after(hint);
    tellWidth(stage, hint);
  }
};
