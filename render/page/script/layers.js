// The slider along a third axis: fields, regions and boundaries of the other layers, painted over the printed picture.
const colourPosition = (depth, value) => 0.5 + (0.5 * Math.asinh(value / depth.knee)) / Math.asinh(depth.limit / depth.knee);

// Between which two nodes each pixel lies, and how far.
const lookUp = (positions, count, flipped) => Array.from({ length: count }, (_, pixel) => {
  const wanted = flipped ? 1 - (pixel + 0.5) / count : (pixel + 0.5) / count;
  let i = 0;
  while (i < positions.length - 2 && positions[i + 1] < wanted) ++i;
  const share = Math.max(0, Math.min(1, (wanted - positions[i]) / (positions[i + 1] - positions[i])));
  return [i, share];
});

const fieldImage = (chart, layer, width, height) => {
  const { depth } = chart.data, across = lookUp(chart.xs, width, false), down = lookUp(chart.ys, height, true), columns = chart.xs.length;
  const positions = layer.field.map((v) => colourPosition(depth, v));
  const image = new ImageData(width, height);
  for (let row = 0, at = 0; row < height; ++row) {
    const [j, b] = down[row];
    for (let column = 0; column < width; ++column, at += 4) {
      const [i, a] = across[column], k = j * columns + i;
      const value = (positions[k] * (1 - a) + positions[k + 1] * a) * (1 - b) + (positions[k + columns] * (1 - a) + positions[k + columns + 1] * a) * b;
      const entry = 3 * Math.round(255 * Math.max(0, Math.min(1, value)));
      const known = !Number.isNaN(value);
      image.data[at] = known ? depth.colours[entry] : 184;
      image.data[at + 1] = known ? depth.colours[entry + 1] : 188;
      image.data[at + 2] = known ? depth.colours[entry + 2] : 194;
      image.data[at + 3] = 255;
    }
  }
  return image;
};

// The textures of the legend: which lines cover a region.
const textures = {
  "memory-only": [[11, 1, "rgba(0,0,0,.5)", 2.8], [11, 1, "#ffdd33", 1.5]],
  "velocity-only": [[9, 1, "rgba(254,254,254,.75)", 2.4], [9, -1, "rgba(254,254,254,.75)", 2.4], [9, 1, "rgba(0,0,0,.85)", 1], [9, -1, "rgba(0,0,0,.85)", 1]],
  unstable: [[10, -1, "rgba(0,0,0,.42)", 0.9]],
  bistable: [[7, 0, "#000", 2]],
  neutral: [[11, 0, "rgba(254,254,254,.75)", 2.4], [11, 0, "rgba(0,0,0,.85)", 1]],
  undecided: [[9, 1, "rgba(0,0,0,.75)", 0.9], [9, -1, "rgba(0,0,0,.75)", 0.9]],
};

const newCanvas = (width, height) => Object.assign(document.createElement("canvas"), { width, height });

const hatched = (chart, regions, code, width, height) => {
  const cover = newCanvas(width, height), pen = cover.getContext("2d");
  for (const [apart, slope, colour, thickness] of textures[chart.data.classes[code].name] || []) {
    pen.strokeStyle = colour;
    pen.lineWidth = thickness;
    pen.beginPath();
    const step = slope ? apart * Math.SQRT2 : apart;
    for (let offset = -width; offset < width + height; offset += step) {
      pen.moveTo(0, slope > 0 ? offset + width : offset);
      pen.lineTo(width, slope > 0 ? offset : slope < 0 ? offset + width : offset);
    }
    pen.stroke();
  }
  const mask = new ImageData(width, height);
  regions.forEach((region, at) => { mask.data[4 * at + 3] = region === code ? 255 : 0; });
  const stencil = newCanvas(width, height);
  stencil.getContext("2d").putImageData(mask, 0, 0);
  pen.globalCompositeOperation = "destination-in";
  pen.drawImage(stencil, 0, 0);
  return cover;
};

const drawCurves = (pen, layer, width, height) => {
  const trace = (curve, thickness, colour, dash) => {
    pen.lineWidth = thickness;
    pen.strokeStyle = colour;
    pen.setLineDash(dash);
    pen.beginPath();
    for (let i = 0, down = false; i < curve.points.length; i += 2) {
      const x = curve.points[i] * width, y = curve.points[i + 1] * height, gap = Number.isNaN(x);
      if (!gap) down ? pen.lineTo(x, y) : pen.moveTo(x, y);
      down = !gap;
    }
    pen.stroke();
  };
  for (const curve of layer.curves) trace(curve, 5.6, "#fefefe", []);
  // solid first: where the two coincide, both show
  for (const curve of layer.curves) if (curve.memory) trace(curve, 2.6, "#000", []);
  for (const curve of layer.curves) if (curve.ideal) trace(curve, 2.2, "#00506e", [1.5, 4]);
  for (const curve of layer.curves) if (!curve.memory && !curve.ideal) trace(curve, 2.6, "#a4006d", [9, 5]);
};

const paintLayer = (chart, canvas, layer) => {
  const width = 640, height = Math.round((640 * chart.area.clientHeight) / chart.area.clientWidth), fine = 2;
  canvas.width = width * fine;
  canvas.height = height * fine;
  const pen = canvas.getContext("2d"), field = newCanvas(width, height);
  field.getContext("2d").putImageData(fieldImage(chart, layer, width, height), 0, 0);
  pen.scale(fine, fine);
  pen.drawImage(field, 0, 0);
  const regions = regionsOf(chart, layer, width, height);
  chart.data.classes.forEach((_, code) => { if (layer.class.includes(code)) pen.drawImage(hatched(chart, regions, code, width, height), 0, 0); });
  drawCurves(pen, layer, width, height);
  if (!chart.data.design) return;
  const x = width * position(chart.data.x, chart.data.design[0]), y = height * (1 - position(chart.data.y, chart.data.design[1]));
  for (const [arm, thickness, colour] of [[10, 6.5, "#fefefe"], [8, 2.8, "#000"]]) {
    pen.setLineDash([]);
    pen.strokeStyle = colour;
    pen.lineWidth = thickness;
    pen.beginPath();
    pen.moveTo(x - arm, y); pen.lineTo(x + arm, y); pen.moveTo(x, y - arm); pen.lineTo(x, y + arm);
    pen.stroke();
  }
};

// The share of the chart, axes as drawn, that each class of a layer covers: a node stands for half the way to its
// neighbours.
const sharesOf = (chart, classes) => {
  const lengths = (at) => at.map((v, i) => ((at[i + 1] ?? v) - (at[i - 1] ?? v)) / 2);
  const across = lengths(chart.xs), up = lengths(chart.ys), shares = {};
  classes.forEach((code, k) => {
    const { name } = chart.data.classes[code];
    shares[name] = (shares[name] || 0) + across[k % across.length] * up[Math.floor(k / across.length)];
  });
  return shares;
};

const layerWords = (chart, classes) => {
  const shares = sharesOf(chart, classes), percent = (...names) => `${Number((100 * names.reduce((sum, name) => sum + (shares[name] || 0), 0)).toPrecision(3))}${nbsp}%`;
  return `smooth on ${percent("stable", "memory-only")} of the chart, the two models differ on ${percent("memory-only", "velocity-only")}`;
};

const addSlider = (chart) => {
  const { data, figure } = chart, { depth } = data, sheet = figure.querySelector(".sheet");
  const id = figure.id + "-depth", last = depth.axis.values.length - 1, value = element("output", { for: id });
  const input = element("input", { type: "range", id, min: "0", max: String(last), step: "1" });
  const label = element("label", { for: id }, depth.axis.name + " ", ...marked(depth.axis.symbol));
  const words = element("output", { for: id, class: "layer-words" });
  figure.querySelector(".stage").before(element("div", { class: "slider" }, label, input, value, words));
  const canvas = element("canvas", { class: "layer", "aria-hidden": "true", hidden: "" });
  placeOver(canvas, data.area);
  sheet.insertBefore(canvas, sheet.querySelector(".reader"));
  const points = chart.xs.length * chart.ys.length;
  const show = () => {
    const n = Number(input.value), own = n === depth.at;
    const text = withUnit(depth.axis.values[n], depth.axis);
    value.textContent = text + (own ? " (as printed)" : "");
    input.setAttribute("aria-valuetext", text);
    canvas.hidden = own;
    sheet.classList.toggle("moved", !own);
    chart.layer = own ? null : { held: [[depth.axis, depth.axis.values[n]]], field: depth.field.subarray(n * points, (n + 1) * points),
      class: depth.class.subarray(n * points, (n + 1) * points), curves: depth.curves[n] };
    if (chart.layer) paintLayer(chart, canvas, chart.layer);
    // what is printed beside the map belongs to the printed layer
    words.textContent = own ? "" : `Here: ${layerWords(chart, chart.layer.class)}. Text printed in the picture is that of ${withUnit(depth.axis.values[depth.at], depth.axis)}.`;
    chart.changed();
  };
  input.value = String(depth.at);
  input.addEventListener("input", show);
  show();
};
