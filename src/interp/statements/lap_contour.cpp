#include "interp/statements/lap_contour.h"

#include "core/text/text_io.h"
#include "interp/text/characters.h"
#include "interp/text/line_scan.h"
#include "interp/text/source.h"

namespace mrsim {
namespace {

// Whether the block has this name, as "NLAP1 G81".
bool is_named(std::string_view code, std::string_view name) {
  const std::size_t at = code.find_first_not_of(" \t/");
  if (at == code.npos || !code.substr(at).starts_with(name)) return false;
  const std::size_t end = at + name.size();
  return end >= code.size() || !is_name(code[end]);
}

}  // namespace

std::optional<Place> find_named_block(const std::string& file, const Place& from, const Place& to,
                                      std::string_view name) {
  const std::string wanted = upper_case(name);
  LineSource source(file, std::size_t(1) << 16);
  source.seek(from.offset, from.line);
  std::string_view line;
  for (std::uint64_t offset = from.offset; offset < to.offset && source.next(line);
       offset = source.next_offset())
    if (is_named(upper_case(line), wanted)) return Place{offset, source.line_number() - 1, 0};
  return std::nullopt;
}

std::optional<LapContour> find_lap_contour(const std::string& file, const Place& from,
                                           const Place& to, std::string_view name) {
  const std::string wanted = upper_case(name);
  LineSource source(file, std::size_t(1) << 16);
  source.seek(from.offset, from.line);
  std::string_view line;
  LineScan scan;
  LapContour out;
  for (std::uint64_t offset = from.offset; offset < to.offset && source.next(line);
       offset = source.next_offset()) {
    scan_line(line, scan);
    const Place behind{source.next_offset(), source.line_number(), 0};
    if (out.number != 0 && has_word(scan.code, "G80")) {
      out.end = {offset, source.line_number() - 1, 0};
      out.behind = behind;
      return out;
    }
    if (!is_named(scan.code, wanted)) continue;
    for (const int g : {81, 82, 83})
      if (has_word(scan.code, "G" + std::to_string(g))) out.number = g;
    out.begin = behind;
  }
  return std::nullopt;
}

}  // namespace mrsim
