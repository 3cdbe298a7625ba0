// The shape of a tool, made and checked once from the numbers of mrsim::Tool.
//
// Milling: a profile in (r, z), z from the tip upwards, revolved about the tool's axis. Every
// horizontal section is a full disc (the profile never goes down), so one function r(z) says it
// all; undercuts are where r falls. Turning: a convex polygon in (X radius, Z) about the programmed
// point, thickened by the nose radius: every corner of an insert is round, not only the one in use.
//
// Guarantees: what make_tool_shape returns is valid; distances are exact, signed, 1-Lipschitz and
// use + - * / sqrt only. Angles are turned into coordinates once, with our own sine.
#pragma once

#include "core/numbers/vec.h"
#include "removal/tool/insert.h"
#include "removal/tool/profile.h"
#include <mrsim/types.h>

#include <string>
#include <vector>

namespace mrsim {

struct ToolShape {
  bool turning = false;
  Profile cutter;  ///< milling: what cuts
  /// milling: what must not touch; convex pieces from below, empty when not given
  std::vector<Profile> shank, holder;
  InsertOutline insert;  ///< turning
  double radius = 0;     ///< cutter radius or nose radius, mm; 0 = a sharp insert
};

/// The checked shape of a tool. Throws Error "tool-invalid", naming the tool and what is missing.
ToolShape make_tool_shape(const Tool& tool);

/// make_tool_shape() for a milling cutter.
Profile make_cutter(const Tool& tool);

[[noreturn]] void invalid_tool(const Tool& tool, const std::string& why);

}  // namespace mrsim
