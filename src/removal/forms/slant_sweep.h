// Slanted lines of flat, bull-nosed and ball mills that reach up, without a search: the loops of
// slant_lanes.inl for one point.
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/simd/form_records.h"
#include "removal/tool/profile.h"

namespace mrsim {

/// Whether slant_minimum() holds for the move.
inline bool is_slant(const Profile& tool, const ToolPath& path) {
  return !path.arc && tool.is_end_mill() && tool.is_rising();
}
SlantRecord slant_record(const Profile& tool, const ToolPath& path);
/// The least distance and where it lies, exact but for rounding.
PathSample slant_minimum(const SlantRecord& line, const Vec3& p);

}  // namespace mrsim
