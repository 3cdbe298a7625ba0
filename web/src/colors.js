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

/// Colours far apart in hue for neighbours in a list; muted, so that deviations stay the loud ones.
export function listColor(i) {
  const hue = (i * 137.508 + 210) % 360, light = [0.62, 0.5, 0.72][i % 3], sat = 0.42;
  const a = sat * Math.min(light, 1 - light);
  const f = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (light - a * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [f(0), f(8), f(4)];
}
export const kStockColor = [168, 172, 174];
export const kCutColor = [214, 160, 82];
