// A picture in linear light with anti-aliased strokes, written as PNG.
#pragma once

#include "core/numbers/vec.h"
#include "core/text/text_io.h"
#include "mesh/draw/palette.h"

#include <vector>

namespace mrsim {

struct Color {  ///< linear light, 1 = white
  float r = 0, g = 0, b = 0;
};
/// Between sRGB and linear light.
Color to_linear(const Rgb& srgb);
Rgb to_srgb(const Color& linear);
/// `share` of b, the rest of a.
inline Color mix(const Color& a, const Color& b, float share) {
  return {a.r + (b.r - a.r) * share, a.g + (b.g - a.g) * share, a.b + (b.b - a.b) * share};
}

class Picture {
 public:
  Picture(int width, int height) : width_(width), pixels_(std::size_t(width) * height) {}
  int width() const { return width_; }
  int height() const { return int(pixels_.size() / std::size_t(width_)); }
  Color& at(int x, int y) { return pixels_[std::size_t(y) * width_ + x]; }
  const Color& at(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }

  /// A line with round ends; coordinates in pixels, (0, 0) the upper left corner of the picture.
  void stroke(Vec2 from, Vec2 to, double width, const Color& color, double opacity = 1);
  /// A rectangle with round corners.
  void fill_box(Vec2 corner, Vec2 size, double radius, const Color& color, double opacity = 1);

 private:
  int width_;
  std::vector<Color> pixels_;
};

/// How much of a pixel with its centre at `p` a line of that width covers, 0 to 1.
double stroke_coverage(Vec2 p, Vec2 from, Vec2 to, double width);

/// 8 bit sRGB; no time stamp, so equal pictures are equal files.
void write_png(const Picture& picture, const ByteSink& out);

}  // namespace mrsim
