// Which tool a comment is about: the one it names, the one of its block, the next one that is
// called (comments stand above the call), or the one just changed to (some posts write them below
// it).
#pragma once

#include "interp/comments/tool_comment.h"
#include "interp/tools/called_again.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrsim {

/// The station of a T word of a lathe, written with `digits` digits: T2, T0202; T002002 of Mazak
/// and T00020002 have half of them for each; T020202 of Okuma is nose, tool and offset.
long turret_station(long number, std::size_t digits);

class ToolNotes {
 public:
  /// `lathe`: a comment beside the T word may name the tool by its work. `turret_digits`: a number
  /// of so many digits or more is station and offset, as T0202 of FANUC lathes; 0: no number is.
  ToolNotes(bool lathe, std::size_t turret_digits)
      : lathe_(lathe), turret_digits_(turret_digits), again_(lathe) {}

  /// Takes a comment. `called`: the T word of its block, or a tool that waits for its M6. `alone`:
  /// nothing else stands in the block. `heads`: it names a section of work, as NAT01 of Okuma.
  void comment(std::string_view bytes, const std::string& called, bool alone, bool heads = false);
  /// A T word names `id`: the comments above it are about this tool.
  void call(const std::string& id);
  /// `id` has come into the spindle. `place`: where its T word stands, "line 11".
  void change(const std::string& id, const std::string& place);
  /// A block with words has been read. `calls_next`: it has a T word and nothing else.
  void end_block(bool calls_next);
  /// The tool has cut: comments above the cut are not about the next tool.
  void cut() {
    if (!group_.text.empty() || !comments_.empty()) end_waiting();  // asked at every cut
    if (!cuts_since_change_ || (again_.waits() && called_ != current_))
      again_.cut(current_, find(current_));
    cuts_ = cuts_since_change_ = true;
    called_.clear();
  }
  /// The unit of the program's lengths, mm.
  void set_unit(double unit) { again_.set_unit(unit); }

  /// The tool of that number that is in use: "1", or "1 (line 11)" where a comment at a later call
  /// describes another tool.
  const std::string& tool_of(const std::string& id) const { return again_.tool_of(id); }
  /// What comments say of the tool; null: nothing.
  const ToolHint* find(const std::string& id) const;
  /// A comment that names the tool, or stands in the block of its T word, and of which nothing was
  /// understood; else empty.
  std::string not_understood(const std::string& id) const;
  /// Takes the comments above the first cut that describe a tool for the tool without id, where no
  /// comment has named a tool by its id. False: there are none.
  bool adopt_nameless();
  /// The id of the only tool that comments have named; empty where there are none or several.
  std::string only() const { return hints_.size() == 1 ? hints_.begin()->first : std::string(); }
  /// A comment behind the first cut that names another tool than the one of adopt_nameless(). Only
  /// the first call gives it.
  std::string other_nameless() { return std::exchange(other_, {}); }
  /// The same for a comment that names the tool in the spindle by its number.
  std::string other_numbered() { return again_.take_other(); }
  /// A comment at a later call that names another kind of tool, and not its size.
  std::string other_kind() { return again_.take_kind(); }
  /// Whether another tool of a number has come, or one of the two has something to tell.
  bool has_news() const { return again_.has_news(); }
  /// Whether another tool of its number has come into the spindle. Only the first call tells.
  bool take_brought() { return again_.take_brought(); }
  bool cuts_since_change() const { return cuts_since_change_; }

 private:
  void add(const std::string& id, const ToolHint& hint);
  void stands_alone(ToolHint hint, bool heads);
  static void name_by_operation(ToolHint& hint);
  const std::string& open_id() const;
  bool tells_kind(const ToolHint& hint) const;
  bool tells_more(const std::string& id, const ToolHint& hint) const;
  bool is_of_work(const ToolHint& hint) const;
  bool adds_details(const ToolHint& hint) const;
  bool add_size(const ToolHint& hint);
  void add_no_cutter(const std::string& id);
  bool add_by_name(const std::string& id);
  void settle_comments();
  void end_group();
  void end_waiting();
  void add_nameless(const ToolHint& hint);
  void add_unnumbered(const ToolHint& hint);

  bool lathe_;
  std::size_t turret_digits_;
  CalledAgain again_;
  std::map<std::string, ToolHint> hints_;
  std::map<std::string, std::string> not_understood_;
  std::vector<ToolHint> comments_;  ///< the comments since the last block
  ToolHint group_;                  ///< earlier comments that wait for their tool
  std::vector<ToolHint> named_;     ///< comments without a number, above the first cut
  ToolHint nameless_;               ///< the comments above the first cut together
  bool lists_ = false;              ///< a comment has headed a list of tools
  /// "(GROOVE1)" above the first T word of a lathe, behind the modes at the head and alone there.
  std::optional<ToolHint> operation_;
  std::size_t blocks_ = 0;  ///< blocks with words
  bool commented_ = false;  ///< a comment came since the last block with words
  bool cuts_ = false, cuts_since_change_ = false;
  bool adopted_ = false;  ///< adopt_nameless() has made nameless_ the tool
  std::string other_, current_;
  std::string told_id_;  ///< id that the comment before named, in lines without a block
  std::string called_;   ///< the tool that a T word has named, before the next cut and change
  int blocks_since_change_ = 1;
  bool behind_next_ = false;  ///< right behind a change and the T word of the next tool
};

}  // namespace mrsim
