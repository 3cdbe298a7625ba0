#include "run/cuts/cuts.h"

namespace mrsim {

CutList::CutList(const CutHistory& history, std::span<const Motion> motions)
    : files_(history.files),
      tools_(history.tools),
      motions_(motions),
      inherited_(history.motions.size()) {}

CutList::CutList(const CutHistory& history, const Program& program)
    : CutList(history, program.motions) {
  const int files = static_cast<int>(files_.size()), tools = static_cast<int>(tools_.size());
  files_.insert(files_.end(), program.files.begin(), program.files.end());
  tools_.insert(tools_.end(), program.tools.begin(), program.tools.end());
  if (files == 0 && tools == 0 && inherited_ == 0) return;
  joined_.reserve(inherited_ + program.motions.size());
  joined_ = history.motions;
  for (Motion motion : program.motions) {
    motion.file += files;
    if (motion.tool >= 0) motion.tool += tools;
    joined_.push_back(motion);
  }
  motions_ = joined_;
}

CutHistory CutList::history() const {
  CutHistory history{files_, tools_, {motions_.begin(), motions_.end()}};
  for (Motion& motion : history.motions) motion.call = -1;
  return history;
}

OwnerTable owner_table(const std::vector<std::int32_t>& owners, const CutList& cuts) {
  OwnerTable table;
  table.files = cuts.files();
  for (const Tool& tool : cuts.tools()) table.tools.push_back(tool.id);
  table.origins.reserve(owners.size());
  for (const std::int32_t owner : owners) {
    if (owner < 0) continue;
    const Motion& motion = cuts.motions()[static_cast<std::size_t>(owner)];
    table.origins.push_back({owner, motion.file, motion.line, motion.tool});
  }
  return table;
}

}  // namespace mrsim
