// Which region each pixel of a layer belongs to: that of the nearest node from which no boundary separates it, as in the
// printed picture.
const fencesOf = (layer, width, height) => {
  const size = 16, columns = Math.floor(width / size) + 1, squares = [];
  const around = ([ax, ay, bx, by]) => {
    const place = (v, most) => Math.floor(Math.max(0, Math.min(most, v)) / size), found = [];
    for (let j = place(Math.min(ay, by), height); j <= place(Math.max(ay, by), height); ++j)
      for (let i = place(Math.min(ax, bx), width); i <= place(Math.max(ax, bx), width); ++i) found.push(j * columns + i);
    return found;
  };
  for (const { points } of layer.curves)
    for (let n = 0; n + 3 < points.length; n += 2) {
      const ax = points[n] * width, ay = points[n + 1] * height, dx = points[n + 2] * width - ax, dy = points[n + 3] * height - ay;
      if (Number.isNaN(dx)) continue;
      const pieces = 1 + Math.floor(Math.hypot(dx, dy) / size);
      for (let k = 0; k < pieces; ++k) {
        const a = k / pieces, b = (k + 1) / pieces, piece = [ax + dx * a, ay + dy * a, ax + dx * b, ay + dy * b];
        for (const square of around(piece)) (squares[square] ||= []).push(piece);
      }
    }
  const turn = (ax, ay, bx, by, cx, cy) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const cross = ([ax, ay, bx, by], [cx, cy, dx, dy]) =>
    turn(ax, ay, bx, by, cx, cy) * turn(ax, ay, bx, by, dx, dy) <= 0 && turn(cx, cy, dx, dy, ax, ay) * turn(cx, cy, dx, dy, bx, by) <= 0;
  return (way) => around(way).some((square) => squares[square] && squares[square].some((piece) => cross(piece, way)));
};

const regionsOf = (chart, layer, width, height) => {
  const across = lookUp(chart.xs, width, false), down = lookUp(chart.ys, height, true), columns = chart.xs.length;
  const separated = fencesOf(layer, width, height), codes = new Uint8Array(width * height);
  for (let row = 0, at = 0; row < height; ++row)
    for (let column = 0; column < width; ++column, ++at) {
      const [i, a] = across[column], [j, b] = down[row], k = j * columns + i, { class: of } = layer;
      codes[at] = of[k];
      if (of[k] === of[k + 1] && of[k] === of[k + columns] && of[k] === of[k + columns + 1]) continue;
      const nodes = [[i, j, (1 - a) * (1 - b)], [i + 1, j, a * (1 - b)], [i, j + 1, (1 - a) * b], [i + 1, j + 1, a * b]].sort((p, q) => q[2] - p[2]);
      const reached = nodes.find(([m, n]) => !separated([column + 0.5, row + 0.5, chart.xs[m] * width, (1 - chart.ys[n]) * height]));
      const [m, n] = reached || nodes[0];
      codes[at] = of[n * columns + m];
    }
  return codes;
};
