// A record that moves: measured, simulated before and after, side by side, drawn from the numbers of the chart. What the
// simulations get wrong is far smaller than the motion, so it is drawn magnified, and how much is said.
const playedAt = (line, time) => {
  let low = 0, high = line.x.length - 1;
  if (high < 0) return NaN;
  while (high - low > 1) { const middle = (low + high) >> 1; if (line.x[middle] <= time) low = middle; else high = middle; }
  const span = line.x[high] - line.x[low], share = span > 0 ? Math.max(0, Math.min(1, (time - line.x[low]) / span)) : 0;
  return line.y[low] + share * (line.y[high] - line.y[low]);
};

const largestDifference = (a, b) => b.x.reduce((most, t, i) => Math.max(most, Math.abs(b.y[i] - playedAt(a, t)) || 0), 0);

// 1, 2, 5, 10, …: the largest error becomes about a tenth of the stroke
const magnification = (data) => {
  const [measured, ...others] = data.lines, ys = measured.y.filter(Number.isFinite);
  const stroke = Math.max(...ys) - Math.min(...ys), error = Math.max(...others.map((line) => largestDifference(measured, line)));
  if (!(stroke > 0) || !(error > 0)) return 1;
  const wanted = stroke / 10 / error, power = 10 ** Math.floor(Math.log10(wanted));
  return wanted <= 1 ? 1 : [5, 2, 1].find((factor) => factor * power <= wanted) * power;
};

const drawArrow = (pen, x, y, length) => {
  if (!(Math.abs(length) > 1)) return;
  const head = Math.sign(length) * Math.min(7, Math.abs(length));
  pen.beginPath();
  pen.moveTo(x, y); pen.lineTo(x + length, y);
  pen.moveTo(x + length - head, y - 4); pen.lineTo(x + length, y); pen.lineTo(x + length - head, y + 4);
  pen.stroke();
};

const drawSlide = (pen, place, row, effort, name) => {
  const y = 34 + 64 * row, left = 150, width = 440, x = left + width * place;
  pen.fillText(name, 8, y + 5);
  pen.globalAlpha = 0.35; pen.beginPath(); pen.moveTo(left - 24, y + 14); pen.lineTo(left + width + 24, y + 14); pen.stroke(); pen.globalAlpha = 1;
  pen.fillRect(x - 20, y - 12, 40, 25);
  drawArrow(pen, x, y - 19, 60 * effort);
};

const drawDial = (pen, angle, row, effort, name) => {
  const x = 110 + 205 * row, y = 108, radius = 74;
  pen.globalAlpha = 0.35; pen.beginPath(); pen.arc(x, y, radius, 0, 2 * Math.PI); pen.stroke(); pen.globalAlpha = 1;
  pen.lineWidth = 5; pen.beginPath(); pen.moveTo(x, y); pen.lineTo(x + radius * Math.sin(angle), y + radius * Math.cos(angle)); pen.stroke();
  pen.lineWidth = 2; drawArrow(pen, x, y + radius + 16, 60 * effort);
  pen.textAlign = "center"; pen.fillText(name, x, 18); pen.textAlign = "left";
};

const addPlayer = (figure, data) => {
  const [measured] = data.lines, times = measured.x, first = times[0], last = times[times.length - 1];
  const values = measured.y.filter(Number.isFinite), low = Math.min(...values), span = Math.max(...values) - low || 1;
  const efforts = data.below || [], strongest = Math.max(1e-300, ...efforts.flatMap((line) => line.y.filter(Number.isFinite).map(Math.abs)));
  let times10 = magnification(data), at = first, speed = 1, before = null, running = false;
  const button = element("button", { type: "button" }, "Play"), id = figure.id + "-played";
  const slider = element("input", { type: "range", id, min: "0", max: "1000", step: "1", value: "0" });
  const choice = (label, options, chosen, change) => {
    const select = element("select", {}, ...options.map((o) => element("option", { value: String(o), ...(o === chosen ? { selected: "" } : {}) }, `× ${o}`)));
    select.addEventListener("change", () => { change(Number(select.value)); show(); });
    return element("label", {}, label + nbsp, select);
  };
  const scales = [1, 10, 100, 1000, 1e4, 1e5].concat(times10).filter((v, i, all) => all.indexOf(v) === i).sort((a, b) => a - b);
  const words = element("output", { for: id, class: "layer-words" });
  const canvas = element("canvas", { class: "played", role: "img", "aria-label": "The joint as it moved, and as the simulations move it" });
  const controls = element("div", { class: "slider" }, button, element("label", { for: id }, "time"), slider,
    choice("speed", [0.1, 0.25, 0.5, 1, 2], 1, (v) => { speed = v; }), choice("errors drawn", scales, times10, (v) => { times10 = v; }), words);
  figure.querySelector(".stage").before(canvas, controls);
  const show = () => {
    const width = 640, height = data.turns ? 216 : 22 + 64 * data.lines.length, fine = Math.max(1, window.devicePixelRatio || 1), pen = canvas.getContext("2d");
    canvas.width = width * fine; canvas.height = height * fine;
    pen.scale(fine, fine);
    pen.font = "13px system-ui, sans-serif"; pen.lineWidth = 2;
    const ink = getComputedStyle(canvas), own = playedAt(measured, at);
    data.lines.forEach((line, row) => {
      const drawn = own + times10 * (playedAt(line, at) - own), effort = efforts[row] ? playedAt(efforts[row], at) / strongest : 0;
      pen.strokeStyle = pen.fillStyle = penColours()[row] || ink.color;
      data.turns ? drawDial(pen, drawn, row, effort, line.name) : drawSlide(pen, (drawn - low) / span, row, effort, line.name);
    });
    slider.value = String(Math.round((1000 * (at - first)) / (last - first || 1)));
    const errors = data.lines.slice(1).map((line) => `${line.name} ${withUnit(playedAt(line, at) - own, data.yAxis)}`).join(", ");
    words.textContent = `${withUnit(at - first, { unit: "s", prefix: true })}: position ${withUnit(own, data.yAxis)}; off by: ${errors}.`
      + (times10 > 1 ? ` Position errors are drawn ${times10.toLocaleString("en")} times as large.` : "") + (efforts.length ? " Arrows: effort." : "");
  };
  const tick = (now) => {
    if (!running) return;
    at += before === null ? 0 : (speed * (now - before)) / 1000;
    before = now;
    if (at >= last) { at = last; stop(); }
    show();
    if (running) requestAnimationFrame(tick);
  };
  const stop = () => { running = false; button.textContent = "Play"; };
  button.addEventListener("click", () => {
    if (running) return stop();
    if (at >= last) at = first;
    running = true; before = null; button.textContent = "Pause";
    requestAnimationFrame(tick);
  });
  slider.addEventListener("input", () => { stop(); at = first + (last - first) * Number(slider.value) / 1000; show(); });
  show();
};
