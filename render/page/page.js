"use strict";
// Reading values off the pictures and taking them home. The page is complete without this script.
(() => {
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const prefixes = [[1e-12, "p"], [1e-9, "n"], [1e-6, "µ"], [1e-3, "m"], [1, ""], [1e3, "k"], [1e6, "M"], [1e9, "G"], [1e12, "T"]];

  // Three digits, a true minus, the powers of ten as superscripts: as the pictures write them.
  const digits = (value) => {
    if (Number.isNaN(value)) return "–";
    const size = Math.abs(value);
    if (size === 0 || (size >= 1e-3 && size < 1e5)) return String(Number(value.toPrecision(3))).replace("-", "−");
    const [mantissa, exponent] = value.toExponential(2).split("e");
    const raised = String(Number(exponent)).replace("-", "⁻").replace(/\d/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);
    return String(Number(mantissa)).replace("-", "−") + "×10" + raised;
  };
  const withUnit = (value, axis) => {
    const unit = axis.unit === "1" ? "" : axis.unit;
    if (!axis.prefix || !value) return (digits(value) + " " + unit).trim();
    const size = Math.abs(Number(value.toPrecision(3)));
    const found = prefixes.find(([factor]) => size >= factor * (1 - 1e-12) && size < factor * 1000 * (1 - 1e-12));
    return found ? digits(value / found[0]) + " " + found[1] + unit : digits(value) + " " + unit;
  };

  // Chart mark-up as nodes: "k_{p}" is a subscript.
  const marked = (text) => text.split(/([_^]\{[^}]*\})/).map((part) => {
    if (!/^[_^]\{/.test(part)) return part;
    const element = document.createElement(part[0] === "_" ? "sub" : "sup");
    element.textContent = part.slice(2, -1);
    return element;
  });

  const save = (name, type, text) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };

  const csv = (data) => {
    const quoted = (text) => (/[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text);
    const lines = [data.header];
    if (data.kind === "map")
      data.y.values.forEach((y, j) => data.x.values.forEach((x, i) => {
        const k = j * data.x.values.length + i;
        lines.push([x, y, Number(data.field[k].toPrecision(8)), data.regions[data.region[k]].name].join(","));
      }));
    else if (data.kind === "surface")
      data.y.values.forEach((y, j) => data.x.values.forEach((x, i) =>
        lines.push([x, y, Number(data.field[j * data.x.values.length + i].toPrecision(8))].join(","))));
    else
      data.lines.forEach((line) => line.x.forEach((x, i) => lines.push([quoted(line.name), x, line.y[i]].join(","))));
    return lines.join("\n") + "\n";
  };

  const unpack = (data) => {
    const doubles = (text) => Array.from(new Float64Array(bytes(text).buffer));
    for (const axis of [data.x, data.y]) if (axis && axis.values) axis.values = doubles(axis.values);
    if (data.field) data.field = new Float32Array(bytes(data.field).buffer);
    if (data.region) data.region = bytes(data.region);
    for (const line of data.lines || []) { line.x = doubles(line.x); line.y = doubles(line.y); }
    return data;
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

  // A frame over the data area: the pointer or the arrow keys choose a grid point, the box beside it says its values.
  const reader = (figure, data) => {
    const sheet = figure.querySelector(".sheet");
    const area = document.createElement("div");
    const tip = document.createElement("div");
    area.className = "reader";
    area.tabIndex = 0;
    area.setAttribute("role", "application");
    area.setAttribute("aria-label", "Values of the map: arrow keys move by one grid point, with Shift by ten; Escape leaves");
    const [left, top, width, height] = data.area;
    Object.assign(area.style, { left: left * 100 + "%", top: top * 100 + "%", width: width * 100 + "%", height: height * 100 + "%" });
    const upright = area.appendChild(document.createElement("div"));
    const level = area.appendChild(document.createElement("div"));
    upright.className = "upright";
    level.className = "level";
    tip.className = "tip";
    tip.setAttribute("role", "status");
    sheet.append(area, tip);

    const xs = data.x.values.map((v) => position(data.x, v)), ys = data.y.values.map((v) => position(data.y, v));
    let i = data.start[0], j = data.start[1];
    const line = (tag, ...parts) => { const element = document.createElement(tag); element.append(...parts); return element; };
    const show = (column, row) => {
      i = Math.max(0, Math.min(xs.length - 1, column));
      j = Math.max(0, Math.min(ys.length - 1, row));
      const k = j * xs.length + i, value = data.field[k];
      upright.style.left = xs[i] * 100 + "%";
      level.style.top = (1 - ys[j]) * 100 + "%";
      tip.replaceChildren(
        line("b", data.regions[data.region[k]].text),
        line("div", ...marked(data.x.symbol), " = " + withUnit(data.x.values[i], data.x)),
        line("div", ...marked(data.y.symbol), " = " + withUnit(data.y.values[j], data.y)),
        line("div", "max Re s = " + digits(value) + " 1/s" + (Number.isNaN(value) ? "" : value < 0 ? " (decays)" : " (grows)")));
      sheet.classList.add("on");
      const frame = area.getBoundingClientRect(), page = sheet.getBoundingClientRect();
      let x = frame.left - page.left + xs[i] * frame.width + 14, y = frame.top - page.top + (1 - ys[j]) * frame.height + 14;
      if (x + tip.offsetWidth > page.width) x -= tip.offsetWidth + 28;
      if (y + tip.offsetHeight > page.height) y -= tip.offsetHeight + 28;
      tip.style.left = Math.max(0, x) + "px";
      tip.style.top = Math.max(0, y) + "px";
    };
    const hide = () => sheet.classList.remove("on");
    const point = (event) => {
      const frame = area.getBoundingClientRect();
      show(nearest(xs, (event.clientX - frame.left) / frame.width), nearest(ys, 1 - (event.clientY - frame.top) / frame.height));
    };
    area.addEventListener("pointermove", point);
    area.addEventListener("pointerdown", point);
    area.addEventListener("pointerleave", (event) => { if (event.pointerType === "mouse") hide(); });
    area.addEventListener("focus", () => { if (area.matches(":focus-visible")) show(i, j); });
    area.addEventListener("blur", hide);
    area.addEventListener("keydown", (event) => {
      const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (event.key === "Escape") hide();
      if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      const stride = event.shiftKey ? 10 : 1;
      show(i + stride * move[0], j + stride * move[1]);
    });
  };

  for (const figure of document.querySelectorAll("figure[id]")) {
    const source = figure.querySelector('script[type="application/json"]');
    const tools = figure.querySelector(".tools");
    const button = (label, action) => {
      const element = tools.appendChild(document.createElement("button"));
      element.type = "button";
      element.textContent = label;
      element.addEventListener("click", action);
    };
    if (source) {
      const data = unpack(JSON.parse(source.textContent));
      if (data.kind === "map" && figure.querySelector(".sheet")) reader(figure, data);
      button("Data (CSV)", () => save(figure.id + ".csv", "text/csv", csv(data)));
    }
    const picture = figure.querySelector(".sheet > svg");
    if (picture) button("Picture (SVG)", () => save(figure.id + ".svg", "image/svg+xml", new XMLSerializer().serializeToString(picture)));
  }

  // The contents show where the reader is.
  const links = new Map([...document.querySelectorAll("nav a")].map((a) => [a.getAttribute("href").slice(1), a]));
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries)
      if (entry.isIntersecting) {
        for (const link of links.values()) link.removeAttribute("aria-current");
        links.get(entry.target.id).setAttribute("aria-current", "true");
      }
  }, { rootMargin: "0px 0px -70% 0px" });
  for (const id of links.keys()) {
    const target = document.getElementById(id);
    if (target) seen.observe(target);
  }
})();
