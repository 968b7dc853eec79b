// Reading the lines of a chart: the cursor sits on a sample of the data, never between two.
const addLineReader = (figure, data) => {
  addPanelReader(figure, data, data.lines, data.yAxis, data.area);
  if (data.belowArea) addPanelReader(figure, data, data.below, data.belowAxis, data.belowArea);
};

const addPanelReader = (figure, { xAxis, alongAxis }, drawn, yAxis, area) => {
  const visible = (p) => Number.isFinite(p) && p > -1e-9 && p < 1 + 1e-9;
  const lines = drawn.map((line) => {
    // zero and what a log axis does not reach lie on its lower edge, as in the picture
    const level = (y) => (yAxis.log && y >= 0 ? Math.max(0, y > 0 ? position(yAxis, y) : 0) : position(yAxis, y));
    const places = line.x.map((x, i) => [position(xAxis, x), level(line.y[i])]);
    return { line, places, samples: places.flatMap(([a, u], i) => (visible(a) && visible(u) ? [i] : [])) };
  }).filter((l) => l.samples.length > 0);
  if (lines.length === 0) return;
  let n = 0, at = Math.floor(lines[0].samples.length / 2);
  const own = () => lines[n].samples[at];
  const nearestOf = (candidates, across, up, width, height) => {
    let least = Infinity;
    for (const k of candidates)
      lines[k].samples.forEach((i, place) => {
        const [a, u] = lines[k].places[i], distance = ((a - across) * width) ** 2 + ((u - up) * height) ** 2;
        if (distance < least) { least = distance; n = k; at = place; }
      });
  };
  const named = (axis, value) => element("div", {}, ...marked(axis.name), " = " + withUnit(value, axis));
  const several = drawn.length > 1;
  const readOut = () => {
    const { line } = lines[n], i = own(), said = [named(xAxis, line.x[i]), named(yAxis, line.y[i])];
    if (line.along) said.unshift(named(alongAxis, line.along[i]));
    if (several) said.unshift(element("b", {}, line.name));
    // lines over the same samples are compared at once
    for (const other of drawn)
      if (other !== line && other.x[i] === line.x[i] && other.x.length === line.x.length && Number.isFinite(other.y[i]))
        said.push(element("div", {}, other.name + ": " + withUnit(other.y[i], yAxis)));
    return said;
  };
  const label = `Values of the chart: left and right move along a line, with Shift ten steps${several ? "; up and down change the line" : ""}; Escape leaves`;
  addFrame(figure, area, label, {
    point: (across, up, frame) => nearestOf(lines.keys(), across, up, frame.width, frame.height),
    step: (right, up, far) => {
      const { samples } = lines[n], stride = Math.ceil(samples.length / 400) * (far ? 10 : 1);
      const [across, level] = lines[n].places[own()];
      if (right) at = Math.max(0, Math.min(samples.length - 1, at + stride * right));
      else nearestOf([(n - up + lines.length) % lines.length], across, level, 1, 1e-3);
    },
    place: () => lines[n].places[own()],
    readOut,
    choose: () => {},
  });
};
