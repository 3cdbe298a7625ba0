// Unit conversions, applied once at the border (interp, setup, cli). Inside: mm, rad.
#pragma once

namespace mrsim {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTwoPi = 6.28318530717958647693;
inline constexpr double kMmPerInch = 25.4;
inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
inline constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

}  // namespace mrsim
