/// mrsim: what is told of faults. A program's faults are data, all of them in one run; a fault of a
/// file, an option or the machine ends the run and is thrown.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__GNUC__)
#define MRSIM_API __attribute__((visibility("default")))
#else
#define MRSIM_API
#endif

namespace mrsim {

/// A fault of a file, an option or the machine that ends the run. `code` is a short stable word
/// ("stl-truncated"), what() a sentence for a person. `usage` faults exit with 2, the others
/// with 1.
class MRSIM_API Error : public std::runtime_error {
 public:
  enum class Kind { input, usage };
  Error(std::string code, const std::string& text, Kind kind = Kind::input);
  ~Error() override;
  const std::string& code() const { return code_; }
  Kind kind() const { return kind_; }

 private:
  std::string code_;
  Kind kind_;
};

enum class Severity : std::uint8_t { note, warning, error };

/// A place in a file: 1-based line and column (in bytes), 0 = unknown.
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One finding about a text file, data rather than an exception: a run collects all of them.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;  ///< stable word, "arc-radius-too-small"
  std::string text;  ///< what is wrong and what to do, one sentence or two
  SourcePlace place;
  int length = 1;  ///< bytes to underline from place.column
  std::string
      source_line;  ///< the text of the line, UTF-8, without its end (shortened when very long)
  std::vector<SourcePlace> called_from;  ///< call chain, innermost first
};

/// An Error about one place in a text file (a tool table, a job): a Diagnostic that ends the run.
class MRSIM_API PlacedError : public Error {
 public:
  explicit PlacedError(Diagnostic diagnostic, Kind kind = Kind::input);
  ~PlacedError() override;
  const Diagnostic& diagnostic() const { return diagnostic_; }

 private:
  Diagnostic diagnostic_;
};

}  // namespace mrsim
