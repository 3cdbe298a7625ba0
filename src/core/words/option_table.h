// The one table of options: the command line, --help, completion, manual and job.toml read it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace mrsim {

/// Where an option may be typed; a bit each, so that a row of the table can hold several.
enum OptionUse : unsigned {
  kUseRun = 1,
  kUseTrace = 2,
  kUseCheck = 4,
  kUseCompare = 8,
  kUseRender = 16,  ///< a picture of a mesh
  kUseFilm = 32,    ///< render --frames: pictures of a run
  kUseRest = 64,
  kUseTools = 128,
  kUseView = 256,
};

/// Headings of --help and of the manual.
enum class OptionGroup : std::uint8_t { stock, cutting, comparison, program, picture, output };

enum class OptionValue : std::uint8_t {
  flag,    ///< the option is there or not
  on_off,  ///< typed as on or off; true or false in a job
  text,
  texts,    ///< the option may be repeated; a list in a job
  choice,   ///< one of OptionRow::words
  path,     ///< in a job: relative to its folder
  paths,    ///< as path, may be repeated
  folders,  ///< as paths
  path_or_off,
  stock,    ///< a path, or a primitive such as "box:..."
  number,   ///< above 0
  whole,    ///< 1 to kMostWhole
  numbers,  ///< one number, or several apart by commas
};

/// The largest OptionValue::whole.
inline constexpr int kMostWhole = 256;

struct OptionRow {
  std::string_view name;    ///< "--voxel"
  std::string_view letter;  ///< "-o", or empty
  unsigned uses;            ///< OptionUse
  OptionGroup group;
  OptionValue value;
  std::string_view type;         ///< what --help calls the value; empty for flags
  std::string_view help;         ///< after the name, in --help
  std::string_view key = {};     ///< of job.toml; empty: not for jobs
  std::string_view words = {};   ///< that the value may be or begin with, apart by spaces
  std::string_view manual = {};  ///< what the manual says instead of `help`
};

/// All options in the order of --help. A name stands in several rows where commands differ; the
/// manual has the first.
std::span<const OptionRow> option_table();

/// The first row of a name that is offered in one of `uses`, or nullptr.
const OptionRow* find_option(std::string_view name, unsigned uses = ~0u);

/// May be given several times.
constexpr bool is_repeated(OptionValue value) {
  return value == OptionValue::texts || value == OptionValue::paths ||
         value == OptionValue::folders;
}

/// The heading of a group of options in --help.
std::string_view group_title(OptionGroup group);

/// The words of a row, one by one.
std::vector<std::string_view> option_words(const OptionRow& row);

}  // namespace mrsim
