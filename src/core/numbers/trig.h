// sin, cos and atan2 that give the same bits on every machine: libm's differ between systems in the
// last bit, and mrsim promises equal output files. Polynomials in + - * / only; error below 2 ulp
// for |angle| up to 1e6, about 1e-9 at 1e7.
#pragma once

namespace mrsim {

struct SinCos {
  double sin, cos;
};

/// Sine and cosine of an angle in radians. Requires: finite, |angle| <= 1e7 (a million turns).
SinCos sincos(double angle);

/// Sine and cosine of an angle in degrees; exact at multiples of 90. Requires: finite, |angle| <=
/// 1e9.
SinCos sincos_deg(double angle);

/// Angle of (x, y) in radians, in (-pi, pi]; 0 for (0, 0).
double atan2(double y, double x);

}  // namespace mrsim
