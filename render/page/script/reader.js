// A frame over the data area: the pointer or the arrow keys choose a grid point, the box beside it says its values.
// `chart` = { figure, data, layer, xs, ys, column, row, area, choose }; `layer` holds the values of another slice, if any.
const valueAt = (chart, reading, k) =>
  chart.layer && reading === chart.data.readings[0] ? chart.layer.field[k] : chart.layer ? NaN : reading.values[k];

const classAt = (chart, k) =>
  chart.data.class ? chart.data.classes[(chart.layer ? chart.layer.class : chart.data.class)[k]] : null;

const signWord = (reading, value) =>
  reading.name !== "max Re s" || Number.isNaN(value) ? "" : value < 0 ? " (decays)" : " (grows)";

// The lines of a read-out, the same in the box beside the pointer and in the panel of a chosen place.
const readOut = (chart) => {
  const { data } = chart, k = chart.row * chart.xs.length + chart.column, named = classAt(chart, k);
  const line = (...parts) => element("div", {}, ...parts);
  const lines = named ? [element("b", {}, named.text)] : [];
  lines.push(line(...marked(data.x.symbol), " = " + withUnit(data.x.values[chart.column], data.x)));
  lines.push(line(...marked(data.y.symbol), " = " + withUnit(data.y.values[chart.row], data.y)));
  for (const [axis, value] of chart.layer ? chart.layer.held : []) lines.push(line(...marked(axis.symbol), " = " + withUnit(value, axis)));
  for (const reading of data.readings) {
    const value = valueAt(chart, reading, k);
    if (chart.layer && Number.isNaN(value)) continue;
    const text = Number.isNaN(value) && data.none ? data.none : withUnit(value, reading);
    lines.push(line(reading.name + " = " + text + signWord(reading, value)));
  }
  return lines;
};

const placeOver = (made, [left, top, width, height]) =>
  Object.assign(made.style, { left: left * 100 + "%", top: top * 100 + "%", width: width * 100 + "%", height: height * 100 + "%" });

const addReader = (chart, where, name) => {
  const { figure } = chart, sheet = figure.querySelector(".sheet");
  const label = `Values of ${name}: arrow keys move by one grid point, with Shift by ten; Enter chooses the place; Escape leaves`;
  const area = element("div", { class: "reader", tabindex: "0", role: "application", "aria-label": label });
  const tip = element("div", { class: "tip", role: "status" });
  const upright = area.appendChild(element("div", { class: "upright" }));
  const level = area.appendChild(element("div", { class: "level" }));
  placeOver(area, where);
  sheet.append(area, tip);
  chart.area = area;

  const show = (column, row) => {
    chart.column = Math.max(0, Math.min(chart.xs.length - 1, column));
    chart.row = Math.max(0, Math.min(chart.ys.length - 1, row));
    const across = chart.xs[chart.column], up = chart.ys[chart.row];
    upright.style.left = across * 100 + "%";
    level.style.top = (1 - up) * 100 + "%";
    tip.replaceChildren(...readOut(chart));
    area.classList.add("on");
    tip.classList.add("on");
    const frame = area.getBoundingClientRect(), page = sheet.getBoundingClientRect();
    let x = frame.left - page.left + across * frame.width + 14, y = frame.top - page.top + (1 - up) * frame.height + 14;
    if (x + tip.offsetWidth > page.width) x -= tip.offsetWidth + 28;
    if (y + tip.offsetHeight > page.height) y -= tip.offsetHeight + 28;
    tip.style.left = Math.max(0, x) + "px";
    tip.style.top = Math.max(0, y) + "px";
  };
  const hide = () => { area.classList.remove("on"); tip.classList.remove("on"); };
  const point = (event) => {
    const frame = area.getBoundingClientRect();
    show(nearest(chart.xs, (event.clientX - frame.left) / frame.width), nearest(chart.ys, 1 - (event.clientY - frame.top) / frame.height));
  };
  area.addEventListener("pointermove", point);
  area.addEventListener("pointerdown", point);
  area.addEventListener("click", () => chart.choose());
  area.addEventListener("pointerleave", (event) => { if (event.pointerType === "mouse") hide(); });
  area.addEventListener("focus", () => { if (area.matches(":focus-visible")) show(chart.column, chart.row); });
  area.addEventListener("blur", hide);
  area.addEventListener("keydown", (event) => {
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (event.key === "Escape") hide();
    if (event.key === "Enter" || event.key === " ") { event.preventDefault(); chart.choose(); }
    if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const stride = event.shiftKey ? 10 : 1;
    show(chart.column + stride * move[0], chart.row + stride * move[1]);
  });
};
