#include "core/trig.h"

#include "core/units.h"

#include <cmath>

namespace mrsim {
namespace {

// Taylor series on |x| <= pi/4: the first term left out is below 1e-18.
double sin_poly(double x) {
  const double q = x * x;
  double s = 1.0 / 355687428096000.0;  // 17!
  s = s * q - 1.0 / 1307674368000.0;
  s = s * q + 1.0 / 6227020800.0;
  s = s * q - 1.0 / 39916800.0;
  s = s * q + 1.0 / 362880.0;
  s = s * q - 1.0 / 5040.0;
  s = s * q + 1.0 / 120.0;
  s = s * q - 1.0 / 6.0;
  return x + x * q * s;
}

double cos_poly(double x) {
  const double q = x * x;
  double c = 1.0 / 20922789888000.0;  // 16!
  c = c * q - 1.0 / 87178291200.0;
  c = c * q + 1.0 / 479001600.0;
  c = c * q - 1.0 / 3628800.0;
  c = c * q + 1.0 / 40320.0;
  c = c * q - 1.0 / 720.0;
  c = c * q + 1.0 / 24.0;
  c = c * q - 0.5;
  return 1.0 + q * c;
}

SinCos quadrant(double reduced, long k) {
  const double s = sin_poly(reduced), c = cos_poly(reduced);
  switch (k & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

// atan on |t| <= tan(pi/16).
double atan_poly(double t) {
  const double q = t * t;
  double s = 0;
  for (int n = 23; n >= 3; n -= 2) s = (1.0 / n) * ((n / 2) % 2 ? -1.0 : 1.0) + s * q;
  return t + t * q * s;
}

// atan on [0, 1], shifted to the nearest of 0, pi/8, pi/4 by the addition theorem.
double atan_unit(double t) {
  constexpr double kTan8 = 0.41421356237309504880, kAtan8 = kPi / 8;
  if (t < 0.19891236737965800691) return atan_poly(t);
  if (t < 0.66817863791929891999) return kAtan8 + atan_poly((t - kTan8) / (1.0 + t * kTan8));
  return kPi / 4 + atan_poly((t - 1.0) / (1.0 + t));
}

}  // namespace

SinCos sincos(double angle) {
  // pi/2 in three parts of 33, 33 and 53 bits: k * part is exact for |k| < 2^20 (Cody and Waite).
  constexpr double kPart1 = 1.57079632673412561417e+00, kPart2 = 6.07710050630396597660e-11,
                   kPart3 = 2.02226624879595063154e-21;
  const double k = std::floor(angle / (kPi / 2) + 0.5);
  const double reduced = ((angle - k * kPart1) - k * kPart2) - k * kPart3;
  return quadrant(reduced, static_cast<long>(k));
}

SinCos sincos_deg(double angle) {
  const double k = std::floor(angle / 90.0 + 0.5);
  return quadrant(radians(angle - k * 90.0), static_cast<long>(k));
}

double atan2(double y, double x) {
  const double ax = x < 0 ? -x : x, ay = y < 0 ? -y : y;
  if (ax == 0 && ay == 0) return 0;
  double a = ay <= ax ? atan_unit(ay / ax) : kPi / 2 - atan_unit(ax / ay);
  if (x < 0) a = kPi - a;
  return y < 0 ? -a : a;
}

}  // namespace mrsim
