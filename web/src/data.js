// The page's data. Long rows are packed as {z: base64 of raw deflate}; what inflates them works in
// pieces, so all of them are ready before anything else begins.
import { $ } from "./dom.js";

export let data = null;

export async function load() {
  const found = JSON.parse($("data").textContent), waiting = [];
  const walk = (parent, key) => {
    const value = parent[key];
    if (!value || typeof value !== "object") return;
    if (typeof value.z === "string") waiting.push(inflate(value.z).then((bytes) => { parent[key] = bytes; }));
    else for (const k of Object.keys(value)) walk(value, k);
  };
  for (const key of ["part", "nominal", "play", "programs"]) walk(found, key);
  await Promise.all(waiting);
  for (const p of found.programs) unpackProgram(p);
  data = found;
}

async function inflate(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function unpackProgram(p) {
  p.lines = p.text.split("\n").slice(0, p.count);
  p.numbers = unpack(p.numbers, p.count, 1, new Uint32Array(p.count));
  delete p.text;
}

/// Reads the packed numbers of a row one by one: seven bits a byte, sign in the lowest.
export class Reader {
  constructor(bytes) { this.bytes = bytes; this.at = 0; }
  next() {
    let value = 0, scale = 1, byte;
    do {
      byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte & 128);
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
}

/// `count` numbers that are stored as differences from the one `stride` before.
export function unpack(bytes, count, stride, out) {
  const last = new Array(stride).fill(0), row = new Reader(bytes);
  for (let i = 0; i < count; ++i) out[i] = last[i % stride] += row.next();
  return out;
}
