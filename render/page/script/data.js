// The numbers behind a figure: unpacked once, written out as CSV on demand.
const inflate = async (text, width) => {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const sorted = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = sorted.length / width, bytes = new Uint8Array(sorted.length);
  for (let k = 0; k < width; ++k) for (let i = 0; i < count; ++i) bytes[i * width + k] = sorted[k * count + i];
  return bytes.buffer;
};
const doubles = async (text) => Array.from(new Float64Array(await inflate(text, 8)));
const floats = async (text) => new Float32Array(await inflate(text, 4));
const codes = async (text) => new Uint8Array(await inflate(text, 1));

const unpackAxis = async (axis) => { axis.values = await doubles(axis.values); return axis; };

const unpack = async (data) => {
  for (const line of [...(data.lines || []), ...(data.below || [])]) {
    line.x = await doubles(line.x);
    line.y = await doubles(line.y);
    if (line.along) line.along = await doubles(line.along);
  }
  if (data.kind === "lines") return data;
  for (const axis of [data.x, data.y, data.across, data.up]) if (axis) await unpackAxis(axis);
  if (data.field) data.field = await floats(data.field);
  else for (const reading of data.readings) reading.values = await floats(reading.values);
  if (data.class) data.class = await codes(data.class);
  return data;
};

const csv = (data) => {
  const quoted = (text) => (/[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text);
  const lines = [data.header];
  if (data.kind === "panels")
    data.places.forEach((place, n) => data.y.values.forEach((y, j) => data.x.values.forEach((x, i) => {
      const k = (n * data.y.values.length + j) * data.x.values.length + i, held = data.up ? [place.up, place.across] : [place.across];
      lines.push([...held, x, y, Number(data.field[k].toPrecision(5)), data.classes[data.class[k]].name].join(","));
    })));
  else if (data.kind === "grid")
    data.y.values.forEach((y, j) => data.x.values.forEach((x, i) => {
      const k = j * data.x.values.length + i;
      const row = [x, y, ...data.readings.map((reading) => Number(reading.values[k].toPrecision(8)))];
      if (data.class) row.push(quoted(data.classes[data.class[k]].name));
      lines.push(row.join(","));
    }));
  else
    [...data.lines, ...(data.below || [])].forEach((line) => line.x.forEach((x, i) =>
      lines.push([quoted(line.name), x, line.y[i], ...(data.alongAxis ? [line.along ? line.along[i] : ""] : [])].join(","))));
  return lines.join("\n") + "\n";
};

const save = (name, type, content) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

const position = (axis, value) => {
  const { low, high } = axis;
  return axis.log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
};
const nearest = (positions, wanted) => {
  let best = 0;
  positions.forEach((p, i) => { if (Math.abs(p - wanted) < Math.abs(positions[best] - wanted)) best = i; });
  return best;
};
