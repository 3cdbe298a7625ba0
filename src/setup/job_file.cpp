#include "setup/job_file.h"

#include "core/output/real_path.h"
#include "core/text/text_io.h"
#include "core/words/option_table.h"
#include "core/words/suggest.h"
#include "setup/toml_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

namespace mrsim {
namespace {

constexpr std::size_t kJobFileLimit = std::size_t(1) << 20;
constexpr double kLargest = 1e6, kLargestCount = 1e15;

using Value = OptionValue;

// The keys of the table of options, and the program, which is an input on the command line. The
// option's own check follows when the command line is read; here stands what can be refused with
// line and column.
std::vector<OptionRow> job_keys() {
  std::vector<OptionRow> keys = {
      {"", "", kUseRun, OptionGroup::program, Value::path, "", "", "program"}};
  for (const OptionRow& row : option_table())
    if (!row.key.empty()) keys.push_back(row);
  return keys;
}

class JobReader {
 public:
  JobReader(std::string_view text, const std::string& name, bool allow_outside)
      : text_(text), name_(name), allow_outside_(allow_outside) {}
  JobFile read() const;

 private:
  [[noreturn]] void fail(const toml::source_position& at, const char* code,
                         const std::string& what) const {
    fail_at(at, text_, name_, code, what);
  }
  [[noreturn]] void fail_value(const OptionRow& key, const toml::node& node,
                               const std::string& what) const {
    fail(node.source().begin, "job-value", fmt::format("{} {}", key.key, what));
  }
  void check_keys(const toml::table& root) const;
  std::string text(const OptionRow& key, const toml::node& node) const;
  std::string path(const OptionRow& key, const toml::node& node) const;
  std::string stock(const OptionRow& key, const toml::node& node) const;
  std::string choice(const OptionRow& key, const toml::node& node) const;
  double number(const OptionRow& key, const toml::node& node, double largest = kLargest) const;
  std::string positive(const OptionRow& key, const toml::node& node) const;
  std::string whole(const OptionRow& key, const toml::node& node) const;
  std::string numbers(const OptionRow& key, const toml::node& node) const;
  bool flag(const OptionRow& key, const toml::node& node) const;
  std::string single(const OptionRow& key, const toml::node& node) const;
  std::vector<std::string> list(const OptionRow& key, const toml::node& node) const;
  std::vector<std::string> variables(const OptionRow& key, const toml::table& table) const;
  void read_machine_table(JobFile& job, const OptionRow& key, const toml::table& table) const;
  void read_program(JobFile& job, const OptionRow& key, const toml::node& node) const;
  void read_key(JobFile& job, const OptionRow& key, const toml::node& node) const;

  std::string_view text_;
  const std::string& name_;
  bool allow_outside_;
  std::vector<OptionRow> keys_ = job_keys();
};

void JobReader::check_keys(const toml::table& root) const {
  std::vector<std::string_view> known;
  known.reserve(keys_.size());
  for (const OptionRow& key : keys_) known.push_back(key.key);
  for (const auto& [key, node] : root) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string hint = suggestion(key.str(), known);
    if (hint.empty()) hint = fmt::format("; known here: {}", fmt::join(known, " "));
    fail(key.source().begin, "job-key", fmt::format("unknown key \"{}\"{}", key.str(), hint));
  }
}

std::string JobReader::text(const OptionRow& key, const toml::node& node) const {
  const auto* value = node.as_string();
  if (value == nullptr || value->get().empty()) fail_value(key, node, "must be a text");
  // Names of files and words of a command line end there.
  if (value->get().find('\0') != std::string::npos)
    fail_value(key, node, "must be a text without \\u0000");
  return value->get();
}

std::string JobReader::path(const OptionRow& key, const toml::node& node) const {
  const std::filesystem::path value = text(key, node);
  const std::filesystem::path folder = std::filesystem::path(name_).parent_path();
  const std::filesystem::path whole = (folder / value).lexically_normal();
  // A link in a folder that is not the user's own may name any file of the machine.
  const auto leads_out = [&] {
    return *value.lexically_normal().begin() == ".." ||
           !lies_in(real_path(whole), real_path(folder.empty() ? "." : folder));
  };
  if (!allow_outside_ && value.is_relative() && value != "-" && leads_out())
    fail(node.source().begin, "job-outside",
         fmt::format("{} \"{}\" leads out of the job's folder: give an absolute path, or "
                     "--allow-outside on the command line",
                     key.key, value.string()));
  // What was checked: "link/../a.stl" is a.stl, wherever the link leads.
  return value == "-" ? value.string() : whole.string();
}

std::string JobReader::stock(const OptionRow& key, const toml::node& node) const {
  std::string value = text(key, node);
  for (const std::string_view kind : option_words(key))
    if (value.starts_with(kind)) return value;
  return path(key, node);
}

std::string JobReader::choice(const OptionRow& key, const toml::node& node) const {
  std::string value = text(key, node);
  const std::vector<std::string_view> words = option_words(key);
  if (std::find(words.begin(), words.end(), value) == words.end())
    fail_value(key, node,
               fmt::format("\"{}\" is unknown{} (known: {})", value, suggestion(value, words),
                           fmt::join(words, " ")));
  return value;
}

double JobReader::number(const OptionRow& key, const toml::node& node, double largest) const {
  const std::optional<double> value = finite_number(node);
  if (!value) fail_value(key, node, "must be a number");
  if (std::fabs(*value) > largest)
    fail_value(key, node, fmt::format("is too large: at most {:g}", largest));
  return *value;
}

std::string JobReader::positive(const OptionRow& key, const toml::node& node) const {
  const double value = number(key, node, key.type == "N" ? kLargestCount : kLargest);
  if (!(value > 0)) fail_value(key, node, "must be above 0");
  return fmt::format("{}", value);
}

std::string JobReader::whole(const OptionRow& key, const toml::node& node) const {
  const auto* value = node.as_integer();
  if (value == nullptr || value->get() < 1 || value->get() > kMostWhole)
    fail_value(key, node, fmt::format("must be a whole number from 1 to {}", kMostWhole));
  return std::to_string(value->get());
}

std::string JobReader::numbers(const OptionRow& key, const toml::node& node) const {
  std::string out;
  if (const toml::array* row = node.as_array()) {
    for (const toml::node& item : *row)
      out += fmt::format("{}{}", out.empty() ? "" : ",", number(key, item));
    if (out.empty()) fail_value(key, node, "is an empty list");
    return out;
  }
  return fmt::format("{}", number(key, node));
}

bool JobReader::flag(const OptionRow& key, const toml::node& node) const {
  const auto* value = node.as_boolean();
  if (value == nullptr) fail_value(key, node, "must be true or false");
  return value->get();
}

std::string JobReader::single(const OptionRow& key, const toml::node& node) const {
  switch (key.value) {
    case Value::text:
    case Value::texts:
      return text(key, node);
    case Value::path:
    case Value::paths:
    case Value::folders:
      return path(key, node);
    case Value::path_or_off:
      return text(key, node) == "off" ? "off" : path(key, node);
    case Value::stock:
      return stock(key, node);
    case Value::choice:
      return choice(key, node);
    case Value::number:
      return positive(key, node);
    case Value::whole:
      return whole(key, node);
    case Value::numbers:
      return numbers(key, node);
    case Value::flag:
    case Value::on_off:
      break;
  }
  return flag(key, node) ? "on" : "off";
}

std::vector<std::string> JobReader::list(const OptionRow& key, const toml::node& node) const {
  const toml::array* items = node.as_array();
  if (items == nullptr || !is_repeated(key.value)) return {single(key, node)};
  std::vector<std::string> out;
  for (const toml::node& item : *items) out.push_back(single(key, item));
  return out;
}

// The table [machine]: its kind is the option --machine, the rest is read from this file again
// (machine_file.h).
void JobReader::read_machine_table(JobFile& job, const OptionRow& key,
                                   const toml::table& table) const {
  if (const toml::node* kind = table.get("kind"))
    job.options.push_back({"--machine", {choice(key, *kind)}});
  job.options.push_back({"--machine-file", {name_}});
}

// The table [variables]: "#100" = 2, R1 = 5.0, NAME = "A".
std::vector<std::string> JobReader::variables(const OptionRow& key,
                                              const toml::table& table) const {
  std::vector<std::string> out;
  for (const auto& [name, node] : table)
    out.push_back(
        fmt::format("{}={}", name.str(),
                    node.is_string() ? text(key, node) : fmt::format("{}", number(key, node))));
  return out;
}

// `machine` is a key and the name of a table, and TOML allows one of them.
std::string with_hint(const std::string& why) {
  if (why.find("string 'machine' as table") == std::string::npos) return why;
  return why + ": leave the key machine out, and write kind = \"mill\" or \"lathe\" in the table";
}

void JobReader::read_program(JobFile& job, const OptionRow& key, const toml::node& node) const {
  job.program = list(key, node)[0];
  job.line = static_cast<int>(node.source().begin.line);
  job.column = static_cast<int>(node.source().begin.column);
  // A name is no option: "--help".
  if (job.program.size() > 1 && job.program[0] == '-') job.program.insert(0, "./");
  if (std::filesystem::path(job.program).extension() == ".toml")
    fail_value(key, node, "must be an NC program, not another job");
}

void JobReader::read_key(JobFile& job, const OptionRow& key, const toml::node& node) const {
  if (key.name == "--machine" && node.is_table())
    return read_machine_table(job, key, *node.as_table());
  if (key.name.empty()) return read_program(job, key, node);
  if (key.name == "--set" && node.is_table()) {
    job.options.push_back({"--set", variables(key, *node.as_table())});
    return;
  }
  if (key.value == Value::flag) {
    if (flag(key, node)) job.options.push_back({std::string(key.name), {}});
    return;
  }
  std::vector<std::string> values = list(key, node);
  if (values.empty()) return;
  job.options.push_back({std::string(key.name), std::move(values),
                         static_cast<int>(node.source().begin.line),
                         static_cast<int>(node.source().begin.column)});
}

JobFile JobReader::read() const {
  toml::table root;
  try {
    root = parse_toml(text_);
  } catch (const toml::parse_error& error) {
    fail(error.source().begin, "job-syntax", with_hint(std::string(error.description())));
  }
  check_keys(root);
  JobFile job;
  for (const OptionRow& key : keys_)
    if (const toml::node* node = root.get(key.key)) read_key(job, key, *node);
  if (job.program.empty()) fail({1, 1}, "job-value", "the job names no program");
  return job;
}

}  // namespace

JobFile parse_job(std::string_view text, const std::string& name, bool allow_outside) {
  return JobReader(text, name, allow_outside).read();
}

JobFile load_job_file(const std::string& path, bool allow_outside) {
  return parse_job(read_file(path, kJobFileLimit), path, allow_outside);
}

}  // namespace mrsim
