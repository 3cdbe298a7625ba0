// Numbers and files, independent of the locale. Reads have a limit, writes are whole or not at all.
#pragma once

#include "core/output/draft_file.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mrsim {

/// The number that is the whole of `text` ("+1.5", "-.2", "3." allowed; no blanks, no exponent
/// unless `exponent`); nothing when it is not one, or not finite.
std::optional<double> parse_number(std::string_view text, bool exponent = false);

/// The whole file. Throws Error "file-missing", "file-is-directory", "file-unreadable",
/// "file-too-large" (over `limit` bytes), "file-read-once" (a pipe that was read before), "memory".
std::string read_file(const std::string& path, std::size_t limit = std::size_t(4) << 30);

/// Writes `path` whole or not at all: a draft beside it, fsync, rename. On any exception,
/// from `writer` too, the old file is untouched and nothing is left behind. Throws Error
/// "output-folder", "output-unwritable", "output-full".
void write_file_atomically(const std::string& path,
                           const std::function<void(const ByteSink&)>& writer);

/// One file of a set, and who writes it.
struct OutputFile {
  std::string path;
  std::function<void(const ByteSink&)> writer;
};

/// Writes all files or none: every draft is complete before the first is renamed. Throws
/// what write_file_atomically throws.
void write_files_atomically(std::span<const OutputFile> files);

/// Bytes of a line of a program that findings show: one of a megabyte is no help on a terminal.
inline constexpr std::size_t kShownLine = 1000;

/// `bytes` as UTF-8: as it is when valid, else every byte read as Latin-2 (ISO 8859-2).
std::string to_utf8(std::string_view bytes);

/// `text` (UTF-8) for XML, inside attributes and between tags; control characters but tabs and line
/// ends become blanks.
std::string xml_escaped(std::string_view text);

}  // namespace mrsim
