// exp, ln and powers that give the same bits on every machine: libm's differ between systems in the
// last bit. Series in + - * / only; relative error below 1e-15.
#pragma once

namespace mrsim {

/// Infinite above about 709.78, 0 below about -745.
double exponential(double x);

/// Requires: x > 0.
double natural_logarithm(double x);

/// base^exponent; a whole exponent up to 1024 by repeated multiplication, so that small whole
/// powers are exact. Requires: base > 0, or a whole exponent (and base != 0 where it is negative).
double power(double base, double exponent);

}  // namespace mrsim
