// Every figure gets its buttons and, over a grid, its reader. The page is complete without this script.
// 300 dots an inch, and the file says so: the chunk pHYs before the first IDAT.
const dotsPerInch = 300, fineness = dotsPerInch / 96;
const crcOf = (bytes) => {
  let crc = -1;
  for (const byte of bytes) { crc ^= byte; for (let k = 0; k < 8; ++k) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1; }
  return ~crc >>> 0;
};
const withResolution = async (blob) => {
  const header = 33, bytes = new Uint8Array(await blob.arrayBuffer()), chunk = new DataView(new ArrayBuffer(21)), perMetre = Math.round(dotsPerInch / 0.0254);
  chunk.setUint32(0, 9); chunk.setUint32(4, 0x70485973); chunk.setUint32(8, perMetre); chunk.setUint32(12, perMetre); chunk.setUint8(16, 1);
  chunk.setUint32(17, crcOf(new Uint8Array(chunk.buffer, 4, 13)));
  return new Blob([bytes.subarray(0, header), chunk.buffer, bytes.subarray(header)], { type: "image/png" });
};
const pngOf = (picture) => new Promise((resolve, reject) => {
  const image = new Image(), width = Number(picture.getAttribute("width")), height = Number(picture.getAttribute("height"));
  image.onload = () => {
    const canvas = newCanvas(Math.round(fineness * width), Math.round(fineness * height));
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => withResolution(blob).then(resolve, reject), "image/png");
  };
  image.onerror = reject;
  image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(new XMLSerializer().serializeToString(picture));
});

const newChart = (figure, data, layer) => ({ figure, data, layer, column: data.start[0], row: data.start[1], choose: () => {}, changed: () => {},
  xs: data.x.values.map((v) => position(data.x, v)), ys: data.y.values.map((v) => position(data.y, v)) });

const preparePanels = (figure, data) => data.areas.forEach((area, n) => {
  const points = data.x.values.length * data.y.values.length, place = data.places[n];
  const held = data.up ? [[data.across, place.across], [data.up, place.up]] : [[data.across, place.across]];
  const part = (values) => values.subarray(n * points, (n + 1) * points), layer = { held, field: part(data.field), class: part(data.class) };
  const chart = newChart(figure, data, layer);
  addReader(chart, area, "the map at " + held.map(([axis, value]) => axis.name + " " + withUnit(value, axis)).join(" and "));
  if (data.command) addPlace(chart);
});

const prepareGrid = async (figure, data) => {
  const chart = newChart(figure, data, null);
  addReader(chart, data.area, "the chart");
  if (data.motions) {
    const { motions } = data, places = await doubles(motions.places);
    motions.places = motions.lengths.map((_, n) => [places[2 * n], places[2 * n + 1]]);
    motions.time = await floats(motions.time);
    motions.velocity = await floats(motions.velocity);
  }
  if (data.depth) {
    const { depth } = data;
    await unpackAxis(depth.axis);
    depth.field = await floats(depth.field);
    depth.class = await codes(depth.class);
    depth.colours = await codes(depth.colours);
    for (const layer of depth.curves) for (const curve of layer) curve.points = await floats(curve.points);
    addSlider(chart);
  }
  if (data.command) addPlace(chart);
};

// The picture with letters of the reader's own typeface in place of outlines: to be searched and edited.
const withText = (picture) => {
  const copy = picture.cloneNode(true);
  for (const path of copy.querySelectorAll("path[data-text]")) {
    const { text, size, bold, angle } = path.dataset, letters = document.createElementNS("http://www.w3.org/2000/svg", "text");
    letters.textContent = text;
    const turned = angle ? ` rotate(${-Number(angle)})` : "";
    const given = { transform: path.getAttribute("transform") + turned, fill: path.getAttribute("fill"), "font-size": size,
      "font-family": "DejaVu Sans, Verdana, sans-serif", style: "white-space: pre", ...(bold === undefined ? {} : { "font-weight": "bold" }) };
    for (const name of ["stroke", "stroke-width"])  // of the white edge around letters on a field
      if (path.hasAttribute(name)) given[name] = path.getAttribute(name);
    for (const [name, value] of Object.entries(given)) letters.setAttribute(name, value);
    path.replaceWith(letters);
  }
  return copy;
};

const prepare = async (figure) => {
  const source = figure.querySelector('script[type="application/json"]');
  const tools = figure.querySelector(".tools"), picture = figure.querySelector(".sheet > svg");
  const button = (label, action) => {
    const made = tools.appendChild(element("button", { type: "button" }, label));
    made.addEventListener("click", action);
    return made;
  };
  if (source) {
    const data = await unpack(JSON.parse(source.textContent));
    prepared.push(data);
    if (data.kind === "lines" && data.area && picture) addLineReader(figure, data);
    if (data.kind === "grid" && data.area && picture) await prepareGrid(figure, data);
    if (data.areas && picture) preparePanels(figure, data);
    if (data.surface && picture) addTurning(figure, data, button);
    if (data.played && data.yAxis) addPlayer(figure, data);
    if (data.kind === "lines" && picture) addZoom(figure, data, button);
    button("Data (CSV)", () => save(figure.id + ".csv", "text/csv", csvFile(data)));
  }
  if (!picture) return;
  button("Picture (SVG)", () => save(figure.id + ".svg", "image/svg+xml", new XMLSerializer().serializeToString(picture)));
  button("SVG with text", () => save(figure.id + ".svg", "image/svg+xml", new XMLSerializer().serializeToString(withText(picture))));
  button("Picture (PNG)", async () => save(figure.id + ".png", "image/png", await pngOf(picture)));
  button("Print or PDF", () => printAlone(figure));
};

// One figure on a sheet of its own, which every browser prints or saves as PDF with its text as text.
const printAlone = (figure) => {
  const done = () => { document.documentElement.classList.remove("one-figure"); figure.classList.remove("chosen"); };
  document.documentElement.classList.add("one-figure");
  figure.classList.add("chosen");
  window.addEventListener("afterprint", done, { once: true });
  window.print();
};

// Text to take along: copied, or saved under its name.
const prepareSnippet = (box) => {
  const text = box.querySelector("pre"), tools = box.appendChild(element("div", { class: "tools" }));
  const button = (label, action) => tools.appendChild(element("button", { type: "button" }, label)).addEventListener("click", action);
  button("Copy", () => {
    getSelection().selectAllChildren(text);
    if (navigator.clipboard) navigator.clipboard.writeText(text.textContent).catch(() => {});
  });
  if (box.dataset.file) button("Save " + box.dataset.file, () => save(box.dataset.file, "text/plain", text.textContent));
};

const prepareContents = () => {
  // The contents show where the reader is: at the first part that has come to the upper third of the window.
  const links = new Map([...document.querySelectorAll("nav a")].map((a) => [a.getAttribute("href").slice(1), a]));
  const visible = new Set();
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries) entry.isIntersecting ? visible.add(entry.target.id) : visible.delete(entry.target.id);
    const here = [...links.keys()].find((id) => visible.has(id));
    if (here === undefined) return;
    for (const [id, link] of links) id === here ? link.setAttribute("aria-current", "true") : link.removeAttribute("aria-current");
  }, { rootMargin: "0px 0px -70% 0px" });
  for (const id of links.keys()) {
    const target = document.getElementById(id);
    if (target) seen.observe(target);
  }
};

// The units in which values are read off the charts: SI, or those of a workshop.
const prepareUnits = () => {
  const select = element("select", { id: "units" }, element("option", { value: "" }, "SI"), element("option", { value: "workshop" }, "°, mm, rpm"));
  document.querySelector("nav").append(element("label", { class: "units", for: "units" }, "Values read off charts in ", select));
  select.addEventListener("change", () => {
    readingUnits = select.value ? workshopUnits : {};
    for (const slider of document.querySelectorAll("input[type=range]")) slider.dispatchEvent(new Event("input"));
  });
};

// Spreadsheets that guess an encoding take UTF-8 for what it is behind a byte-order mark only.
const BYTE_ORDER_MARK = "\ufeff";
const csvFile = (data) => (document.getElementById("csv-mark").checked ? BYTE_ORDER_MARK : "") + csv(data);
const prepareMark = () => {
  const box = element("input", { type: "checkbox", id: "csv-mark" });
  document.querySelector("nav").append(element("label", { class: "units", for: "csv-mark" }, box, " CSV for Excel (with a byte-order mark)"));
};

prepareContents();
prepareUnits();
prepareMark();
prepareWidths();
for (const box of document.querySelectorAll(".snippet")) prepareSnippet(box);
Promise.all([...document.querySelectorAll("figure[id]")].map(prepare)).then(() => { document.documentElement.dataset.ready = "true"; });
