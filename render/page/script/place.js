// What a chosen place of a chart is: its values, the command that reproduces it, the motion of the nearest simulated node.
const commandFor = (chart) => {
  const { data } = chart;
  const [depth, up] = chart.layer ? chart.layer.held.map(([axis, value]) => value) : [data.depth ? data.depth.axis.values[data.depth.at] : 0];
  const values = { x: data.x.values[chart.column], y: data.y.values[chart.row], depth, up };
  return data.command.replace(/\{(x|y|depth|up)\}/g, (_, name) => String(values[name]));
};

// The node with a motion that lies nearest on the chart, one of the same class first.
const nearestMotion = (chart) => {
  const { data } = chart, across = chart.xs[chart.column], up = chart.ys[chart.row];
  const classOf = (i, j) => (data.class ? data.class[j * chart.xs.length + i] : 0);
  const own = classOf(chart.column, chart.row);
  let best = null, least = Infinity;
  data.motions.places.forEach(([x, y], n) => {
    const a = position(data.x, x), b = position(data.y, y);
    const other = classOf(nearest(chart.xs, a), nearest(chart.ys, b)) === own ? 0 : 10;
    const distance = Math.hypot(a - across, b - up) + other;
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
  const { data } = chart, { motions } = data, n = nearestMotion(chart);
  const from = motions.lengths.slice(0, n).reduce((sum, length) => sum + length, 0), to = from + motions.lengths[n];
  const time = Array.from(motions.time.slice(from, to)), velocity = Array.from(motions.velocity.slice(from, to));
  const [x, y] = motions.places[n], kind = { unit: motions.unit, prefix: motions.unit.startsWith("m") };
  const spoken = `Velocity in time at the nearest simulated node: between ${withUnit(Math.min(...velocity), kind)} and ${withUnit(Math.max(...velocity), kind)}.`;
  const canvas = element("canvas", { class: "motion", role: "img", "aria-label": spoken });
  panel.append(element("p", {}, "Velocity after a small disturbance at the nearest simulated node, ",
    ...marked(data.x.symbol), " = " + withUnit(x, data.x) + ", ", ...marked(data.y.symbol), " = " + withUnit(y, data.y) + ":"), canvas);
  drawMotion(canvas, time, velocity, motions.unit);
};

const addPlace = (chart) => {
  const { figure } = chart, panel = figure.querySelector(".place") || element("div", { class: "place", "aria-live": "polite", hidden: "" });
  figure.querySelector("figcaption").before(panel);
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
    if (chart.data.motions && !chart.layer) addMotion(chart, panel);
  };
};
