// The control structures of a program file, found in one scan: where loops, branches, labels and
// subprograms are, and which belong together. Expressions are not read here.
// Guarantees: memory grows with the number of structures, not with the length of the program.
// Does not know block numbers (ProgramPlaces::find_blocks scans for them).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// A place in a file where reading can go on.
struct Place {
  std::uint64_t offset = 0;  ///< of the start of a line
  int line = 0;              ///< number of the line before it
  std::size_t position = 0;  ///< byte of the line
  friend auto operator<=>(const Place& a, const Place& b) {
    return a.offset != b.offset ? a.offset <=> b.offset : a.position <=> b.position;
  }
  friend bool operator==(const Place& a, const Place& b) {
    return a.offset == b.offset && a.position == b.position;
  }
};

enum class FlowWord : std::uint8_t {
  none,
  branch,  ///< IF
  branch_else_if,
  branch_else,
  branch_end,
  loop_while,  ///< WHILE
  loop_do,     ///< FANUC DO, LinuxCNC do
  loop_for,
  loop_forever,  ///< SINUMERIK LOOP
  loop_repeat,   ///< LinuxCNC repeat, SINUMERIK REPEAT ... UNTIL
  loop_end,
  loop_until,  ///< ends a loop_repeat or loop_do with a condition
  loop_break,
  loop_continue,
  sub,
  sub_end,
  sub_return,
  call,
  label,
  section,  ///< header of a program
};

struct FlowEntry {
  Place at;            ///< where the statement starts
  std::size_t behind;  ///< position behind its keyword
  FlowWord word = FlowWord::none;
  FlowWord ends = FlowWord::none;        ///< the only loop that a loop_end can end; none = any
  std::uint32_t name = 0;                ///< index into ProgramOutline::names, 0 = none
  int first = -1, next = -1, last = -1;  ///< entries of the same structure
  int section = 0;
  int skip = -1;  ///< level of the "/" before it, -1 = none; FANUC
};

/// How a control writes structures: FANUC by WHILE DO END, LinuxCNC by O words, SINUMERIK by names.
/// SUB of Fagor is a label, SUBPROGRAM of CODESYS a section.
enum class OutlineForm : std::uint8_t { macro, owords, sinumerik, fagor, codesys };

/// A fault of the whole structure: a part is not closed, or closes nothing.
struct OutlineFault {
  Place at;
  std::string text;
};

class ProgramOutline {
 public:
  /// Scans the file. Throws Error "file-...".
  ProgramOutline(const std::string& file, OutlineForm form);

  /// The entry that starts at a place, or -1.
  int find(const Place& at) const;
  const FlowEntry& entry(int i) const { return entries_[static_cast<std::size_t>(i)]; }
  std::size_t size() const { return entries_.size(); }
  const std::string& name(const FlowEntry& entry) const { return names_[entry.name]; }
  /// The first sub or label of a name (upper case), or the first behind an entry. -1: there is
  /// none.
  int find_name(FlowWord word, std::string_view name, int behind = -1) const;
  /// The first or the last label of a name between two places in the text; -1: there is none.
  int find_label(std::string_view name, const Place& from, const Place& to, bool last) const;
  /// The section that holds a place, and where it begins and ends.
  int section_at(const Place& at) const;
  Place section_begin(int section) const;
  Place section_end(int section) const;
  const OutlineFault* fault_in(int section) const;

 private:
  struct Open {
    int entry;
    FlowWord word;
    std::uint32_t name;
  };
  void add(FlowEntry entry, std::vector<Open>& open);
  void close(int index, std::vector<Open>& open);
  void chain(int index, std::vector<Open>& open, bool last);
  std::string unmatched(const FlowEntry& entry, const std::vector<Open>& open) const;
  void leave_loop(int index, const std::vector<Open>& open);
  void begin_section(const Place& at, std::vector<Open>& open);
  void fault(const Place& at, std::string text);
  std::uint32_t name_index(const std::string& name);

  std::vector<FlowEntry> entries_;
  std::vector<Place> sections_;
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> name_indices_;
  std::multimap<std::uint32_t, int> named_;  ///< subs and labels
  std::map<int, OutlineFault> faults_;
  Place end_;
};

}  // namespace mrsim
