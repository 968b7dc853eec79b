// What a chosen place of a chart is: its values, the command that reproduces it, the motion of the nearest simulated node.
const commandFor = (chart) => {
  const { data } = chart;
  const [depth, up] = chart.layer ? chart.layer.held.map(([axis, value]) => value) : [data.depth ? data.depth.axis.values[data.depth.at] : 0];
  const values = { x: data.x.values[chart.column], y: data.y.values[chart.row], depth, up };
  return data.command.replace(/\{(x|y|depth|up)\}/g, (_, name) => String(values[name]));
};

// Data of every chart of the page: motions are simulated on one map and shown beside all charts over the same axes.
const prepared = [];
const sameAxis = (a, b) => a.symbol === b.symbol && a.low === b.low && a.high === b.high;
const motionsFor = ({ data }) =>
  [data, ...prepared].find((other) => other.motions && sameAxis(other.x, data.x) && sameAxis(other.y, data.y));

// The node with a motion that lies nearest on the chart, one of the same class first.
const nearestMotion = (source, across, up) => {
  const xs = source.x.values.map((v) => position(source.x, v)), ys = source.y.values.map((v) => position(source.y, v));
  const classAtPlace = (a, b) => (source.class ? source.class[nearest(ys, b) * xs.length + nearest(xs, a)] : 0);
  const own = classAtPlace(across, up);
  let best = null, least = Infinity;
  source.motions.places.forEach(([x, y], n) => {
    const a = position(source.x, x), b = position(source.y, y);
    const distance = Math.hypot(a - across, b - up) + (classAtPlace(a, b) === own ? 0 : 10);
    if (distance < least) { least = distance; best = n; }
  });
  return best;
};

const drawMotion = (canvas, time, velocity, unit) => {
  const style = getComputedStyle(canvas), width = 520, height = 150, left = 84, right = 8, top = 10, bottom = 34;
  const fine = Math.max(1, window.devicePixelRatio || 1), pen = canvas.getContext("2d");
  canvas.width = width * fine;
  canvas.height = height * fine;
  pen.scale(fine, fine);
  const last = time[time.length - 1], low = Math.min(...velocity), high = Math.max(...velocity), span = high - low || Math.abs(high) || 1;
  const x = (t) => left + (width - left - right) * t / last, y = (v) => height - bottom - (height - top - bottom) * (v - low) / span;
  pen.strokeStyle = pen.fillStyle = style.color;
  pen.font = "12px system-ui, sans-serif";
  pen.strokeRect(left, top, width - left - right, height - top - bottom);
  const kind = { unit, prefix: unit.startsWith("m") };
  pen.textAlign = "right";
  pen.fillText(withUnit(high, kind), left - 6, top + 10);
  pen.fillText(withUnit(low, kind), left - 6, height - bottom);
  pen.textAlign = "left";
  pen.fillText("0", left, height - bottom + 16);
  pen.textAlign = "right";
  pen.fillText("time " + withUnit(last, { unit: "s", prefix: true }), width - right, height - bottom + 16);
  pen.strokeStyle = style.accentColor === "auto" ? style.color : style.accentColor;
  pen.lineWidth = 1.6;
  pen.beginPath();
  time.forEach((t, i) => pen.lineTo(x(t), y(velocity[i])));
  pen.stroke();
};

const addMotion = (chart, panel) => {
  const source = motionsFor(chart);
  if (!source) return;
  const { motions, depth } = source, n = nearestMotion(source, chart.xs[chart.column], chart.ys[chart.row]);
  const from = motions.lengths.slice(0, n).reduce((sum, length) => sum + length, 0), to = from + motions.lengths[n];
  const time = Array.from(motions.time.slice(from, to)), velocity = Array.from(motions.velocity.slice(from, to));
  const [x, y] = motions.places[n], kind = { unit: motions.unit, prefix: motions.unit.startsWith("m") };
  const spoken = `Velocity in time at the nearest simulated node: ${span(Math.min(...velocity), Math.max(...velocity), kind)}.`;
  const canvas = element("canvas", { class: "motion", role: "img", "aria-label": spoken });
  const held = depth ? [", ", ...marked(depth.axis.symbol), " = " + withUnit(depth.axis.values[depth.at], depth.axis)] : [];
  const here = x === chart.data.x.values[chart.column] && y === chart.data.y.values[chart.row] && !chart.layer;
  panel.append(element("p", {}, here ? "Velocity after a small disturbance, simulated at this place:" : "Not simulated at this place. Nearest simulated node: ",
    ...(here ? [] : [...marked(source.x.symbol), " = " + withUnit(x, source.x) + ", ", ...marked(source.y.symbol), " = " + withUnit(y, source.y), ...held,
      "; its velocity after a small disturbance:"])), canvas);
  drawMotion(canvas, time, velocity, motions.unit);
};

const addPlace = (chart) => {
  const { figure } = chart, panel = figure.querySelector(".place") || element("div", { class: "place", "aria-live": "polite", hidden: "" });
  figure.querySelector("figcaption").before(panel);
  // another layer: a place that was chosen is told anew
  chart.changed = () => { if (!panel.hidden) chart.choose(); };
  chart.choose = () => {
    if (!chart.data.command) return;
    const command = commandFor(chart), code = element("code", { tabindex: "0" }, command);
    const copy = element("button", { type: "button" }, "Copy");
    copy.addEventListener("click", () => {
      getSelection().selectAllChildren(code);
      if (navigator.clipboard) navigator.clipboard.writeText(command).catch(() => {});
    });
    panel.replaceChildren(element("div", { class: "values" }, ...readOut(chart)),
      element("p", {}, "Reproduce it in the folder of this page:"), element("div", { class: "command" }, code, copy));
    panel.hidden = false;
    addMotion(chart, panel);
  };
};
