// What the page plays, unpacked: the motions, the voxels' moments, and the faces between voxels.
// docs/report.md tells the layout; src/compare/play_json.cpp writes it.
import { Reader, unpack } from "./data.js";
import { coarser, facesBetween } from "./faces.js";

export const kRapid = 0, kLine = 1, kArc = 2;
const kAssumed = 4, kJumps = 8, kTilted = 16;
const kLength = 1e-4, kAngle = 1e-7, kTime = 1e-6, kVolume = 1e-4;
const kShownFeed = 500 / 60; // mm/s of cuts whose feed is unknown

/// Motions by columns; `arcs` by motion: { center, axis, sweep, rise }; `tilts`: the tool's axis.
function decodeMotions(p) {
  const m = p.motions, n = m.count, heads = new Reader(m.heads), places = new Reader(m.places);
  const out = { count: n, kind: new Uint8Array(n), assumed: new Uint8Array(n), file: new Int32Array(n), line: new Int32Array(n), tool: new Int32Array(n),
    start: new Float32Array(3 * n), end: new Float32Array(3 * n), arcs: new Map(), tilts: new Map(),
    first: new Int32Array(n + 1), seconds: new Float64Array(n), removed: new Float64Array(n), length: new Float64Array(n) };
  const at = [0, 0, 0], last = [0, 0, 0], three = (step) => [0, 1, 2].map(() => places.next() * step);
  const place = () => { for (let k = 0; k < 3; ++k) at[k] += places.next(); return at.map((x) => x * kLength); };
  let file = 0, line = 0, tool = 0, moment = 0;
  const moments = new Reader(m.moments), seconds = new Reader(m.seconds), removed = new Reader(m.removed);
  for (let i = 0; i < n; ++i) {
    const head = heads.next();
    out.kind[i] = head & 3;
    out.assumed[i] = head & kAssumed ? 1 : 0;
    out.file[i] = (file += heads.next()) + p.firstFile;
    out.line[i] = line += heads.next();
    out.tool[i] = tool += heads.next();
    const start = head & kJumps ? place() : last.slice(), end = place();
    out.start.set(start, 3 * i);
    out.end.set(end, 3 * i);
    out.length[i] = Math.hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
    if (out.kind[i] === kArc) {
      const center = three(kLength).map((x, k) => x + start[k]), axis = three(kAngle);
      const arc = { center, axis, sweep: places.next() * kAngle, rise: places.next() * kLength };
      out.arcs.set(i, arc);
      out.length[i] = Math.hypot(arc.sweep * Math.hypot(...start.map((x, k) => x - center[k])), arc.rise);
    }
    if (head & kTilted) out.tilts.set(i, three(kAngle));
    for (let k = 0; k < 3; ++k) last[k] = end[k];
    out.first[i] = moment;
    moment += moments.next();
    out.seconds[i] = seconds.next() * kTime;
    if (out.seconds[i] === 0 && out.kind[i] !== kRapid && !out.assumed[i]) out.seconds[i] = out.length[i] / kShownFeed;
    out.removed[i] = removed.next() * kVolume;
  }
  out.first[n] = moment;
  out.begin = new Float64Array(n + 1);
  for (let i = 0; i < n; ++i) out.begin[i + 1] = out.begin[i] + out.seconds[i];
  return out;
}

/// By voxel: the moment from which it is gone; `stays` where no motion removes it.
function decodeVoxels(p, stays) {
  const [nx, ny, nz] = p.size, row = nz, layer = ny * nz, n = nx * layer, out = new Int32Array(n);
  const s = p.symbols, numbers = new Reader(p.numbers);
  let last = 0;
  for (let i = 0; i < n; ++i) {
    switch (s[i]) {
      case 0: out[i] = out[i - 1]; break;
      case 1: out[i] = out[i - row]; break;
      case 2: out[i] = out[i - layer]; break;
      case 3: break;
      case 4: out[i] = stays; break;
      default: out[i] = last += numbers.next();
    }
  }
  return out;
}

/// The faces of the run, with their surfaces; later ones of the same place follow at the end.
function decodeFaces(p, gone) {
  const out = facesBetween(p.size, gone, p.lateCount), n = p.faceCount + p.lateCount;
  if (out.count !== n) throw new Error(`${out.count} faces where ${n} were told`);
  const surfaces = (bytes, at, count) => {
    out.share.set(bytes.subarray(0, count), at);
    for (let f = 0; f < count; ++f) unpackNormal((bytes[count + f] - 127) / 127, (bytes[2 * count + f] - 127) / 127, out.normals, 3 * (at + f));
  };
  surfaces(p.faces, 0, p.faceCount);
  surfaces(p.lateFaces, p.faceCount, p.lateCount);
  const late = unpack(p.late, 2 * p.lateCount, 2, new Int32Array(2 * p.lateCount));
  for (let i = 0, f = p.faceCount; i < p.lateCount; ++i, ++f) {
    const of = late[2 * i];
    out.voxel[f] = out.voxel[of];
    out.axis[f] = out.axis[of];
    out.birth[f] = late[2 * i + 1];
    out.death[f] = out.death[of];
    out.death[of] = late[2 * i + 1];
  }
  return out;
}

function unpackNormal(u, v, normals, at) {
  let x = u, y = v;
  const z = 1 - Math.abs(u) - Math.abs(v);
  if (z < 0) { x = (1 - Math.abs(v)) * (u < 0 ? -1 : 1); y = (1 - Math.abs(u)) * (v < 0 ? -1 : 1); }
  const l = 127 / (Math.hypot(x, y, z) || 1);
  normals[at] = Math.round(x * l); normals[at + 1] = Math.round(y * l); normals[at + 2] = Math.round(z * l);
}

export class Play {
  constructor(packed) {
    const { voxel, halfPlane, origin, size, tools, stock } = packed;
    Object.assign(this, { voxel, halfPlane, origin, size, tools, stock });
    this.motions = decodeMotions(packed);
    this.moments = this.motions.first[this.motions.count];
    const gone = decodeVoxels(packed, this.moments + 1);
    this.faces = decodeFaces(packed, gone);
    // Which motion ends at which moment; moment 0 is the stock's.
    this.motionOf = new Int32Array(this.moments + 2).fill(-1);
    for (let i = 0; i < this.motions.count; ++i) this.motionOf.fill(i, this.motions.first[i] + 1, this.motions.first[i + 1] + 1);
    this.total = this.motions.begin[this.motions.count];
    // The same on larger voxels, for pictures that must be quick.
    this.coarse = [this];
    if (halfPlane) return;
    const half = coarser({ voxel, origin, size, faces: this.faces, gone });
    this.coarse = [half, coarser(half)];
  }
  /// All places of the programmed point, by threes; arcs by their ends.
  bounds() { return this.motions.end.filter((_, i) => !this.motions.assumed[Math.floor(i / 3)]); }
  /// A place on the time line is a motion and the share of it that is done, as one number.
  get end() { return this.motions.count; }
  secondsAt(at) {
    const i = Math.min(Math.floor(at), this.end - 1);
    return this.motions.begin[i] + (at - i) * this.motions.seconds[i];
  }
  atSeconds(seconds) {
    const { begin } = this.motions;
    if (seconds >= this.total) return this.end;
    let low = 0, high = this.end;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (begin[middle] <= seconds) low = middle; else high = middle;
    }
    return this.motions.seconds[low] > 0 ? low + Math.min(1, (seconds - begin[low]) / this.motions.seconds[low]) : low;
  }
  momentAt(at) {
    if (at >= this.end) return this.moments;
    const i = Math.floor(at), { first } = this.motions;
    return first[i] + Math.floor((at - i) * (first[i + 1] - first[i]) + 1e-6);
  }
  /// The place on the time line at which a moment has just come.
  atMoment(moment) {
    const i = this.motionOf[moment], { first } = this.motions;
    return i < 0 ? 0 : i + (moment - first[i]) / (first[i + 1] - first[i]);
  }
  /// Where the tool is: its programmed point, mm.
  placeAt(at) {
    const i = Math.min(Math.floor(at), this.end - 1);
    return this.placeOn(i, at - i);
  }
  placeOn(i, share) {
    const { start, end } = this.motions, arc = this.motions.arcs.get(i);
    const a = start.subarray(3 * i, 3 * i + 3), b = end.subarray(3 * i, 3 * i + 3);
    if (share >= 1) return [...b];
    if (!arc) return [0, 1, 2].map((k) => a[k] + share * (b[k] - a[k]));
    const { center, axis: n } = arc, arm = [0, 1, 2].map((k) => a[k] - center[k]);
    const across = [n[1] * arm[2] - n[2] * arm[1], n[2] * arm[0] - n[0] * arm[2], n[0] * arm[1] - n[1] * arm[0]];
    const along = n[0] * arm[0] + n[1] * arm[1] + n[2] * arm[2], c = Math.cos(arc.sweep * share), s = Math.sin(arc.sweep * share);
    return [0, 1, 2].map((k) => center[k] + along * n[k] + c * (arm[k] - along * n[k]) + s * across[k] + arc.rise * share * n[k]);
  }
  toolAxis(i) { return this.motions.tilts.get(i) ?? [0, 0, 1]; }
  /// The first and the end of the motions of the line that a motion belongs to.
  blockOf(i) {
    const { file, line } = this.motions;
    let first = i, end = i + 1;
    while (first > 0 && file[first - 1] === file[i] && line[first - 1] === line[i]) --first;
    while (end < this.end && file[end] === file[i] && line[end] === line[i]) ++end;
    return [first, end];
  }
  /// Number of faces that are seen at a moment.
  countAt(moment) {
    const { birth, death, count } = this.faces;
    let n = 0;
    for (let f = 0; f < count; ++f) n += birth[f] <= moment && moment < death[f];
    return n;
  }
}
