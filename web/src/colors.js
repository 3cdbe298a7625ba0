// The same colours as deviation_color() in src/compare/display_mesh.cpp.

const kStandard = { good: [88, 166, 92], lightExcess: [132, 190, 232], excess: [20, 76, 168], lightGouge: [240, 150, 110], gouge: [178, 24, 32] };
const kSafe = { good: [204, 204, 197], lightExcess: [120, 180, 226], excess: [0, 84, 158], lightGouge: [244, 176, 100], gouge: [190, 78, 0] };

export const schemeOf = (safe) => (safe ? kSafe : kStandard);

export function deviationColor(d, band, safe) {
  const s = schemeOf(safe);
  if (d >= band.lo && d <= band.hi) return s.good;
  const excess = d > 0, beyond = excess ? d - band.hi : band.lo - d;
  const t = Math.min(1, beyond / (band.hi - band.lo));
  const [light, deep] = excess ? [s.lightExcess, s.excess] : [s.lightGouge, s.gouge];
  return light.map((x, i) => Math.round(x + t * (deep[i] - x)));
}

export const css = (rgb) => `rgb(${rgb.join(",")})`;

// The ramp for lines and the colours of tools: those of `mrsim render`, src/mesh/draw/palette.cpp.
const kRamp = [[58, 98, 172], [48, 128, 168], [62, 152, 144], [132, 168, 96], [190, 162, 66], [232, 170, 110], [250, 190, 170]];
const kTools = [[86, 180, 233], [230, 159, 0], [0, 158, 115], [204, 121, 167], [0, 114, 178], [240, 228, 66], [213, 94, 0]];
const kMostShaded = 100; // lines: of more, neighbours need no shades of their own

const scaled = (rgb, share) => rgb.map((x) => Math.min(255, Math.floor(x * share)));

/// The colour of line i of `count`, along the program.
export function rampColor(i, count) {
  const at = (i * (kRamp.length - 1)) / Math.max(count - 1, 1), step = Math.min(Math.floor(at), kRamp.length - 2);
  const rgb = kRamp[step].map((x, k) => Math.round(x + (at - step) * (kRamp[step + 1][k] - x)));
  return i % 2 && count <= kMostShaded ? scaled(rgb, 0.86) : rgb;
}
export const toolColor = (i) => scaled(kTools[i % kTools.length], 1 - 0.18 * Math.min(Math.floor(i / kTools.length), 3));
export const kStockColor = [168, 172, 174];
export const kCutColor = [214, 160, 82];
