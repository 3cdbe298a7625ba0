// Findings with their place. Knows the block being read, so that a fault only needs its word.
#pragma once

#include "interp/block.h"
#include "interp/interpreter.h"

#include <string>
#include <unordered_set>
#include <vector>

namespace mrsim {

class Reporter {
 public:
  Reporter(MotionSink& sink, Program& program) : sink_(sink), program_(program) {}

  /// Where following findings are.
  void set_place(int file, int line, int call, std::string_view text) {
    file_ = file;
    line_ = line;
    call_ = call;
    text_ = text;
  }

  /// The buffer of the line is gone.
  void forget_text() { text_ = {}; }

  /// `column` is 0-based; `length` in bytes.
  void add(Severity severity, const char* code, const std::string& text, int column, int length);
  void add(Severity severity, const char* code, const std::string& text, const Word& word) {
    add(severity, code, text, word.column, word.length);
  }
  /// At the place of a motion that was read earlier.
  void add_at(Severity severity, const char* code, const std::string& text, const Motion& motion);
  /// Only the first time in the run that `key` is used.
  void once(Severity severity, const char* code, const std::string& text, const Word& word,
            const std::string& key);
  void once_at(Severity severity, const char* code, const std::string& text, const Motion& motion,
               const std::string& key);
  /// About the program as a whole.
  void add_general(Severity severity, const char* code, const std::string& text);

  std::size_t errors() const { return errors_; }

 private:
  void emit(Diagnostic diagnostic, int call);
  bool seen(const std::string& key);
  std::string line_text(int file, int line);

  MotionSink& sink_;
  Program& program_;
  int file_ = 0, line_ = 0, call_ = -1;
  std::string_view text_;
  std::size_t errors_ = 0;
  int lookups_ = 0;
  std::unordered_set<std::string> seen_;
};

}  // namespace mrsim
