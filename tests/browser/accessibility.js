// What a page must keep to be read by everybody (WCAG 2.1 A and AA, as far as a script can tell). Returns complaints.
const complaints = [];
const say = (rule, node) => complaints.push(rule + ": " + node.outerHTML.slice(0, 120));
const shown = (node) => node.getClientRects().length > 0 && getComputedStyle(node).visibility === "visible";
const nameOf = (node) => (node.getAttribute("aria-label") || (node.labels && node.labels[0] && node.labels[0].textContent) || node.textContent || "").trim();

if (!document.documentElement.lang) complaints.push("3.1.1 the page names no language");
if (!document.title.trim()) complaints.push("2.4.2 the page has no title");
if (document.querySelectorAll("h1").length !== 1) complaints.push("1.3.1 there is not exactly one h1");
if (!document.querySelector("main")) complaints.push("1.3.1 there is no main");
let last = 1;
for (const heading of document.querySelectorAll("h1, h2, h3, h4")) {
  const level = Number(heading.tagName[1]);
  if (level > last + 1) say("1.3.1 a heading skips a level", heading);
  last = level;
}
const ids = new Set();
for (const node of document.querySelectorAll("[id]")) {
  if (ids.has(node.id)) say("4.1.1 an id is used twice", node);
  ids.add(node.id);
}
for (const node of document.querySelectorAll("svg[role=img], canvas[role=img], img"))
  if ((node.getAttribute("aria-label") || node.getAttribute("alt") || "").length < 20) say("1.1.1 a picture does not say what it shows", node);
for (const node of document.querySelectorAll("svg:not([role=img]), canvas:not([role=img])"))
  if (node.getAttribute("aria-hidden") !== "true") say("1.1.1 a picture is neither described nor hidden", node);
for (const node of document.querySelectorAll("button, a[href], input, [tabindex='0']"))
  if (shown(node) && !nameOf(node)) say("4.1.2 a control has no name", node);
for (const link of document.querySelectorAll("a[href^='#']"))
  if (!document.getElementById(link.getAttribute("href").slice(1))) say("2.4.1 a link leads nowhere", link);
for (const node of document.querySelectorAll("[tabindex]"))
  if (Number(node.getAttribute("tabindex")) > 0) say("2.4.3 a tabindex changes the order", node);
for (const node of document.querySelectorAll("table"))
  if (!node.caption || !node.querySelector("th[scope]")) say("1.3.1 a table has no caption or heads", node);
for (const node of document.querySelectorAll("[aria-describedby], [aria-labelledby]"))
  for (const id of (node.getAttribute("aria-describedby") || node.getAttribute("aria-labelledby")).split(" "))
    if (!document.getElementById(id)) say("4.1.2 a name refers to nothing", node);
// What scrolls must be reachable by the keyboard.
for (const node of document.querySelectorAll("main *")) {
  const style = getComputedStyle(node);
  if (/auto|scroll/.test(style.overflowX) && node.scrollWidth > node.clientWidth + 1 && node.tabIndex < 0 &&
      !node.querySelector("[tabindex='0'], button, a")) say("2.1.1 scrolls, but not by keyboard", node);
}

const channel = (c) => ((c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const light = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
const parts = (colour) => { const n = colour.match(/[\d.]+/g).map(Number); return [n[0], n[1], n[2], n.length > 3 ? n[3] : 1]; };
const background = (node) => {
  for (; node; node = node.parentElement) {
    const [r, g, b, a] = parts(getComputedStyle(node).backgroundColor);
    if (a > 0.9) return [r, g, b];
  }
  return [255, 255, 255];
};
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const node = walker.currentNode.parentElement;
  if (!walker.currentNode.data.trim() || ["SCRIPT", "STYLE"].includes(node.tagName) || node.closest("svg") || !shown(node)) continue;
  if (node.closest(".skip, .spoken")) continue;
  const style = getComputedStyle(node), a = light(parts(style.color)), b = light(background(node));
  const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const large = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.66 && Number(style.fontWeight) >= 700);
  if (contrast < (large ? 3 : 4.5)) say("1.4.3 contrast " + contrast.toFixed(2), node);
}
// Letters inside the pictures, outside the coloured field, follow the theme.
for (const svg of document.querySelectorAll("figure svg")) {
  const paper = light(parts(getComputedStyle(svg.querySelector("rect")).fill));
  for (const shape of svg.querySelectorAll("[fill='#1b1f24'], [fill='#57606a']")) {
    const a = light(parts(getComputedStyle(shape).fill)), contrast = (Math.max(a, paper) + 0.05) / (Math.min(a, paper) + 0.05);
    if (contrast < 4.5) { say("1.4.3 contrast in a picture " + contrast.toFixed(2), shape); break; }
  }
}
return complaints;
