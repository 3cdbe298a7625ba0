// A list of sweeps, sorted by the way in which they are evaluated.
#pragma once

#include "removal/columns/sweep_columns.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mrsim {

/// The sweeps of one form in a list, ascending: their numbers, and their rows in its column.
struct FormPart {
  std::vector<std::uint32_t> ids, rows;
};

class SortedList {
 public:
  /// Sorts a list without packs, unless it is the last one: samples near each other use one list.
  void prepare(const SweepColumns& c, std::span<const std::uint32_t> list);

  const FormPart& ball_lines() const { return forms_[0]; }
  const FormPart& plane_lines() const { return forms_[1]; }
  const FormPart& plane_arcs() const { return forms_[2]; }
  /// Sweeps that have bounds (bounded_sweeps.h).
  std::span<const std::uint32_t> bounded() const { return bounded_; }
  /// Upright arcs and inserts.
  std::span<const std::uint32_t> others() const { return others_; }

 private:
  std::uint64_t table_ = 0;  ///< SweepColumns::serial
  std::vector<std::uint32_t> list_, bounded_, others_;
  FormPart forms_[kOtherForm];
};

}  // namespace mrsim
