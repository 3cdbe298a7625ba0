#include "cuts.h"

namespace mrsim {

CutList join_cuts(const CutHistory& history, const Program& program) {
  CutList list{history, history.motions.size()};
  CutHistory& all = list.all;
  const int files = static_cast<int>(all.files.size()), tools = static_cast<int>(all.tools.size());
  all.files.insert(all.files.end(), program.files.begin(), program.files.end());
  all.tools.insert(all.tools.end(), program.tools.begin(), program.tools.end());
  all.motions.reserve(all.motions.size() + program.motions.size());
  for (Motion motion : program.motions) {
    motion.file += files;
    if (motion.tool >= 0) motion.tool += tools;
    motion.call = -1;
    all.motions.push_back(motion);
  }
  return list;
}

OwnerTable owner_table(const std::vector<std::int32_t>& owners, const CutHistory& cuts) {
  OwnerTable table;
  table.files = cuts.files;
  for (const Tool& tool : cuts.tools) table.tools.push_back(tool.id);
  table.origins.reserve(owners.size());
  for (const std::int32_t owner : owners) {
    if (owner < 0) continue;
    const Motion& motion = cuts.motions[static_cast<std::size_t>(owner)];
    table.origins.push_back({owner, motion.file, motion.line, motion.tool});
  }
  return table;
}

}  // namespace mrsim
