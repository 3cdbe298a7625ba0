// Faces between voxels of which one goes before the other, by columns.

/// The faces of a lattice whose voxels are gone from these moments on: `voxel` the lower of the two,
/// `axis` (+ 4 where the material is the upper one), and the moments from which and until which each
/// is seen. `share` (of the way between the centres, in 255ths) and `normals` (127ths, by threes) are
/// left to the caller, and so are the last `spare` faces.
export function facesBetween(size, gone, spare = 0) {
  let count = spare;
  eachPair(size, gone, () => ++count);
  const out = { count, voxel: new Uint32Array(count), axis: new Uint8Array(count), birth: new Int32Array(count), death: new Int32Array(count),
    share: new Uint8Array(count), normals: new Int8Array(3 * count) };
  let f = 0;
  eachPair(size, gone, (i, k, a, b) => {
    out.voxel[f] = i;
    out.axis[f] = a < b ? k + 4 : k;
    out.birth[f] = Math.min(a, b);
    out.death[f] = Math.max(a, b);
    ++f;
  });
  return out;
}

/// The most faces that are seen at a moment.
export function mostSeen({ count, birth, death }) {
  const change = new Int32Array(death.reduce((a, b) => Math.max(a, b), 0) + 1);
  for (let f = 0; f < count; ++f) { ++change[birth[f]]; --change[death[f]]; }
  let most = 0, now = 0;
  for (const by of change) most = Math.max(most, now += by);
  return most;
}

function eachPair([nx, ny, nz], gone, visit) {
  const layer = ny * nz;
  for (let x = 0, i = 0; x < nx; ++x)
    for (let y = 0; y < ny; ++y)
      for (let z = 0; z < nz; ++z, ++i) {
        const a = gone[i];
        if (x + 1 < nx && a !== gone[i + layer]) visit(i, 0, a, gone[i + layer]);
        if (y + 1 < ny && a !== gone[i + nz]) visit(i, 1, a, gone[i + nz]);
        if (z + 1 < nz && a !== gone[i + 1]) visit(i, 2, a, gone[i + 1]);
      }
}

/// The same run on voxels of twice the edge, for pictures that must be quick: an eighth of the
/// voxels, a quarter of the faces. `gone`: moments of the voxels. Requires: not of a half plane; the
/// outermost voxels are empty, as they are then in the result.
export function coarser({ voxel, origin, size, faces, gone }) {
  const half = size.map((n) => Math.ceil(n / 2) + 1);
  const out = { voxel: 2 * voxel, origin: origin.map((x) => x - voxel / 2), size: half, halfPlane: false, gone: halved(faces, size, half, gone) };
  out.faces = facesBetween(half, out.gone);
  meanSurfaces(faces, size, out.faces, half);
  return out;
}

// Voxel X of twice the edge holds 2 X - 1 and 2 X of each axis, and is there while half of it is
// full. While four of the eight are there, the places of the faces between them decide.
function halved(faces, size, half, gone) {
  const [five, four] = lastOfEight(size, half, gone), fuller = new Float32Array(four.length);
  eachFace(faces, size, half, (f, k, voxel, within) => {
    if (!within) return;
    const both = Math.min(faces.death[f], four[voxel]) - Math.max(faces.birth[f], five[voxel]);
    if (both > 0) fuller[voxel] += both * (faces.share[f] - 127.5) * (faces.axis[f] & 4 ? -1 : 1);
  });
  return four.map((moment, voxel) => (fuller[voxel] < 0 ? five[voxel] : moment));
}

// From which moments on fewer than five and fewer than four of the eight voxels are there.
function lastOfEight([nx, ny, nz], [hx, hy, hz], gone) {
  const five = new Int32Array(hx * hy * hz), four = new Int32Array(hx * hy * hz), eight = new Int32Array(8);
  for (let x = 0, i = 0; x < hx; ++x)
    for (let y = 0; y < hy; ++y)
      for (let z = 0; z < hz; ++z, ++i) {
        let n = 0;
        for (let u = 2 * x - 1; u <= 2 * x; ++u)
          for (let v = 2 * y - 1; v <= 2 * y; ++v)
            for (let w = 2 * z - 1; w <= 2 * z; ++w) {
              const moment = u >= 0 && v >= 0 && w >= 0 && u < nx && v < ny && w < nz ? gone[(u * ny + v) * nz + w] : 0;
              let at = n++;
              for (; at > 0 && eight[at - 1] > moment; --at) eight[at] = eight[at - 1];
              eight[at] = moment;
            }
        five[i] = eight[3];
        four[i] = eight[4];
      }
  return [five, four];
}

// Calls visit(face, axis, voxel of twice the edge that holds the face's lower one, whether it holds
// the upper one, too).
function eachFace({ count, voxel, axis }, [, ny, nz], [, hy, hz], visit) {
  const lower = [0, 0, 0];
  for (let f = 0; f < count; ++f) {
    const i = voxel[f], k = axis[f] & 3;
    lower[2] = i % nz;
    lower[1] = ((i - lower[2]) / nz) % ny;
    lower[0] = Math.floor(i / (ny * nz));
    visit(f, k, (((lower[0] + 1) >> 1) * hy + ((lower[1] + 1) >> 1)) * hz + ((lower[2] + 1) >> 1), lower[k] % 2 === 1);
  }
}

// Places and normals of the faces `to` of twice the edge: means of the faces between the same two
// centres, by the time that both are seen.
function meanSurfaces(from, size, to, half) {
  const [hx, hy, hz] = half, at = new Int32Array(3 * hx * hy * hz).fill(-1), steps = [hy * hz, hz, 1], sums = new Float32Array(5 * to.count);
  for (let f = 0; f < to.count; ++f) at[3 * to.voxel[f] + (to.axis[f] & 3)] = f;
  const add = (f, k, voxel, share) => {
    const t = at[3 * voxel + k];
    if (t < 0 || to.axis[t] !== from.axis[f]) return;
    const both = Math.min(from.death[f], to.death[t]) - Math.max(from.birth[f], to.birth[t]);
    if (both <= 0) return;
    sums[5 * t] += both;
    sums[5 * t + 1] += both * Math.min(1, Math.max(0, share));
    for (let c = 0; c < 3; ++c) sums[5 * t + 2 + c] += both * from.normals[3 * f + c];
  };
  eachFace(from, size, half, (f, k, voxel, within) => {
    // In halves of the way from the centre of the voxel, which lies between its two.
    const place = (within ? -0.5 : 0.5) + from.share[f] / 255;
    add(f, k, voxel, place / 2);
    if (within) add(f, k, voxel - steps[k], place / 2 + 1);
  });
  for (let f = 0; f < to.count; ++f) {
    const s = 5 * f, length = Math.hypot(sums[s + 2], sums[s + 3], sums[s + 4]);
    to.share[f] = sums[s] > 0 ? Math.round((255 * sums[s + 1]) / sums[s]) : 128;
    if (length > 0) for (let c = 0; c < 3; ++c) to.normals[3 * f + c] = Math.round((127 * sums[s + 2 + c]) / length);
    else to.normals[3 * f + (to.axis[f] & 3)] = to.axis[f] & 4 ? -127 : 127;
  }
}
