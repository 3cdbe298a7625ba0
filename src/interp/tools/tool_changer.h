// Tools: T words and names, what comments say of them, registers. Adds the tools that the program
// uses to Program::tools. Private to src/interp.
#pragma once

#include "interp/tools/tool_data.h"
#include "interp/tools/tool_edges.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace mrsim {

class ToolChanger : public ControlPart {
 public:
  explicit ToolChanger(Control& control);

  /// Reads the comments of the block before its words, because they may be about the T in it.
  void read_comments();
  /// Carries out T and M6 of the block. False: an error was reported.
  bool apply();
  /// A block with words was read.
  void end_block();
  /// Gives the tool in the spindle an entry in Program::tools. A tool without data is a fault only
  /// when it cuts.
  void require(const Word& where, bool cuts);
  /// Whether the tool of a lathe is a bar stop, a gripper or a probe by its comments: its feeds cut
  /// nothing.
  bool only_touches(const Word& where);
  /// Whether a comment gives a tool that has cut a usual size in inches.
  bool sized_in_inches() const;
  /// The tool in the spindle, or null.
  const Tool* current() const {
    return tool_.index >= 0 ? &program_.tools[static_cast<std::size_t>(tool_.index)] : nullptr;
  }
  /// The tool of the table with this number or name, or null.
  const Tool* given(const std::string& id) const { return data_.given(id); }
  const OffsetRegister* find_register(const std::string& name) const;
  /// The radius of the tool in the spindle, mm: that of the register of the cutting edge, else the
  /// tool's own; 0 without a tool. `edge` below 0: the tool's own.
  double radius(int edge);
  /// As radius(); a radius that is missing is an error, reported once for each tool.
  double radius_for(const std::string& cycle, int edge, const Word& where);
  /// What its register holds according to the tool's comments: "WEAR COMP", "CONTROL COMP".
  CompRadius commented_radius() const;

 private:
  bool cancels_offset(const Word& word);
  bool leaves_tool(const Word& word);
  std::string data_id();
  void hear_news(const Word& where);
  bool select(const Word& word);
  bool brings_waiting(const Word& word);
  bool brings_assumed();
  bool suffix(const Word& word);
  void change();
  bool next_is_pending() const;
  bool assume_pending();
  void take_commented(const Word& where);
  std::string id_of(const Word& word);
  std::size_t turret_digits() const;
  std::string mach_station(long number, std::size_t digits, const std::string& text,
                           const Word& word);
  void missing(const Word& where, const std::string& why, const Tool& read);
  const Tool* used_tool(const std::string& id) const;
  void use(Tool tool);

  ToolState& tool_;
  ToolNotes notes_;
  ToolData data_;
  ToolEdges edges_;
  std::unordered_map<std::string, int> used_;         ///< id -> tool of the program
  std::unordered_map<std::string, double> suffixes_;  ///< id -> T word with a suffix
};

}  // namespace mrsim
