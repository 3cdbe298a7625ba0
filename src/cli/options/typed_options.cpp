#include "cli/options/typed_options.h"

#include "cli/options/option_values.h"
#include "core/process/error.h"
#include "core/words/suggest.h"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace mrsim::cli {
namespace {

constexpr std::size_t kColumn = 26, kWidth = 96;  // of the texts of --help

// One shape for all help: usage first, then groups, then examples.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(const CommandLine& line) : line_(line) { column_width(kColumn); }
  std::string make_usage(const CLI::App*, std::string) const override {
    return fmt::format("\nUsage: {}\n", line_.usage);
  }
  std::string make_positionals(const CLI::App*) const override { return ""; }
  std::string make_option(const CLI::Option* option, bool) const override {
    const std::string type = option->get_items_expected_max() > 0 ? option->get_type_name() : "";
    const std::string name =
        fmt::format("  {}{}{}", option->get_name(false, true), type.empty() ? "" : " ", type);
    return fmt::format("{:<{}}{}{}\n", name, kColumn,
                       name.size() >= kColumn ? "\n" + std::string(kColumn, ' ') : "",
                       wrapped(option->get_description()));
  }

 private:
  static std::string wrapped(const std::string& text) {
    std::string out;
    std::size_t column = kColumn, begin = 0;
    while (begin < text.size()) {
      std::size_t end = text.find(' ', begin);
      if (end == text.npos) end = text.size();
      if (column + (end - begin) > kWidth && column > kColumn) {
        out.back() = '\n';
        out += std::string(kColumn, ' ');
        column = kColumn;
      }
      out += text.substr(begin, end - begin) + " ";
      column += end - begin + 1;
      begin = end + 1;
    }
    return out.substr(0, out.find_last_not_of(' ') + 1);
  }
  const CommandLine& line_;
};

// CLI11 leaves two empty lines after each group.
std::string single_spaced(std::string text) {
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != text.npos;) text.erase(at, 1);
  return text;
}

// --stock "$BLOCK" of a variable that is not set would be a run without --stock: "" or what is
// wrong.
std::string empty_value(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (!option->get_positional() && std::find(values.begin(), values.end(), "") != values.end())
      return option->get_name() + " has an empty value";
  }
  return "";
}

// Refuses --stock= without a value, as --stock=$BLOCK may become, where CLI11 would take the next
// word for the value.
void refuse_empty_assignments(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with("--") && word.find('=') + 1 == word.size())
      throw CLI::ArgumentMismatch(
          fmt::format("{} has an empty value", word.substr(0, word.size() - 1)));
  }
}

}  // namespace

TypedOptions::TypedOptions(const CommandLine& line, int argc, const char* const* argv) {
  CLI::App app(line.summary);
  app.set_help_flag("");
  app.allow_extras();
  app.formatter(std::make_shared<HelpFormatter>(line));
  app.footer("\n" + std::string(line.examples));
  app.add_option("INPUT", inputs_)->expected(0, -1)->group("");
  for (const OptionGroup group : line.groups)
    for (const OptionRow& row : option_table()) {
      if (row.group != group || (row.uses & line.uses) == 0) continue;
      Typed& typed = typed_[row.name];
      known_.push_back(row.name);
      const std::string names =
          fmt::format("{}{}{}", row.letter, row.letter.empty() ? "" : ",", row.name);
      const std::string title(group_title(group)), help(row.help);
      if (row.value == OptionValue::flag)
        app.add_flag(names, typed.flag, help)->group(title);
      else if (is_repeated(row.value))
        app.add_option(names, typed.texts, help)
            ->type_name(std::string(row.type))
            ->group(title)
            ->allow_extra_args(false);
      else
        app.add_option(names, typed.text, help)->type_name(std::string(row.type))->group(title);
    }
  try {
    refuse_empty_assignments(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    fault_ = error.what();
    read_paths(argc, argv);
    return;
  }
  fault_ = empty_value(app);
  unknown_ = app.remaining();
  if (flag("--help")) help_ = single_spaced(app.help());
}

// Finds the files of --json and the like on a command line that does not parse: "--json F",
// "--json=F", and --json without a file.
void TypedOptions::read_paths(int argc, const char* const* argv) {
  for (const OptionRow& row : option_table()) {
    const auto found = typed_.find(row.name);
    const bool lines = row.value == OptionValue::flag && row.name == "--json";
    if (found == typed_.end() || (row.value != OptionValue::path && !lines)) continue;
    for (int i = 1; i < argc; ++i) {
      const std::string_view word = argv[i];
      if (lines)
        found->second.flag |= word == row.name;
      else if (word == row.name && i + 1 < argc &&
               (argv[i + 1][0] != '-' || std::string_view(argv[i + 1]) == "-"))
        found->second.text = argv[i + 1];
      else if (word.starts_with(std::string(row.name) + "="))
        found->second.text = word.substr(row.name.size() + 1);
    }
  }
}

void TypedOptions::refuse_unknown() const {
  if (!fault_.empty()) fail_usage(fault_);
  for (const std::string& word : unknown_) {
    const std::string option = word.substr(0, word.find('='));
    fail_usage(fmt::format("unknown option {}{}", option, suggestion(option, known_)));
  }
}

const TypedOptions::Typed& TypedOptions::at(std::string_view name) const {
  static const Typed kNothing;
  const auto found = typed_.find(name);
  if (found != typed_.end()) return found->second;
  if (find_option(name) == nullptr)
    throw InternalError(fmt::format("{} is not in the table of options", name));
  return kNothing;
}

}  // namespace mrsim::cli
