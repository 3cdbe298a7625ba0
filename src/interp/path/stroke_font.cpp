#include "interp/path/stroke_font.h"

namespace mrsim {
namespace {

constexpr double kCapitalHeight = 21;
constexpr int kBaseLine = 9;

// Points begin behind the glyph's two edges.
void add_glyph(std::string_view glyph, TextStrokes& out) {
  const int left = glyph[0] - 'R';
  bool down = false;
  for (std::size_t i = 2; i + 1 < glyph.size(); i += 2) {
    if (glyph[i] == ' ') {
      down = false;
      continue;
    }
    if (!down) out.strokes.emplace_back();
    down = true;
    out.strokes.back().push_back({out.width + (glyph[i] - 'R' - left) / kCapitalHeight,
                                  (kBaseLine - (glyph[i + 1] - 'R')) / kCapitalHeight});
  }
  out.width += (glyph[1] - glyph[0]) / kCapitalHeight;
}

}  // namespace

TextStrokes text_strokes(std::string_view text) {
  TextStrokes out;
  for (const char c : text)
    if (c >= ' ' && c <= '~') add_glyph(kStrokeFont[c - ' '], out);
  return out;
}

}  // namespace mrsim
