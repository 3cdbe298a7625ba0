// Values of options: text to numbers, with errors that name the option.
#pragma once

#include <mrsim/compare.h>
#include <mrsim/options.h>
#include <mrsim/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mrsim::cli {

class TypedOptions;

/// Error "usage" of kind usage.
[[noreturn]] void fail_usage(const std::string& text);

/// The functions below give the value of an option from its text. They throw an Error of kind usage
/// that names the option.
double number_value(const std::string& option, const std::string& text);
/// A number above 0, mm.
double positive_value(const std::string& option, const std::string& text);
/// From `low` to `high`.
int whole_value(const std::string& option, const std::string& text, int low, int high);
/// A whole number from 1 to 1e15.
std::uint64_t count_value(const std::string& option, const std::string& text);
/// 1 to kMostWhole (core/words/option_table.h).
int threads_value(const std::string& option, const std::string& text);
/// A number of moments.
int frames_value(const std::string& option, const std::string& text);
/// "X,Y,Z"
Vec3 point_value(const std::string& option, const std::string& text);
/// Bytes: "4G", "500M", "1048576"; units K M G T are powers of 1024.
std::size_t size_value(const std::string& option, const std::string& text);
/// Bytes that --max-memory says, 0 where it was not typed; this thread keeps to them, or to what is
/// free, from now on.
std::size_t limit_memory(const TypedOptions& typed);
/// "on" or "off"
bool on_off_value(const std::string& option, const std::string& text);
/// One of the words that the table of options has for the option.
Dialect dialect_value(const std::string& option, const std::string& text);
MachineKind machine_value(const std::string& option, const std::string& text);
CompRadius comp_value(const std::string& option, const std::string& text);
ColorBy color_value(const std::string& option, const std::string& text);
Alignment align_value(const std::string& option, const std::string& text);
DeviationScheme scheme_value(const std::string& option, const std::string& text);
/// "wrap=W" or "wrap=W,G", mm
StockWrap wrap_value(const std::string& option, const std::string& text);
UpAxis up_value(const std::string& option, const std::string& text);
KeepPieces keep_value(const std::string& option, const std::string& text);
/// "0,2": levels of block skip, as the bits of InterpOptions::block_skip.
unsigned skip_value(const std::string& option, const std::string& text);

/// The folders and files, which must exist: a program that is looked for elsewhere may be another.
const std::vector<std::string>& existing_paths(const std::string& option,
                                               const std::vector<std::string>& paths);

}  // namespace mrsim::cli
