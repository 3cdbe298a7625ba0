// A set of the axes X, Y and Z.
#pragma once

#include "core/numbers/vec.h"

namespace mrsim {

/// A set of the axes X, Y and Z. Each axis is an index as in component(): X is 0, Y 1 and Z 2.
class AxisSet {
 public:
  constexpr AxisSet() = default;
  constexpr explicit AxisSet(int axis) : bits_(1U << axis) {}

  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool has(int axis) const { return (bits_ >> axis & 1U) != 0; }
  /// Whether all of these axes are in the set.
  constexpr bool has(AxisSet axes) const { return (axes.bits_ & ~bits_) == 0; }
  constexpr void add(int axis) { bits_ |= 1U << axis; }

  constexpr AxisSet& operator|=(AxisSet other) { return *this = *this | other; }
  constexpr AxisSet& operator-=(AxisSet other) { return *this = *this - other; }

  friend constexpr AxisSet operator|(AxisSet a, AxisSet b) { return of_bits(a.bits_ | b.bits_); }
  friend constexpr AxisSet operator&(AxisSet a, AxisSet b) { return of_bits(a.bits_ & b.bits_); }
  /// The axes of `a` that are not in `b`.
  friend constexpr AxisSet operator-(AxisSet a, AxisSet b) { return of_bits(a.bits_ & ~b.bits_); }
  friend constexpr bool operator==(AxisSet, AxisSet) = default;

 private:
  static constexpr AxisSet of_bits(unsigned bits) {
    AxisSet out;
    out.bits_ = bits;
    return out;
  }

  unsigned bits_ = 0;  ///< a bit for each axis
};

inline constexpr AxisSet kAxisX{0}, kAxisY{1}, kAxisZ{2};
inline constexpr AxisSet kAllAxes = kAxisX | kAxisY | kAxisZ;

/// The axes that a direction has a share of.
inline AxisSet axes_along(const Vec3& direction) {
  AxisSet out;
  for (int i = 0; i < 3; ++i)
    if (component(direction, i) != 0) out.add(i);
  return out;
}

}  // namespace mrsim
