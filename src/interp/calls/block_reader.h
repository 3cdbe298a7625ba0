// Where blocks come from: the program and the subprograms under way, their repeats and ends.
// Private to src/interp.
#pragma once

#include "interp/calls/macros.h"
#include "interp/calls/subprogram.h"
#include "interp/control/control.h"
#include "interp/language/program_outline.h"
#include "interp/text/parser.h"
#include "interp/text/source.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace mrsim {

/// A stretch of text to be run, and what is to happen about it.
struct CallRequest {
  std::string file;
  Place begin;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();  ///< offset where it ends
  long repeats = 1;
  bool counts_as_call = true;      ///< in the depth, and in the places of findings
  std::function<void()> on_start;  ///< before every run
  std::function<void()> on_end;    ///< after every run
  std::function<void()> on_left;   ///< after the last run, once the caller is read again
};

class BlockReader : public ControlPart {
 public:
  explicit BlockReader(Control& control);
  void set_language(LanguageReader* language) { parser_.set_language(language); }

  /// Opens the main program; its first `leader_lines` lines lie before the tape mark.
  void open(int leader_lines);
  /// The next block of what is being read. False: its text ends.
  bool next();
  /// The main program has ended.
  bool finished() const { return stack_.empty(); }
  /// Subprograms under way, the main program included.
  std::size_t depth() const { return stack_.size(); }
  /// Calls under way, without repeated parts of a program.
  std::size_t levels() const { return levels_; }

  /// Tape marks and headers: whether a new program begins in this block, which ends the one being
  /// read. `program`: its O word, or null.
  bool ends_at_header(const Word* program);
  /// Goes on with a subprogram, `repeats` times. False: an error was reported.
  bool call(const SubprogramName& name, long repeats, const Word& word);
  /// The place of a call in this line, as an index into Program::calls.
  int call_site(int line);
  /// Where a subprogram is; reports what is missing.
  std::optional<SubprogramPlace> locate(const SubprogramName& name, const Word& word);
  bool has_subprogram(const SubprogramName& name) { return subprograms_.find(name).has_value(); }
  /// Goes on with a stretch of text. False: an error was reported.
  bool enter(CallRequest request, const Word& word);
  /// Where `position` of the line being read is.
  Place place_at(std::size_t position) const;
  std::size_t position() const { return stack_.back().position; }
  /// Goes on in the line being read.
  void set_position(std::size_t position) { stack_.back().position = position; }
  /// Goes on at a place of the file being read. False: too many steps of loops and calls.
  bool jump(const Place& to);
  const std::string& file() const {
    return program_.files[static_cast<std::size_t>(stack_.back().file)];
  }
  /// DEFINE of SINUMERIK: a name that stands for text in the program that is being read, or in all.
  void define_macro(const std::string& name, std::string_view text, bool everywhere);
  /// `text` stands for the line being read. False: too many steps of loops and calls.
  bool replace_line(std::string_view text);
  /// A block has made `motions`: in a program that repeats itself each beyond the first is a step,
  /// for a cycle may make thousands each time. False: too many steps of loops and calls.
  bool count_motions(std::size_t motions);
  /// No further runs of what is being read.
  void drop_repeats() { stack_.back().repeats = 0; }
  /// Ends the repeated parts of a program that surround the current position.
  void leave_stretches();
  /// The text ended without a word that says so.
  void end_of_text();
  /// The end of what is being read: the next run of a subprogram, or its caller. `loops`: by M99.
  void end_activation(bool loops);
  /// The main program has come to its end.
  void end_program();
  void stop();

 private:
  /// A program being read: the main one, or a subprogram under way.
  struct Activation {
    std::unique_ptr<LineSource> source;
    std::string_view line;
    int line_number = 0;
    std::vector<char> joined;  ///< the line, where others continue it or names stand for text
    Macros macros;
    std::uint64_t line_offset = 0;
    std::size_t position = 0;
    std::size_t resume = 0;  ///< position in the next line where reading goes on
    bool has_line = false;
    bool replaced = false;  ///< the line is none of the file's
    bool started = false;   ///< a block was executed
    int file = 0;
    int call = -1;
    int repeats = 0;  ///< further runs after this one
    Place begin;
    std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
    bool counts_as_call = true;
    std::function<void()> on_start, on_end, on_left;
  };

  Activation& program_read();
  bool read_line(Activation& top);
  void join_lines(Activation& top);
  bool count_steps(std::uint64_t steps);
  void pop();
  std::unique_ptr<LineSource> source_of(const std::string& file);
  int file_index(const std::string& file);
  void missing_return();
  void end_of_tape(bool commented);
  void tell_of_others();

  Parser parser_;
  SubprogramIndex subprograms_;
  std::vector<Activation> stack_;
  Macros macros_;                 ///< of files of definitions
  std::size_t levels_ = 0;        ///< calls under way
  std::uint64_t steps_ = 0;       ///< jumps, calls and repeats
  std::set<std::string> called_;  ///< programs, "O2" or "ONAME"
  std::map<std::string, std::vector<std::unique_ptr<LineSource>>> idle_;  ///< to be used again
};

}  // namespace mrsim
