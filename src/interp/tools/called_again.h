// Tools of one number: a shop without a tool changer leaves all its tools at number 1, and the
// comments at the calls tell them apart. "T1 M6 (10MM FLAT ENDMILL)", cuts, "T1 M6 (6MM BALL
// ENDMILL)". Private to src/interp.
#pragma once

#include "interp/comments/tool_comment.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mrsim {

class CalledAgain {
 public:
  explicit CalledAgain(bool lathe) : lathe_(lathe) {}

  void set_unit(double unit) { unit_ = unit; }
  /// Whether a tool of that number has cut.
  bool has_cut(const std::string& id) const { return cut_.count(id) > 0; }
  /// Takes a comment about a number whose tool has cut.
  void add(const std::string& id, const ToolHint& hint);
  bool waits() const { return !told_.empty(); }
  /// `place`: where the T word stands that called the tool now in the spindle.
  void change(const std::string& place) { place_ = place; }
  /// The tool of that number is called, and has not cut since: it is the one that the comments
  /// since its last cut describe, if they describe another. Adds that to `hints`.
  void bring(const std::string& id, std::map<std::string, ToolHint>& hints);
  /// The tool cuts; `known`: what comments say of it, or null.
  void cut(const std::string& id, const ToolHint* known);

  /// The tool of the number: "1", or "1 (line 11)", which was called there.
  const std::string& tool_of(const std::string& id) const;
  /// A comment that names another tool of the number that cuts, and no T word has called that.
  std::string take_other() { return std::exchange(other_, {}); }
  /// A comment that contradicts the tool in use, and describes none.
  std::string take_kind() { return std::exchange(kind_, {}); }
  /// Whether another tool has been brought.
  bool take_brought() { return std::exchange(brought_, false); }
  bool has_news() const { return brought_ || !other_.empty() || !kind_.empty(); }

 private:
  bool differs(const ToolHint& known, const ToolHint& told) const;
  bool is_other(const ToolHint* known, const ToolHint& told) const;
  std::string name(const std::string& id, const std::map<std::string, ToolHint>& hints) const;

  bool lathe_;
  double unit_ = 1;
  std::set<std::string> cut_;
  std::map<std::string, ToolHint> told_;  ///< by number: the comments since its last cut
  std::map<std::string, std::vector<std::string>> tools_;  ///< by number; the last is in use
  std::string place_, other_, kind_;
  bool brought_ = false;
};

}  // namespace mrsim
