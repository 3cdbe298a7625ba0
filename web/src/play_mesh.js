// The surface of one moment: the faces that are seen then, with a vertex for each cell of eight
// voxels where the planes of its faces meet best (dual contouring). Made anew for each moment, which
// takes some ten milliseconds; nothing is stored but the faces.
import { mostSeen } from "./faces.js";

const kStiffness = 0.02; // pull towards the mean of a cell's places, so that flat cells have an answer
const kSame = 0.86; // cosine: faces of a cell that bend less than this are shaded as one
const kSums = 16; // of a cell: place 3, count 1, normals' products 6, right side 3, normals 3

// Cells about a face are, by its two other axes b and c in turn: (below, below), (at, below),
// (at, at), (below, at). Runs of an x face go along z (c), of a y face along z (b), of a z face
// along y (c): [the corners on along the run, the ones they come from].
const kEnds = [[[2, 3], [1, 0]], [[1, 2], [0, 3]], [[2, 3], [1, 0]]];
const kMoved = new Float32Array(12);
const kCorners = [0, 0, 0, 0]; // places in the sums of the corners of the face at hand

export class PlayMesh {
  /// `keyOf(moment)`: its colour; faces of one key may share a quad. `segments`: of the rings of a turned part.
  constructor(play, keyOf, segments = 72) {
    Object.assign(this, { play, keyOf, segments });
    const [nx, ny, nz] = play.size;
    this.layer = ny * nz;
    this.row = nz;
    this.slots = new Int32Array(nx * ny * nz + this.layer).fill(-1); // of each cell; cells begin a layer below
    this.live = new Uint32Array(0);
    this.angles = Array.from({ length: segments + 1 }, (_, k) => [Math.cos((2 * Math.PI * k) / segments), Math.sin((2 * Math.PI * k) / segments)]);
    // Faces that are seen, and the quads that are drawn for them.
    this.faces = this.quads = 0;
    this.position = new Float32Array(0);
    this.moment = -1;
  }
  /// Makes the surface of a moment.
  show(moment) {
    this.moment = moment;
    if (!this.position.length) this.reserve(mostSeen(this.play.faces));
    const live = this.gather(moment), count = this.sumCells(live);
    this.solveCells(count);
    this.quads = this.play.halfPlane ? this.writeTurned(live) : this.writeFaces(live);
    for (let s = 0; s < count; ++s) this.slots[this.used[s]] = -1;
    this.faces = live;
  }
  gather(moment) {
    const { birth, death, count } = this.play.faces;
    if (this.live.length < count) this.live = new Uint32Array(count);
    let n = 0;
    for (let f = 0; f < count; ++f) if (birth[f] <= moment && moment < death[f]) this.live[n++] = f;
    return n;
  }
  // Room for a moment with the most faces.
  reserve(faces) {
    const cells = Math.min(4 * faces, this.slots.length), quads = faces * (this.play.halfPlane ? this.segments : 1);
    this.used = new Uint32Array(cells);
    this.sums = new Float32Array(kSums * cells);
    this.position = new Float32Array(12 * quads);
    this.normal = new Int8Array(16 * quads);
    this.owner = new Float32Array(4 * quads);
    this.quadFace = new Uint32Array(quads);
    this.joined = new Uint8Array(quads); // quads of more than one face
  }
  // The cells about a face: how far below its voxel each lies, with the face's place in it.
  cellsOf(axis) {
    const { layer, row } = this, steps = [layer, row, 1];
    if (this.play.halfPlane) return axis === 0 ? [[1, 0, 0, 1], [0, 0, 0, 0]] : [[layer, 1, 0, 0], [0, 0, 0, 0]];
    const b = (axis + 1) % 3, c = (axis + 2) % 3;
    return [[1, 1], [0, 1], [0, 0], [1, 0]].map(([db, dc]) => {
      const at = [0, 0, 0];
      at[b] = db; at[c] = dc;
      return [db * steps[b] + dc * steps[c], ...at];
    });
  }
  sumCells(live) {
    const { voxel, axis, share, normals } = this.play.faces, { sums, slots, used } = this, cells = [0, 1, 2].map((k) => this.cellsOf(k));
    let count = 0;
    for (let i = 0; i < live; ++i) {
      const f = this.live[i], k = axis[f] & 3, t = share[f] / 255;
      const nx = normals[3 * f] / 127, ny = normals[3 * f + 1] / 127, nz = normals[3 * f + 2] / 127;
      for (const [below, x, y, z] of cells[k]) {
        const cell = voxel[f] - below + this.layer;
        let s = slots[cell];
        if (s < 0) {
          s = slots[cell] = count;
          used[count++] = cell;
          sums.fill(0, kSums * s, kSums * s + kSums);
        }
        const at = kSums * s, px = k === 0 ? t : x, py = k === 1 ? t : y, pz = k === 2 ? t : z, d = nx * px + ny * py + nz * pz;
        sums[at] += px; sums[at + 1] += py; sums[at + 2] += pz; sums[at + 3] += 1;
        sums[at + 4] += nx * nx; sums[at + 5] += nx * ny; sums[at + 6] += nx * nz; sums[at + 7] += ny * ny; sums[at + 8] += ny * nz; sums[at + 9] += nz * nz;
        sums[at + 10] += nx * d; sums[at + 11] += ny * d; sums[at + 12] += nz * d;
        sums[at + 13] += nx; sums[at + 14] += ny; sums[at + 15] += nz;
      }
    }
    return count;
  }
  // Least squares about the mean; the place in mm replaces the sums, the mean normal the last three.
  solveCells(count) {
    const { sums, used, layer, row } = this, { voxel, origin, halfPlane } = this.play, [ox, oy, oz] = origin;
    for (let s = 0; s < count; ++s) {
      const at = kSums * s, n = sums[at + 3], mx = sums[at] / n, my = sums[at + 1] / n, mz = sums[at + 2] / n;
      const a = sums[at + 4] + kStiffness, b = sums[at + 5], c = sums[at + 6], d = sums[at + 7] + kStiffness, e = sums[at + 8], f = sums[at + 9] + kStiffness;
      const rx = sums[at + 10] - ((a - kStiffness) * mx + b * my + c * mz), ry = sums[at + 11] - (b * mx + (d - kStiffness) * my + e * mz), rz = sums[at + 12] - (c * mx + e * my + (f - kStiffness) * mz);
      const p = d * f - e * e, q = c * e - b * f, r = b * e - c * d, det = a * p + b * q + c * r;
      const within = (x) => (x < 0 ? 0 : x > 1 ? 1 : x);
      const x = within(mx + (p * rx + q * ry + r * rz) / det), y = within(my + (q * rx + (a * f - c * c) * ry + (b * c - a * e) * rz) / det), z = within(mz + (r * rx + (b * c - a * e) * ry + (a * d - b * b) * rz) / det);
      const cell = used[s] - layer, cz = ((cell % row) + row) % row, rest = (cell - cz) / row;
      const cx = halfPlane ? rest : Math.floor(cell / layer), cy = halfPlane ? 0 : rest - cx * (layer / row);
      sums[at] = cx < 0 ? 0 : ox + voxel * (cx + x);
      sums[at + 1] = halfPlane ? 0 : oy + voxel * (cy + y);
      sums[at + 2] = oz + voxel * (cz + z);
      const l = Math.hypot(sums[at + 13], sums[at + 14], sums[at + 15]) || 1;
      sums[at + 13] /= l; sums[at + 14] /= l; sums[at + 15] /= l;
    }
  }
  // A quad for each face; faces in a row that lie in one plane share one, so that flat stock costs
  // little. Returns the number of quads.
  writeFaces(live) {
    const { voxel, axis, birth, normals } = this.play.faces, { slots, row } = this, cells = [0, 1, 2].map((k) => this.cellsOf(k).map((c) => c[0]));
    const last = [null, null, null].map(() => ({ voxel: -2, face: -1, quad: -1 })), columns = Array.from({ length: row }, () => ({ voxel: -2, face: -1, quad: -1 }));
    let quads = 0;
    for (let i = 0; i < live; ++i) {
      const f = this.live[i], k = axis[f] & 3, below = cells[k], key = this.keyOf(birth[f]);
      const run = k === 2 ? columns[voxel[f] % row] : last[k], step = k === 2 ? row : 1, g = run.face;
      for (let c = 0; c < 4; ++c) kCorners[c] = kSums * slots[voxel[f] - below[c] + this.layer];
      const joins = run.voxel + step === voxel[f] && axis[f] === axis[g] && this.owner[4 * run.quad] === key
        && normals[3 * f] === normals[3 * g] && normals[3 * f + 1] === normals[3 * g + 1] && normals[3 * f + 2] === normals[3 * g + 2] && this.extend(run.quad, k, axis[f] & 4);
      if (!joins) {
        run.quad = quads++;
        this.write(run.quad, f, key, axis[f] & 4);
        this.quadFace[run.quad] = f;
        this.joined[run.quad] = 0;
      } else {
        this.joined[run.quad] = 1;
      }
      run.voxel = voxel[f];
      run.face = f;
    }
    for (let q = 0; q < quads; ++q) if (this.joined[q]) this.widen(q);
    return quads;
  }
  // A row's quad reaches a little over its neighbours, whose corners lie along its sides: without
  // that, single pixels between them stay empty.
  widen(quad) {
    const { position } = this, by = 0.1 * this.play.voxel, at = 12 * quad, moved = kMoved;
    for (let k = 0; k < 4; ++k) {
      const a = at + 3 * k;
      for (let c = 0; c < 3; ++c) moved[3 * k + c] = position[a + c];
      for (const other of [(k + 1) % 4, (k + 3) % 4]) {
        const b = at + 3 * other, x = position[a] - position[b], y = position[a + 1] - position[b + 1], z = position[a + 2] - position[b + 2], l = Math.hypot(x, y, z) || 1;
        moved[3 * k] += (by * x) / l; moved[3 * k + 1] += (by * y) / l; moved[3 * k + 2] += (by * z) / l;
      }
    }
    position.set(moved, at);
  }
  // The quad with the corners kCorners.
  write(quad, f, key, turned) {
    const { sums, position, normal, owner } = this, { normals } = this.play.faces, nx = normals[3 * f], ny = normals[3 * f + 1], nz = normals[3 * f + 2];
    for (let k = 0; k < 4; ++k) {
      const at = kCorners[turned ? 3 - k : k], v = 4 * quad + k;
      position[3 * v] = sums[at]; position[3 * v + 1] = sums[at + 1]; position[3 * v + 2] = sums[at + 2];
      const mx = sums[at + 13], my = sums[at + 14], mz = sums[at + 15], smooth = nx * mx + ny * my + nz * mz > 127 * kSame;
      normal[4 * v] = smooth ? 127 * mx : nx; normal[4 * v + 1] = smooth ? 127 * my : ny; normal[4 * v + 2] = smooth ? 127 * mz : nz;
      owner[v] = key;
    }
  }
  // Moves the far corners of a quad to those of kCorners where these go straight on along the axis
  // of the run.
  extend(quad, k, turned) {
    const { sums, position } = this, along = k === 2 ? 1 : 2, slack = 0.01 * this.play.voxel;
    const [far, near] = kEnds[k];
    for (let side = 0; side < 2; ++side) {
      const from = 3 * (4 * quad + (turned ? 3 - near[side] : near[side])), to = kCorners[far[side]];
      for (let c = 0; c < 3; ++c) if (c !== along && Math.abs(position[from + c] - sums[to + c]) > slack) return false;
    }
    for (const corner of far) {
      const at = 3 * (4 * quad + (turned ? 3 - corner : corner)), to = kCorners[corner];
      for (let c = 0; c < 3; ++c) position[at + c] = sums[to + c];
    }
    return true;
  }
  // A ring of quads for each face of the half plane; faces in a row that lie in one cylinder or one
  // plane across the axis share one.
  writeTurned(live) {
    const { voxel, axis, birth, normals } = this.play.faces, { sums, slots, layer, row } = this, slack = 0.01 * this.play.voxel, cells = [0, 1, 2].map((k) => this.cellsOf(k).map((c) => c[0]));
    const none = () => ({ voxel: -2, face: -1, key: -1, from: 0, to: 0 }), columns = Array.from({ length: row }, none);
    let wall = none(), quads = 0;
    const write = (run) => { if (run.face >= 0) quads = this.writeRing(quads, run); };
    for (let i = 0; i < live; ++i) {
      const f = this.live[i], k = axis[f] & 3, key = this.keyOf(birth[f]), [from, to] = cells[k].map((c) => kSums * slots[voxel[f] - c + layer]);
      const run = k === 0 ? wall : columns[voxel[f] % row], g = run.face;
      if (run.voxel + (k === 0 ? 1 : layer) === voxel[f] && axis[f] === axis[g] && run.key === key && normals[3 * f] === normals[3 * g] && normals[3 * f + 2] === normals[3 * g + 2] && Math.abs(sums[run.from + k] - sums[to + k]) <= slack) {
        Object.assign(run, { voxel: voxel[f], to });
        continue;
      }
      write(run);
      Object.assign(run, { voxel: voxel[f], face: f, key, from, to });
    }
    [wall, ...columns].forEach(write);
    return quads;
  }
  // Returns the number of quads with those of this ring.
  writeRing(quads, { face: f, key, from, to }) {
    const { axis, normals } = this.play.faces, { sums, position, normal, owner, angles, segments } = this, nr = normals[3 * f], nz = normals[3 * f + 2];
    const ends = ((axis[f] & 3) === 0) !== Boolean(axis[f] & 4) ? [to, from] : [from, to];
    for (let s = 0, v = 4 * quads; s < segments; ++s)
      for (let corner = 0; corner < 4; ++corner, ++v) {
        const at = ends[corner === 0 || corner === 3 ? 0 : 1], [c, d] = angles[s + (corner > 1 ? 1 : 0)];
        position[3 * v] = sums[at] * c; position[3 * v + 1] = sums[at] * d; position[3 * v + 2] = sums[at + 2];
        const mr = sums[at + 13], mz = sums[at + 15], smooth = nr * mr + nz * mz > 127 * kSame, r = smooth ? 127 * mr : nr;
        normal[4 * v] = r * c; normal[4 * v + 1] = r * d; normal[4 * v + 2] = smooth ? 127 * mz : nz;
        owner[v] = key;
      }
    this.quadFace.fill(f, quads, quads + segments);
    return quads + segments;
  }
  /// The face under a ray, or null: { face, t }.
  pick(o, d, keeps) {
    const p = this.position, place = (t) => [o.x + t * d.x, o.y + t * d.y, o.z + t * d.z];
    let best = Infinity, hit = -1;
    for (let q = 0; q < this.quads; ++q)
      for (let half = 0; half < 2; ++half) {
        const a = 12 * q, b = a + (half ? 6 : 3), c = a + (half ? 9 : 6);
        const t = crossing(p, a, b, c, o, d);
        if (t > 0 && t < best && keeps(place(t))) { best = t; hit = q; }
      }
    return hit < 0 ? null : { face: this.faceAt(this.quadFace[hit], place(best)), t: best };
  }
  // Of the faces that may share the quad of face f, the one at a place: each has its own moment.
  faceAt(f, [x, y, z]) {
    const { play, layer, row } = this, { voxel, axis, birth } = play.faces, { origin, halfPlane } = play, key = this.keyOf(birth[f]), k = axis[f] & 3;
    const at = halfPlane ? [Math.hypot(x, y), 0, z] : [x, y, z], cell = at.map((v, c) => (v - origin[c]) / play.voxel - (c === k ? 0.5 : 0));
    let best = Infinity, found = f;
    for (let i = 0; i < this.faces; ++i) {
      const g = this.live[i], v = voxel[g];
      if (axis[g] !== axis[f] || this.keyOf(birth[g]) !== key) continue;
      const apart = Math.hypot(Math.floor(v / layer) - cell[0], halfPlane ? 0 : (Math.floor(v / row) % (layer / row)) - cell[1], (v % row) - cell[2]);
      if (apart < best) { best = apart; found = g; }
    }
    return found;
  }
}

/// Moeller and Trumbore: how far along the ray, or -1.
function crossing(p, a, b, c, o, d) {
  const ex = p[b] - p[a], ey = p[b + 1] - p[a + 1], ez = p[b + 2] - p[a + 2], gx = p[c] - p[a], gy = p[c + 1] - p[a + 1], gz = p[c + 2] - p[a + 2];
  const hx = d.y * gz - d.z * gy, hy = d.z * gx - d.x * gz, hz = d.x * gy - d.y * gx, det = ex * hx + ey * hy + ez * hz;
  if (det === 0) return -1;
  const sx = o.x - p[a], sy = o.y - p[a + 1], sz = o.z - p[a + 2], u = (sx * hx + sy * hy + sz * hz) / det;
  if (u < 0 || u > 1) return -1;
  const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex, v = (d.x * qx + d.y * qy + d.z * qz) / det;
  if (v < 0 || u + v > 1) return -1;
  return (gx * qx + gy * qy + gz * qz) / det;
}
