// Long time series can be looked into: dygraphs (inlined where a page has one) in place of the printed picture.
// as in the printed picture; the two blues are lighter on a dark page, as page.css has them
const penColours = () => (matchMedia("(prefers-color-scheme: dark)").matches
  ? ["#4a9fe0", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#a3dbff"]
  : ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]);

const sharedRows = (lines) => {
  const rows = new Map();
  lines.forEach((line, n) => line.x.forEach((x, i) => {
    if (!rows.has(x)) rows.set(x, [x, ...lines.map(() => null)]);
    rows.get(x)[n + 1] = line.y[i];
  }));
  return [...rows.values()].sort((a, b) => a[0] - b[0]);
};

const addZoom = (figure, data, button) => {
  if (!data.zoom || typeof Dygraph === "undefined") return;
  const picture = figure.querySelector(".sheet > svg"), box = element("div", { class: "zoom", hidden: "" });
  const values = element("p", { class: "zoom-values", role: "status", hidden: "" }, "");
  picture.after(box, values);
  let graph = null;
  const name = data.inTime ? "Zoom in time" : "Zoom in";
  const toggle = button(name, () => {
    const open = box.hidden;
    box.hidden = values.hidden = !open;
    picture.classList.toggle("away", open);
    for (const part of figure.querySelectorAll(".reader, .tip")) part.hidden = open;
    toggle.textContent = open ? "Back to the picture" : name;
    if (graph || !open) return;
    const say = (x, points) => (values.textContent = x === null ? "Drag to zoom, double-click to see all; the strip below chooses a stretch."
      : `${data.xLabel} ${digits(x)}: ` + points.map((p) => `${p.name} = ${digits(p.yval)}`).join(", "));
    const ink = getComputedStyle(document.documentElement).getPropertyValue("--muted");
    // its legend writes style attributes, which the page's policy forbids; the values stand below instead
    Dygraph.PLUGINS = Dygraph.PLUGINS.filter((plugin) => plugin !== Dygraph.Plugins.Legend);
    const colours = penColours();
    graph = new Dygraph(box, sharedRows(data.lines), {
      labels: ["x", ...data.lines.map((line) => line.name)], xlabel: data.xLabel, ylabel: data.yLabel,
      colors: data.lines.map((line, i) => colours[(line.place ?? i) % colours.length]), strokeWidth: 1.5, connectSeparatedPoints: true,
      legend: "never", showRangeSelector: true, rangeSelectorPlotStrokeColor: colours[0], rangeSelectorPlotFillColor: "#9cc7e6",
      axisLineColor: ink, gridLineColor: "#8886", height: 380, axisLabelFontSize: 12, logscale: data.yLog,
      highlightCallback: (event, x, points) => say(x, points), unhighlightCallback: () => say(null),
      axes: { x: { valueFormatter: digits, axisLabelFormatter: digits }, y: { valueFormatter: digits, axisLabelFormatter: digits, axisLabelWidth: 74 } },
    });
    say(null);
  });
};
