// Findings with their place. It knows the block being read, so that a fault only needs its word.
// 100 findings of each kind are reported and the rest is counted, so that a damaged program does
// not fill the screen.
#pragma once

#include "interp/text/block.h"
#include "interp/text/motion_sink.h"

#include <map>
#include <string>
#include <unordered_set>
#include <vector>

namespace mrsim {

class Reporter {
 public:
  Reporter(MotionSink& sink, Program& program) : sink_(sink), program_(program) {}

  /// The place of the findings that follow.
  void set_place(int file, int line, int call, std::string_view text) {
    file_ = file;
    line_ = line;
    call_ = call;
    text_ = text;
  }

  /// From here on a line may be read more than once. A finding of a line is reported once.
  void set_repeating() { repeating_ = true; }

  /// The lines to come are not read: nothing in them is reported.
  void set_muted(bool muted) { muted_ = muted; }

  /// The text of set_place() no longer exists.
  void forget_text() { text_ = {}; }

  /// `column` is 0-based; `length` in bytes.
  void add(Severity severity, const char* code, const std::string& text, int column, int length);
  void add(Severity severity, const char* code, const std::string& text, const Word& word) {
    add(severity, code, text, word.column, word.length);
  }
  /// Reports at the place of a motion that was read earlier.
  void add_at(Severity severity, const char* code, const std::string& text, const Motion& motion);
  /// Reports only the first time in the run that `key` is used.
  void once(Severity severity, const char* code, const std::string& text, const Word& word,
            const std::string& key);
  void once_at(Severity severity, const char* code, const std::string& text, const Motion& motion,
               const std::string& key);
  /// Reports about the program as a whole.
  void add_general(Severity severity, const char* code, const std::string& text);

  /// Tells the sink that a variable got a value in the line being read.
  void assignment(std::string_view name, const std::string& value);

  std::size_t errors() const { return errors_; }

  /// At the end of the program: reports how many findings of a kind were counted only.
  void finish();

 private:
  struct Kind {
    Severity severity;
    std::string code;
    std::size_t count = 0;
  };

  bool is_told(Severity severity, const char* code, const SourcePlace& place, int call);
  void emit(Diagnostic diagnostic, int call);
  bool seen(const std::string& key);
  std::string line_text(int file, int line);

  MotionSink& sink_;
  Program& program_;
  int file_ = 0, line_ = 0, call_ = -1;
  std::string_view text_;
  bool repeating_ = false, muted_ = false;
  std::size_t errors_ = 0;
  int lookups_ = 0;
  std::unordered_set<std::string> seen_;
  std::map<std::string, std::size_t> again_;  ///< text of an error reported once -> how often again
  std::vector<Kind> kinds_;                   ///< in the order of their first findings; a few dozen
};

}  // namespace mrsim
