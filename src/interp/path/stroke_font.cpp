#include "interp/path/stroke_font.h"

#include <algorithm>
#include <limits>

namespace mrsim {
namespace {

constexpr double kCapitalHeight = 21;
constexpr int kBaseLine = 9;

// Adds the strokes of a glyph. Its points stand behind its two edges.
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
    if (font_has(c)) add_glyph(kStrokeFont[c - ' '], out);
  return out;
}

TextStrokes letter_strokes(char c) {
  TextStrokes out = text_strokes({&c, 1});
  if (out.strokes.empty()) return out;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const std::vector<Vec2>& stroke : out.strokes)
    for (const Vec2 p : stroke) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
  for (std::vector<Vec2>& stroke : out.strokes)
    for (Vec2& p : stroke) p.x -= left;
  out.width = right - left;
  return out;
}

}  // namespace mrsim
