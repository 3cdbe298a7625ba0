#include "cli/options/option_values.h"

#include "cli/options/typed_options.h"
#include "core/process/error.h"
#include "core/text/text_io.h"
#include "core/words/option_table.h"
#include "core/words/suggest.h"
#include <mrsim/memory.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mrsim::cli {
namespace {

constexpr double kLargest = 1e6;  // mm

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find(',', begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == text.npos) return parts;
    begin = end + 1;
  }
}

// `values` in the order of the option's words.
template <class T>
T choice(const std::string& option, const std::string& text, std::initializer_list<T> values) {
  const OptionRow* row = find_option(option);
  MRSIM_ASSERT(row != nullptr);
  const std::vector<std::string_view> words = option_words(*row);
  MRSIM_ASSERT(words.size() == values.size());
  const auto word = std::find(words.begin(), words.end(), text);
  if (word != words.end()) return values.begin()[word - words.begin()];
  fail_usage(fmt::format("{} \"{}\" is unknown{} (known: {})", option, text,
                         suggestion(text, words), fmt::join(words, ", ")));
}

}  // namespace

void fail_usage(const std::string& text) { throw Error("usage", text, Error::Kind::usage); }

double number_value(const std::string& option, const std::string& text) {
  const std::optional<double> value = parse_number(text, true);
  if (!value) fail_usage(fmt::format("{} \"{}\" is not a number", option, text));
  return *value;
}

double positive_value(const std::string& option, const std::string& text) {
  const double value = number_value(option, text);
  if (!(value > 0)) fail_usage(fmt::format("{} {} must be above 0, in mm", option, text));
  if (value > kLargest)
    fail_usage(fmt::format("{} {} is too large: at most {:g} mm", option, text, kLargest));
  return value;
}

int whole_value(const std::string& option, const std::string& text, int low, int high) {
  const double value = number_value(option, text);
  if (value < low || value > high || value != static_cast<int>(value))
    fail_usage(fmt::format("{} {} must be a whole number from {} to {}", option, text, low, high));
  return static_cast<int>(value);
}

std::uint64_t count_value(const std::string& option, const std::string& text) {
  const double value = number_value(option, text);
  if (!(value >= 1 && value <= 1e15) || value != std::floor(value))
    fail_usage(fmt::format("{} must be a whole number from 1 to 1e15, not {}", option, text));
  return static_cast<std::uint64_t>(value);
}

int threads_value(const std::string& option, const std::string& text) {
  if (number_value(option, text) > kMostWhole)
    fail_usage(fmt::format("{} {} are too many threads: {} at most", option, text, kMostWhole));
  return whole_value(option, text, 1, kMostWhole);
}

int frames_value(const std::string& option, const std::string& text) {
  return whole_value(option, text, 1, kMostWhole);
}

Vec3 point_value(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text);
  if (parts.size() != 3) fail_usage(fmt::format("{} \"{}\" must be X,Y,Z in mm", option, text));
  return {number_value(option, parts[0]), number_value(option, parts[1]),
          number_value(option, parts[2])};
}

std::size_t size_value(const std::string& option, const std::string& text) {
  constexpr std::string_view kUnits = "KMGT";
  std::string digits = text;
  double factor = 1;
  if (!digits.empty() && (digits.back() == 'B' || digits.back() == 'b')) digits.pop_back();
  if (!digits.empty()) {
    const char unit = digits.back() >= 'a' ? static_cast<char>(digits.back() - 32) : digits.back();
    const std::size_t power = kUnits.find(unit);
    if (power != kUnits.npos) {
      digits.pop_back();
      for (std::size_t i = 0; i <= power; ++i) factor *= 1024;
    }
  }
  const std::optional<double> value = parse_number(digits);
  if (!value || *value * factor < 1 || *value * factor > 1e18)
    fail_usage(fmt::format("{} \"{}\" must be a size such as 4G or 500M", option, text));
  return static_cast<std::size_t>(*value * factor);
}

std::size_t limit_memory(const TypedOptions& typed) {
  std::size_t bytes = 0;
  typed.read("--max-memory", bytes, size_value);
  set_memory_limit(bytes);
  return bytes;
}

bool on_off_value(const std::string& option, const std::string& text) {
  if (text != "on" && text != "off")
    fail_usage(fmt::format("{} \"{}\" must be on or off", option, text));
  return text == "on";
}

Dialect dialect_value(const std::string& option, const std::string& text) {
  return choice(option, text,
                {Dialect::sinumerik, Dialect::iso, Dialect::fanuc, Dialect::codesys, Dialect::ngc,
                 Dialect::automatic});
}

MachineKind machine_value(const std::string& option, const std::string& text) {
  return choice(option, text, {MachineKind::mill, MachineKind::lathe, MachineKind::automatic});
}

CompRadius comp_value(const std::string& option, const std::string& text) {
  return choice(option, text,
                {CompRadius::automatic, CompRadius::radius, CompRadius::wear, CompRadius::off});
}

ColorBy color_value(const std::string& option, const std::string& text) {
  return choice(option, text, {ColorBy::line, ColorBy::tool, ColorBy::none});
}

Alignment align_value(const std::string& option, const std::string& text) {
  return choice(option, text, {Alignment::none, Alignment::bbox, Alignment::icp});
}

DeviationScheme scheme_value(const std::string& option, const std::string& text) {
  return choice(option, text, {DeviationScheme::standard, DeviationScheme::safe});
}

StockWrap wrap_value(const std::string& option, const std::string& text) {
  constexpr std::string_view kWord = "wrap=";
  if (!text.starts_with(kWord))
    fail_usage(fmt::format("{} {}: wrap=W, such as wrap=0.2", option, text));
  const std::string values = text.substr(kWord.size());
  const std::size_t comma = values.find(',');
  StockWrap out{positive_value(option, values.substr(0, comma)), 0};
  if (comma != values.npos) out.gap = positive_value(option, values.substr(comma + 1));
  return out;
}

UpAxis up_value(const std::string& option, const std::string& text) {
  return choice(option, text, {UpAxis::x, UpAxis::z});
}

KeepPieces keep_value(const std::string& option, const std::string& text) {
  return choice(option, text, {KeepPieces::all, KeepPieces::largest});
}

unsigned skip_value(const std::string& option, const std::string& text) {
  unsigned bits = 0;
  for (const std::string& part : split(text)) bits |= 1u << whole_value(option, part, 0, 9);
  return bits;
}

const std::vector<std::string>& existing_paths(const std::string& option,
                                               const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::error_code fault;
    if (!std::filesystem::exists(path, fault))
      throw Error("file-missing", fmt::format("{} {}: no such folder", option, path));
    if (!std::filesystem::is_directory(path, fault) &&
        !std::filesystem::is_regular_file(path, fault))
      throw Error("file-kind", fmt::format("{} {}: neither a folder nor a file", option, path));
  }
  return paths;
}

}  // namespace mrsim::cli
