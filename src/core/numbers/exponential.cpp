#include "core/numbers/exponential.h"

#include <cmath>
#include <limits>

namespace mrsim {
namespace {

// ln 2 in two parts: the first has 32 bits, so that k * kLn2High is exact for |k| < 2^20.
constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;
constexpr double kLn2 = 0.69314718055994530942;
constexpr double kMostMultiplied = 1024;

double whole_power(double base, double exponent) {
  const bool inverse = exponent < 0;
  auto n = static_cast<unsigned>(inverse ? -exponent : exponent);
  double result = 1, square = base;
  for (; n != 0; n >>= 1U) {
    if (n & 1U) result *= square;
    square *= square;
  }
  return inverse ? 1 / result : result;
}

}  // namespace

double exponential(double x) {
  if (x > 710) return std::numeric_limits<double>::infinity();
  if (x < -746) return 0;
  const double k = std::floor(x / kLn2 + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= ln 2 / 2
  double sum = 1;
  for (int n = 17; n >= 1; --n) sum = 1 + r * sum / n;
  return std::ldexp(sum, static_cast<int>(k));
}

double natural_logarithm(double x) {
  int k = 0;
  double m = std::frexp(x, &k);  // 0.5 <= m < 1
  if (m < 0.70710678118654752440) {
    m *= 2;
    --k;
  }
  // ln m = 2 artanh s, s = (m - 1) / (m + 1), |s| < 0.1716.
  const double s = (m - 1) / (m + 1), q = s * s;
  double sum = 0;
  for (int n = 25; n >= 3; n -= 2) sum = (1.0 / n + sum) * q;
  return k * kLn2High + (2 * (s + s * sum) + k * kLn2Low);
}

double power(double base, double exponent) {
  if (exponent == std::floor(exponent) && std::abs(exponent) <= kMostMultiplied)
    return whole_power(base, exponent);
  if (base < 0) {  // a whole exponent beyond those above: its parity is known up to 2^53
    const double size = exponential(exponent * natural_logarithm(-base));
    return std::fmod(exponent, 2) == 0 ? size : -size;
  }
  return exponential(exponent * natural_logarithm(base));
}

}  // namespace mrsim
