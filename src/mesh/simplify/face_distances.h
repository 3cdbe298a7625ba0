// Distances of places from faces of the part, remembered: triangles share corners and sides, and a
// side is measured for each triangle on it. Where a face has no closed form, a search is behind
// each of them.
#pragma once

#include "mesh/points/surface_search.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace mrsim::detail {

/// For one thread. Remembers values of the field that are needed again soon.
class FaceDistances {
 public:
  explicit FaceDistances(const ExactField& field) : field_(field), slots_(kSlots) {}

  /// Signed distance of p from the face, mm: ExactField::patch_distance.
  double operator()(const Vec3& p, const FieldSample& face) {
    const std::uint64_t key = face_key(face);
    Slot& s = slots_[slot_of(p, key)];
    if (s.key != key || !(s.p == p)) s = {key, p, field_.patch_distance(p, face)};
    return s.distance;
  }

  const ExactField& field() const { return field_; }

 private:
  static constexpr int kBits = 13;
  static constexpr std::size_t kSlots = std::size_t(1) << kBits;
  static constexpr std::uint64_t kNoFace = ~std::uint64_t(0);
  struct Slot {
    std::uint64_t key = kNoFace;
    Vec3 p;
    double distance = 0;
  };

  static std::size_t slot_of(const Vec3& p, std::uint64_t key) {
    std::uint64_t h = key;
    for (const double x : {p.x, p.y, p.z})
      h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u, h ^= h >> 32;
    return h >> (64 - kBits);
  }

  const ExactField& field_;
  std::vector<Slot> slots_;
};

}  // namespace mrsim::detail
