#include "run/findings/thread_passes.h"

#include "core/numbers/motions.h"
#include "run/cuts/cut_kinds.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {

void ThreadPasses::add(const Program& program, const Motion& m) {
  if (!is_thread_pass(m, program.tools)) return;
  ++by_tool_.try_emplace(m.tool, Passes{m}).first->second.count;
}

std::vector<Diagnostic> ThreadPasses::warnings(const Program& program) const {
  std::vector<Diagnostic> out;
  for (const auto& [tool, passes] : by_tool_) {
    Diagnostic& d = out.emplace_back();
    d.severity = Severity::warning;
    d.code = "thread-not-cut";
    d.text = fmt::format(
        "tool {}: {} of a thread of {:.4g} mm a turn {} not cut into the part, which keeps the "
        "shape that it has before; their collisions are not looked for",
        program.tools[static_cast<std::size_t>(tool)].id,
        passes.count == 1 ? "a pass" : fmt::format("{} passes", passes.count),
        std::abs(passes.first.lead), passes.count == 1 ? "is" : "are");
    d.place = source_place(program, passes.first);
  }
  return out;
}

}  // namespace mrsim
