// A hash of what a piece of the mesh is computed from: tells what former rounds have done already.
#pragma once

#include "core/numbers/vec.h"
#include "mesh/solid/vertex_lattice.h"
#include "removal/field/field.h"

#include <cstdint>

namespace mrsim::detail {

class InputHash {
 public:
  explicit InputHash(std::uint64_t seed = 0) : h_(seed * 0x9e3779b97f4a7c15u + 1) {}
  void add(std::uint64_t x) {
    h_ = (h_ ^ x) * 0xff51afd7ed558ccdu;
    h_ ^= h_ >> 32;
  }
  /// Requires: coordinates as vertex_lattice.h says.
  void add(const Vec3& p) {
    for (int a = 0; a < 3; ++a)
      add(static_cast<std::uint64_t>(static_cast<std::int64_t>(mrsim::component(p, a) / kQuantum)));
  }
  void add(const FieldSample& face) {
    add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(face.owner)) << 32 |
        static_cast<std::uint32_t>(face.patch));
  }
  /// Neither 0 nor ~0.
  std::uint64_t value() const { return h_ == 0 || h_ == ~std::uint64_t(0) ? 1 : h_; }

 private:
  std::uint64_t h_;
};

}  // namespace mrsim::detail
