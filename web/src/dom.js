// Elements with text, never with markup: programs may say anything.
export const $ = (id) => document.getElementById(id);

export function el(tag, attributes = {}, ...children) {
  const svg = ["svg", "rect", "line", "text", "title", "circle"].includes(tag) && attributes.svg !== false;
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === "svg" || value === undefined || value === false) continue;
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (key === "style") Object.assign(node.style, value);
    else node.setAttribute(key, value === true ? "" : value);
  }
  for (const child of children.flat()) if (child !== null && child !== undefined) node.append(child);
  return node;
}

/// A signed length in mm; a true minus sign keeps columns even.
export const signed = (x, digits = 4) => (x < 0 ? "\u2212" : "+") + Math.abs(x).toFixed(digits);
export const plain = (x, digits = 4) => (x < 0 ? "\u2212" : "") + Math.abs(x).toFixed(digits);
/// 12345.678 as 12 345.678
export const grouped = (x, digits = 0) => {
  const [whole, part] = Math.abs(x).toFixed(digits).split(".");
  return (x < 0 ? "\u2212" : "") + whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") + (part ? "." + part : "");
};
export const place = (p) => `X${plain(p[0], 3)} Y${plain(p[1], 3)} Z${plain(p[2], 3)}`;
/// 1 234 mm^3, small ones as 12.34 mm^3
export const volume = (mm3) => `${grouped(mm3, mm3 < 100 ? 2 : 0)} mm\u00b3`;
/// 83.4 as 1:23.4
export function clock(seconds) {
  const m = Math.floor(seconds / 60), h = Math.floor(m / 60), s = (seconds % 60).toFixed(1).padStart(4, "0");
  return h ? `${h}:${String(m % 60).padStart(2, "0")}:${s}` : `${m}:${s}`;
}
