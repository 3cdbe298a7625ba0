// The meshes of the page: their packed rows as arrays, and normals.
import { unpack } from "./data.js";

export function decodeMesh(data, grid, deviationStep) {
  const position = new Float32Array(3 * data.vertices);
  const steps = unpack(data.position, 3 * data.vertices, 3, new Float64Array(3 * data.vertices));
  for (let i = 0; i < steps.length; ++i) position[i] = grid.lo[i % 3] + grid.step * steps[i];
  const mesh = {
    position,
    index: unpack(data.index, 3 * data.triangles, 1, new Uint32Array(3 * data.triangles)),
    crease: unpack(data.crease, 2 * data.creases, 1, new Uint32Array(2 * data.creases)),
    deviation: new Float32Array(data.vertices),
    owner: new Uint32Array(data.triangles),
  };
  if (data.deviation) {
    unpack(data.deviation, data.vertices, 1, mesh.deviation);
    for (let i = 0; i < data.vertices; ++i) mesh.deviation[i] *= deviationStep;
  }
  if (data.owner) unpack(data.owner, data.triangles, 1, mesh.owner);
  return mesh;
}

/// Normals at the corners of each triangle: the mean of the faces about the corner that lie within
/// 30 degrees of this one, so that arcs look round and edges sharp.
export function cornerNormals(mesh) {
  const { position, index } = mesh;
  const faces = index.length / 3, face = new Float32Array(index.length), unit = new Float32Array(index.length);
  const begin = new Uint32Array(position.length / 3 + 1);
  for (let f = 0; f < faces; ++f) {
    const a = 3 * index[3 * f], b = 3 * index[3 * f + 1], c = 3 * index[3 * f + 2];
    const ux = position[b] - position[a], uy = position[b + 1] - position[a + 1], uz = position[b + 2] - position[a + 2];
    const vx = position[c] - position[a], vy = position[c + 1] - position[a + 1], vz = position[c + 2] - position[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, l = Math.hypot(x, y, z) || 1;
    face.set([x, y, z], 3 * f);
    unit.set([x / l, y / l, z / l], 3 * f);
    for (let k = 0; k < 3; ++k) ++begin[index[3 * f + k] + 1];
  }
  for (let v = 1; v < begin.length; ++v) begin[v] += begin[v - 1];
  const next = begin.slice(), around = new Uint32Array(index.length);
  for (let i = 0; i < index.length; ++i) around[next[index[i]]++] = (i / 3) | 0;
  const out = new Int8Array(4 * index.length);
  for (let i = 0; i < index.length; ++i) {
    const f = 3 * ((i / 3) | 0), nx = unit[f], ny = unit[f + 1], nz = unit[f + 2];
    let x = 0, y = 0, z = 0;
    for (let j = begin[index[i]]; j < begin[index[i] + 1]; ++j) {
      const g = 3 * around[j];
      if (nx * unit[g] + ny * unit[g + 1] + nz * unit[g + 2] < 0.866) continue;
      x += face[g]; y += face[g + 1]; z += face[g + 2];
    }
    const l = Math.hypot(x, y, z);
    const s = l > 0 ? 127 / l : 0;
    out[4 * i] = s ? x * s : nx * 127; out[4 * i + 1] = s ? y * s : ny * 127; out[4 * i + 2] = s ? z * s : nz * 127;
  }
  return out;
}
