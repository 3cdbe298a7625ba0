// Cutters that end above (slot mills, thread mills, end mills with short flutes) on helices about
// Z, without a search over their positions (docs/sweeps.md, Closed discs).
#pragma once

#include "removal/forms/tool_path.h"
#include "removal/tool/profile.h"

namespace mrsim {

/// Whether disc_minimum() answers: a closed disc (Profile::disc) on a helix about Z.
bool is_disc_helix(const Profile& tool, const ToolPath& path);

/// The least distance over the positions from `begin` to `end` of the path, up to 1e-12 mm, and
/// where it lies. Requires: is_disc_helix().
PathSample disc_minimum(const Profile& tool, const ToolPath& path, const Vec3& p, double begin,
                        double end);

}  // namespace mrsim
