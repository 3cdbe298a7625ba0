// TriMesh::origin and TriMesh::legend as lines of text, for the formats that keep comments.
#pragma once

#include <mrsim/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrsim {

/// "file 0 data/PRIMER_2F.MPF", "tool 0 4", "owner 37 0 12 0" (owner, file, line, tool).
std::vector<std::string> origin_lines(const OwnerTable& table);

/// "legend 20 76 168 +0.060 mm and more" (sRGB, text).
std::vector<std::string> legend_lines(const std::vector<ColorLabel>& legend);
inline constexpr std::size_t kMostLegend = 64;  ///< lines that are read
/// The label of such a line; nothing for others.
std::optional<ColorLabel> read_legend_line(std::string_view line);

/// Puts a table together from such lines; lines that are none are passed over.
class OriginReader {
 public:
  /// Takes a line. "group 37" says that the faces that follow belong to owner 37: it is returned.
  std::optional<std::int32_t> read(std::string_view line);
  /// The table: owners sorted, each once, references out of range cut off.
  OwnerTable take();

 private:
  OwnerTable table_;
};

}  // namespace mrsim
