// Splits a command line into options and words by the table of options. The values of options are
// read afterwards, so that all errors read alike.
#pragma once

#include "cli/options/command_lines.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim::cli {

class TypedOptions {
 public:
  /// Faults of the words are kept for refuse_unknown(), so that a refusal can be written to the
  /// files that the words name.
  TypedOptions(const CommandLine& line, int argc, const char* const* argv);

  /// Usage error for an option without its value, and for the first word that is no option, with
  /// the one that it may have meant.
  void refuse_unknown() const;
  /// Whether refuse_unknown() finds nothing.
  bool is_known() const { return fault_.empty() && unknown_.empty(); }

  const std::vector<std::string>& inputs() const { return inputs_; }
  /// Empty where the option was not typed, or is not one of the command.
  const std::string& text(std::string_view name) const { return at(name).text; }
  const std::vector<std::string>& texts(std::string_view name) const { return at(name).texts; }
  bool flag(std::string_view name) const { return at(name).flag; }
  bool has(std::string_view name) const { return !text(name).empty(); }

  /// Where `name` was typed: out = value(name, its text).
  template <class T, class Value>
  void read(const char* name, T& out, Value value) const {
    if (has(name)) out = value(name, text(name));
  }

  /// The text of --help; empty where it was not asked for.
  const std::string& help() const { return help_; }

 private:
  struct Typed {
    std::string text;
    std::vector<std::string> texts;
    bool flag = false;
  };
  const Typed& at(std::string_view name) const;
  void read_paths(int argc, const char* const* argv);

  std::map<std::string_view, Typed> typed_;
  std::vector<std::string_view> known_;  // in the order of --help
  std::vector<std::string> inputs_, unknown_;
  std::string help_, fault_;
};

}  // namespace mrsim::cli
