"use strict";
// Numbers as the pictures write them: three digits, a true minus, SI prefixes, powers of ten as superscripts.
const prefixes = [[1e-12, "p"], [1e-9, "n"], [1e-6, "µ"], [1e-3, "m"], [1, ""], [1e3, "k"], [1e6, "M"], [1e9, "G"], [1e12, "T"]];

const digits = (value) => {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value < 0 ? "−∞" : "∞";
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-3 && size < 1e5)) return String(Number(value.toPrecision(3))).replace("-", "−");
  const [mantissa, exponent] = value.toExponential(2).split("e");
  const raised = String(Number(exponent)).replace("-", "⁻").replace(/\d/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);
  return String(Number(mantissa)).replace("-", "−") + "×10" + raised;
};

// A number and its unit stay on one line, as in the printed words.
const nbsp = "\u00a0";

// What a reader may choose to read values in: factor and name for each unit; pictures and printed words keep SI.
const workshopUnits = { rad: [180 / Math.PI, "°"], "rad/s": [30 / Math.PI, "rpm"], m: [1e3, "mm"], "m/s": [1e3, "mm/s"] };
let readingUnits = {};

// `kind` has a unit and says whether it takes a prefix.
const withUnit = (value, kind) => {
  const unit = kind.unit === "1" ? "" : kind.unit, chosen = readingUnits[unit];
  if (chosen) return digits(value * chosen[0]) + nbsp + chosen[1];
  if (!kind.prefix || !value || !Number.isFinite(value)) return digits(value) + (unit && nbsp + unit);
  const size = Math.abs(Number(value.toPrecision(3)));
  const found = prefixes.find(([factor]) => size >= factor * (1 - 1e-12) && size < factor * 1000 * (1 - 1e-12));
  return found ? digits(value / found[0]) + nbsp + found[1] + unit : digits(value) + nbsp + unit;
};

// "between 1 N and 2 N", or "at 1 N" where both ends read the same.
const span = (low, high, kind) => {
  const [least, most] = [withUnit(low, kind), withUnit(high, kind)];
  return least === most ? `at ${least}` : `between ${least} and ${most}`;
};

// Chart mark-up as nodes: "k_{p}" is a subscript.
const marked = (text) => text.split(/([_^]\{[^}]*\})/).map((part) => {
  if (!/^[_^]\{/.test(part)) return part;
  const element = document.createElement(part[0] === "_" ? "sub" : "sup");
  element.textContent = part.slice(2, -1);
  return element;
});

const element = (tag, attributes, ...children) => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};
