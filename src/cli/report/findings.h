// Counts findings of a program and prints them: "file:line:column: error: text [code]", then the
// line and a caret.
#pragma once

#include "cli/options/arguments.h"
#include <mrsim/types.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace mrsim::cli {

/// Prints findings to stderr (JSON: to stdout) as they come and counts them.
class Findings {
 public:
  /// `program`: stands in each JSON object, for a run over several programs; empty: it does not.
  explicit Findings(const Arguments& arguments, std::string program = "");

  void add(const Diagnostic& diagnostic);
  /// Adds an error that no reader has found; it is about `path` unless it has a place of its own.
  void add(const Error& error, const std::string& path = "");
  void add(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) add(diagnostic);
  }

  std::size_t errors() const { return count_[static_cast<std::size_t>(Severity::error)]; }
  std::size_t warnings() const { return count_[static_cast<std::size_t>(Severity::warning)]; }
  std::size_t notes() const { return count_[static_cast<std::size_t>(Severity::note)]; }
  bool failed() const { return errors() > 0 || (strict_ && warnings() > 0); }
  /// "1 error, 0 warnings, 2 notes"
  std::string summary() const;

 private:
  bool fails(Severity severity) const {
    return severity == Severity::error || (strict_ && severity == Severity::warning);
  }
  std::string program_, other_file_;
  bool quiet_, strict_, json_, colours_;
  std::array<std::size_t, 3> count_{};
};

/// From now on a stop by the user is printed as an error, with --json as an object of its own line.
void tell_stop_as_finding(const Arguments& arguments);

/// The finding as text that ends with a line end. The line of the file and a caret follow errors
/// and warnings; tabs stay tabs, so that the caret stands right in any terminal.
std::string format_diagnostic(const Diagnostic& diagnostic, bool colours);

/// A fault that has no place in a file: "mrsim: error: text [code]".
std::string format_error(const std::string& text, const std::string& code, bool colours);

}  // namespace mrsim::cli
