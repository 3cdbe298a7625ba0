// All cuts of a run in one list: those that the stock remembers, then the program's.
#pragma once

#include <mrsim/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mrsim {

/// A motion's index in the list is its owner number. What it was made from must outlive it: a
/// program's motions are used where they are unless the stock has been cut before.
class CutList {
 public:
  CutList(const CutHistory& history, const Program& program);
  explicit CutList(const CutHistory& history) : CutList(history, history.motions) {}
  CutList(const CutList&) = delete;
  CutList& operator=(const CutList&) = delete;

  const std::vector<std::string>& files() const { return files_; }
  const std::vector<Tool>& tools() const { return tools_; }
  std::span<const Motion> motions() const { return motions_; }  ///< index files() and tools()
  /// Motions that come from the stock's history.
  std::size_t inherited() const { return inherited_; }
  /// What the next setup must know; a copy.
  CutHistory history() const;

 private:
  CutList(const CutHistory& history, std::span<const Motion> motions);
  std::vector<std::string> files_;
  std::vector<Tool> tools_;
  std::vector<Motion> joined_;  ///< where there is a history
  std::span<const Motion> motions_;
  std::size_t inherited_;
};

/// The file, line and tool of each of these owners of faces. Requires: `owners` ascend.
OwnerTable owner_table(const std::vector<std::int32_t>& owners, const CutList& cuts);

}  // namespace mrsim
