// Gives one block after another: from the program and its running subprograms, with repeats and
// ends. Private to src/interp.
#pragma once

#include "interp/calls/macros.h"
#include "interp/calls/subprogram.h"
#include "interp/control/control.h"
#include "interp/language/last_loop.h"
#include "interp/language/loop_watch.h"
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

/// A stretch of text to be run, and callbacks before and after it.
struct CallRequest {
  std::string file;
  Place begin;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();  ///< offset of its end
  long repeats = 1;
  bool counts_as_call = true;      ///< counts in levels() and in the places of findings
  std::function<void()> on_start;  ///< before every run
  std::function<void()> on_end;    ///< after every run
  std::function<void()> on_left;   ///< after the last run, when the caller is read again
};

/// Runs a subprogram from its header on.
inline CallRequest call_of(const SubprogramPlace& place, long repeats = 1) {
  CallRequest request;
  request.file = place.file;
  request.begin = {place.offset, place.line, 0};
  request.repeats = repeats;
  return request;
}

class BlockReader : public ControlPart {
 public:
  explicit BlockReader(Control& control);
  void set_language(LanguageReader* language) { parser_.set_language(language); }

  /// Finds the loops that never end.
  LoopWatch& watch() { return watch_; }

  /// Opens the main program, whose first `leader_lines` lines lie before the tape mark.
  void open(int leader_lines);
  /// Reads the next block. False: the text of the program, subprogram or stretch ends.
  bool next();
  /// Whether the main program has ended.
  bool finished() const { return stack_.empty(); }
  /// How many programs, subprograms and repeated parts are being read, with the main program.
  std::size_t depth() const { return stack_.size(); }
  /// How many calls are running, without repeated parts of a program.
  std::size_t levels() const { return levels_; }

  /// Whether a new program begins in this block, by a tape mark or a header, which ends the one
  /// being read. `program`: its O word, or null.
  bool ends_at_header(const Word* program);
  /// Runs a subprogram next, `repeats` times. False: an error was reported.
  bool call(const SubprogramName& name, long repeats, const Word& word);
  /// The place of a call in this line, as an index into Program::calls.
  int call_site(int line);
  /// Finds a subprogram. Nothing: it is missing, which was reported.
  std::optional<SubprogramPlace> locate(const SubprogramName& name, const Word& word);
  /// Warns once that a subprogram stands in the file in the lines `first` and `second`.
  void tell_second(const std::string& name, int first, int second, const Word& word);
  bool has_subprogram(const SubprogramName& name) { return subprograms_.find(name).has_value(); }
  /// As locate(), but reports nothing.
  std::optional<SubprogramPlace> find(const SubprogramName& name) {
    return subprograms_.find(name);
  }
  /// Runs a stretch of text next. False: an error was reported.
  bool enter(CallRequest request, const Word& word);
  /// The place of `position` in the line being read.
  Place place_at(std::size_t position) const;
  std::size_t position() const { return stack_.back().position; }
  /// Goes on in the line being read.
  void set_position(std::size_t position) { stack_.back().position = position; }
  /// Goes on at a place of the file being read. False: too many steps of loops and calls.
  bool jump(const Place& to);
  const std::string& file() const {
    return program_.files[static_cast<std::size_t>(stack_.back().file)];
  }
  /// DEFINE of SINUMERIK: a name is replaced by text in the program that is being read, or in all.
  void define_macro(const std::string& name, std::string_view text, bool everywhere);
  /// Replaces the line being read by `text`. False: too many steps of loops and calls.
  bool replace_line(std::string_view text);
  /// A block has made `motions` motions. In a program that repeats itself each one beyond the first
  /// counts as a step, because a cycle may make thousands; the first one does where the program
  /// jumps back behind it. False: too many steps.
  bool count_motions(std::size_t motions);
  /// Drops further runs of what is being read.
  void drop_repeats() { stack_.back().repeats = 0; }
  /// Ends the repeated parts of a program that surround the current position.
  void leave_stretches();
  /// The text has ended without a word that ends it.
  void end_of_text();
  /// Ends what is being read: the next run of a subprogram follows, or its caller. `loops`: by M99.
  void end_activation(bool loops);
  /// Ends the main program.
  void end_program();
  void stop();

 private:
  /// A program being read: the main one, or a running subprogram.
  struct Activation {
    std::unique_ptr<LineSource> source;
    std::string_view line;
    int line_number = 0;
    std::vector<char> joined;  ///< the line, if others continue it or names are replaced
    Macros macros;
    std::uint64_t line_offset = 0;
    std::size_t position = 0;
    std::size_t resume = 0;  ///< position in the next line where reading goes on
    bool has_line = false;
    bool replaced = false;  ///< the line is not one of the file
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
  bool count_steps(std::uint64_t steps);
  void pop();
  std::unique_ptr<LineSource> source_of(const std::string& file);
  int file_index(const std::string& file);
  void warn_of_header(const Word& header, const std::string& name);
  void missing_return();
  void end_of_tape(bool commented);
  void tell_of_others();

  Parser parser_;
  LoopWatch watch_;
  SubprogramIndex subprograms_;
  std::vector<Activation> stack_;
  Macros macros_;            ///< the names of files of definitions
  std::size_t levels_ = 0;   ///< running calls
  std::uint64_t steps_ = 0;  ///< jumps, calls and repeats so far
  std::uint64_t steps_behind_error_ = 0;
  LastLoop loop_;
  std::uint64_t moved_ = 0;       ///< blocks with motions since the last jump back
  std::set<std::string> called_;  ///< programs, "O2" or "ONAME"
  std::map<std::string, std::vector<std::unique_ptr<LineSource>>>
      idle_;  ///< open files to be used again
};

}  // namespace mrsim
