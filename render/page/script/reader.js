// What is said of a grid point. `chart` = { figure, data, layer, xs, ys, column, row, area, choose }; `layer` holds the values of another slice, if any.
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
    if (Number.isNaN(value) && (chart.layer || !data.none)) continue;
    if (value === 0 && reading.hides_zero) continue;
    const text = Number.isNaN(value) ? data.none : withUnit(value, reading);
    lines.push(line(reading.name + " = " + text + signWord(reading, value)));
  }
  return lines;
};

const placeOver = (made, [left, top, width, height]) =>
  Object.assign(made.style, { left: left * 100 + "%", top: top * 100 + "%", width: width * 100 + "%", height: height * 100 + "%" });

// A frame over a data area: the pointer or the arrow keys move a cursor, the box beside it says the values there.
// `cursor` = { point(across, up, frame), step(right, up, far), place() → [across, up], readOut(), choose() }.
const addFrame = (figure, where, label, cursor) => {
  const sheet = figure.querySelector(".sheet"), area = element("div", { class: "reader", tabindex: "0", role: "application", "aria-label": label });
  const tip = element("div", { class: "tip", role: "status" });
  const upright = area.appendChild(element("div", { class: "upright" }));
  const level = area.appendChild(element("div", { class: "level" }));
  placeOver(area, where);
  sheet.append(area, tip);

  const show = () => {
    const [across, up] = cursor.place();
    upright.style.left = across * 100 + "%";
    level.style.top = (1 - up) * 100 + "%";
    tip.replaceChildren(...cursor.readOut());
    area.classList.add("on");
    tip.classList.add("on");
    const frame = area.getBoundingClientRect(), page = sheet.getBoundingClientRect(), { scrollLeft, clientWidth } = sheet.parentElement;
    let x = frame.left - page.left + across * frame.width + 14, y = frame.top - page.top + (1 - up) * frame.height + 14;
    // within what a narrow screen shows of the picture
    if (x + tip.offsetWidth > scrollLeft + clientWidth) x -= tip.offsetWidth + 28;
    if (y + tip.offsetHeight > page.height) y -= tip.offsetHeight + 28;
    tip.style.left = Math.max(scrollLeft, Math.min(x, scrollLeft + clientWidth - tip.offsetWidth)) + "px";
    tip.style.top = Math.max(0, y) + "px";
  };
  const hide = () => { area.classList.remove("on"); tip.classList.remove("on"); };
  const point = (event) => {
    const frame = area.getBoundingClientRect();
    cursor.point((event.clientX - frame.left) / frame.width, 1 - (event.clientY - frame.top) / frame.height, frame);
    show();
  };
  area.addEventListener("pointermove", point);
  area.addEventListener("pointerdown", point);
  area.addEventListener("click", () => cursor.choose());
  area.addEventListener("pointerleave", (event) => { if (event.pointerType === "mouse") hide(); });
  area.addEventListener("focus", () => { if (area.matches(":focus-visible")) show(); });
  area.addEventListener("blur", hide);
  area.addEventListener("keydown", (event) => {
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (event.key === "Escape") hide();
    if (event.key === "Enter" || event.key === " ") { event.preventDefault(); cursor.choose(); }
    if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    cursor.step(move[0], move[1], event.shiftKey);
    show();
  });
  return area;
};

const addReader = (chart, where, name) => {
  const within = (count, n) => Math.max(0, Math.min(count - 1, n));
  const put = (column, row) => Object.assign(chart, { column: within(chart.xs.length, column), row: within(chart.ys.length, row) });
  const label = `Values of ${name}: arrow keys move by one grid point, with Shift by ten; Enter chooses the place; Escape leaves`;
  chart.area = addFrame(chart.figure, where, label, {
    point: (across, up) => put(nearest(chart.xs, across), nearest(chart.ys, up)),
    step: (right, up, far) => put(chart.column + (far ? 10 : 1) * right, chart.row + (far ? 10 : 1) * up),
    place: () => [chart.xs[chart.column], chart.ys[chart.row]],
    readOut: () => readOut(chart),
    choose: () => chart.choose(),
  });
};
