// Rapids that withdraw an insert from where its cut ended. A lead angle above 90 degrees leaves a
// wedge between the insert's edge and the shoulder, and the way out scrapes it: true, but on
// nearly every lathe program, so it is kept apart from collisions.
#pragma once

#include "removal/tool/tool.h"
#include <mrsim/types.h>

#include <cstddef>
#include <map>
#include <span>

namespace mrsim {

/// mm: no deeper than this is a withdrawal; deeper is a collision wherever the rapid begins.
inline constexpr double kWithdrawalDepth = 0.5;

class Withdrawals {
 public:
  Withdrawals(std::span<const Motion> motions, std::span<const Tool> tools)
      : motions_(motions), tools_(tools) {}

  /// Whether motion `at` is a rapid of an insert with corners, the first one after a cut or one of
  /// the next three, each from where the motion before it ended.
  bool follows_cut(std::size_t at);
  /// Whether a rapid that follows a cut only withdraws from the material that it meets, being
  /// deepest at `place`, mm. Either it is the first one after the cut, and the corner of the insert
  /// nearest to `place` moves back into the insert's own shape, to within 10 degrees. Or `place` is
  /// inside the insert (or at most `touch` mm beside it) as it stands at the rapid's start: the
  /// withdrawal before it has brought it there.
  bool withdraws(std::size_t at, const Vec3& place, double touch);

 private:
  std::size_t rapids_since_cut(std::size_t at) const;
  const InsertOutline& insert(int tool);

  std::span<const Motion> motions_;
  std::span<const Tool> tools_;
  std::map<int, InsertOutline> inserts_;
};

}  // namespace mrsim
