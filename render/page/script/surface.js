// The surface of the critical gain, turned by hand: no library, an orthographic view of its grid, far parts first.
const viridis = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
const surfaceColour = (t, shade) => {
  const at = Math.max(0, Math.min(0.999, t)) * 4, k = Math.floor(at), f = at - k;
  return `rgb(${viridis[k].map((c, n) => Math.round(shade * (c + f * (viridis[k + 1][n] - c)))).join(",")})`;
};

// So large that the box and its labels stay on the canvas however it is turned.
const surfaceSize = (width, tall, height) => {
  const labels = { left: 150, right: 130, above: 14, below: 66 };  // px
  const across = Math.SQRT2, upwards = 0.8 * Math.cos(height) + Math.SQRT2 * Math.sin(height);  // of the box, at most
  return {
    middle: (labels.left + width - labels.right) / 2, centre: (labels.above + tall - labels.below) / 2,
    scale: Math.min((width - labels.left - labels.right) / across, (tall - labels.above - labels.below) / upwards),
  };
};

// Places in [−½, ½]³ onto the screen: seen from `azimuth` around and `height` above.
const surfaceView = (azimuth, height, size) => {
  const [ca, sa, ch, sh] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(height), Math.sin(height)];
  return ([x, y, z]) => {
    const right = x * ca - y * sa, away = x * sa + y * ca;
    return { x: size.middle + size.scale * right, y: size.centre - size.scale * (0.8 * z * ch + away * sh), depth: away * ch - 0.8 * z * sh };
  };
};

const axisTicks = (axis) => {
  const { low, high, log } = axis;
  if (log) {
    const powers = [];
    for (let p = Math.ceil(Math.log10(low) - 1e-9); p <= Math.log10(high) + 1e-9; ++p) powers.push(10 ** p);
    return powers.length > 1 ? powers : [low, high];
  }
  return [0, 0.25, 0.5, 0.75, 1].map((t) => low + t * (high - low));
};

const surfaceQuads = (data, z, zAxis) => {
  const pick = (values) => { const step = Math.ceil(values.length / 60); return values.map((_, i) => i).filter((i) => i % step === 0 || i === values.length - 1); };
  const columns = pick(data.x.values), rows = pick(data.y.values), wide = data.x.values.length, quads = [];
  const place = (i, j) => [position(data.x, data.x.values[i]) - 0.5, position(data.y, data.y.values[j]) - 0.5, position(zAxis, z[j * wide + i]) - 0.5];
  for (let a = 0; a + 1 < columns.length; ++a)
    for (let b = 0; b + 1 < rows.length; ++b) {
      const corners = [place(columns[a], rows[b]), place(columns[a + 1], rows[b]), place(columns[a + 1], rows[b + 1]), place(columns[a], rows[b + 1])];
      const known = corners.filter((c) => Number.isFinite(c[2]));
      if (known.length > 2) quads.push(known);  // a triangle at the edge of the surface
    }
  return quads;
};

const drawSurfaceAxes = (pen, view, axes) => {
  const corner = (x, y, z) => view([x, y, z]);
  const edge = (a, b) => { pen.beginPath(); pen.moveTo(a.x, a.y); pen.lineTo(b.x, b.y); pen.stroke(); };
  const [x, y, z] = axes, middle = corner(0, 0, -0.5);
  // the edges nearest to the eye carry the axes of the floor, the corner furthest to the left the vertical one
  const front = (places) => places.reduce((best, p) => (p[0].depth + p[1].depth < best[0].depth + best[1].depth ? p : best));
  const alongX = front([-0.5, 0.5].map((s) => [corner(-0.5, s, -0.5), corner(0.5, s, -0.5)]));
  const alongY = front([-0.5, 0.5].map((s) => [corner(s, -0.5, -0.5), corner(s, 0.5, -0.5)]));
  const left = [[-0.5, -0.5], [-0.5, 0.5], [0.5, -0.5], [0.5, 0.5]].map(([s, t]) => [corner(s, t, -0.5), corner(s, t, 0.5)]).reduce((best, p) => (p[0].x < best[0].x ? p : best));
  for (const [axis, [from, to], upright] of [[x, alongX, false], [y, alongY, false], [z, left, true]]) {
    edge(from, to);
    const out = upright ? { x: -1, y: 0 } : (() => { const mx = (from.x + to.x) / 2 - middle.x, my = (from.y + to.y) / 2 - middle.y, n = Math.hypot(mx, my) || 1; return { x: mx / n, y: my / n }; })();
    const at = (t) => ({ x: from.x + t * (to.x - from.x), y: from.y + t * (to.y - from.y) });
    pen.textAlign = upright || out.x < -0.3 ? "right" : out.x > 0.3 ? "left" : "center";
    let widest = 0;
    for (const value of axisTicks(axis)) {
      widest = Math.max(widest, pen.measureText(withUnit(value, axis)).width);
      const p = at(position(axis, value));
      edge(p, { x: p.x + 5 * out.x, y: p.y + 5 * out.y });
      pen.fillText(withUnit(value, axis), p.x + 9 * out.x, p.y + 14 * out.y + 4);
    }
    pen.save();
    const p = at(0.5), aside = pen.textAlign === "center" ? 0 : Math.sign(out.x) * (widest + 12);
    if (upright) pen.translate(p.x - widest - 24, p.y);
    else pen.translate(p.x + 9 * out.x + aside, p.y + (aside === 0 ? 40 : 14) * out.y + 4);
    if (upright) { pen.rotate(-Math.PI / 2); pen.textAlign = "center"; }
    pen.font = "600 13px system-ui, sans-serif";
    pen.fillText(axis.name, 0, 0);
    pen.restore();
  }
};

const addTurning = (figure, data, button) => {
  const picture = figure.querySelector(".sheet > svg"), reading = data.readings[0], heights = reading.values.slice();
  for (const node of data.undrawn) heights[node] = NaN;  // the unresolved rim, as in the printed picture
  const zs = heights.filter(Number.isFinite);
  if (zs.length === 0) return;
  const log = zs.every((v) => v > 0), zAxis = { ...reading, log, low: zs.reduce((a, b) => Math.min(a, b)), high: zs.reduce((a, b) => Math.max(a, b)) };
  const quads = surfaceQuads(data, heights, zAxis), canvas = element("canvas", { class: "turned", tabindex: "0", role: "img", hidden: "",
    "aria-label": `${reading.name} over ${data.x.name} and ${data.y.name}: drag, or use the arrow keys, to turn it` });
  picture.after(canvas);
  let azimuth = -0.6, height = 0.5;
  const show = () => {
    const width = 900, tall = 560, fine = Math.max(1, window.devicePixelRatio || 1), pen = canvas.getContext("2d");
    canvas.width = width * fine; canvas.height = tall * fine;
    pen.scale(fine, fine);
    const view = surfaceView(azimuth, height, surfaceSize(width, tall, height)), ink = getComputedStyle(canvas).color;
    pen.strokeStyle = pen.fillStyle = ink; pen.font = "13px system-ui, sans-serif"; pen.lineWidth = 1;
    pen.globalAlpha = 0.35;
    for (const s of [-0.5, 0.5]) for (const t of [-0.5, 0.5])
      for (const [a, b] of [[[s, t, -0.5], [s, t, 0.5]], [[s, -0.5, t], [s, 0.5, t]], [[-0.5, s, t], [0.5, s, t]]]) {
        const p = view(a), q = view(b);
        pen.beginPath(); pen.moveTo(p.x, p.y); pen.lineTo(q.x, q.y); pen.stroke();
      }
    pen.globalAlpha = 1;
    const seen = quads.map((corners) => { const c = corners.map(view); return { c, depth: c.reduce((sum, p) => sum + p.depth, 0) / c.length, z: corners.reduce((sum, p) => sum + p[2], 0) / corners.length + 0.5 }; });
    seen.sort((a, b) => b.depth - a.depth);
    for (const { c, z } of seen) {
      const turned = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
      pen.fillStyle = pen.strokeStyle = surfaceColour(z, turned < 0 ? 1 : 0.8);
      pen.beginPath(); c.forEach((p) => pen.lineTo(p.x, p.y)); pen.closePath(); pen.fill(); pen.stroke();
    }
    pen.strokeStyle = pen.fillStyle = ink;
    drawSurfaceAxes(pen, view, [data.x, data.y, zAxis]);
    canvas.dataset.view = `${azimuth.toFixed(3)} ${height.toFixed(3)}`;
  };
  const turn = (around, up) => { azimuth += around; height = Math.max(0.05, Math.min(1.5, height + up)); show(); };
  let held = null;
  canvas.addEventListener("pointerdown", (event) => { held = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    turn((event.clientX - held[0]) / 150, (event.clientY - held[1]) / 150);
    held = [event.clientX, event.clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });
  canvas.addEventListener("keydown", (event) => {
    const move = { ArrowLeft: [0.15, 0], ArrowRight: [-0.15, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
    if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    turn(...move);
  });
  const toggle = button("Turn it", () => {
    const open = canvas.hidden;
    canvas.hidden = !open;
    picture.classList.toggle("away", open);
    toggle.textContent = open ? "Back to the picture" : "Turn it";
    if (open) show();
  });
};
