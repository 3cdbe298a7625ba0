#include "mesh/draw/picture.h"

#include "core/process/error.h"

#include <algorithm>
#include <cmath>

#include <png.h>

namespace mrsim {
namespace {

float linear_of(int srgb) {
  const double c = srgb / 255.0;
  return float(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

double srgb_of(double c) {
  c = std::clamp(c, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

// Tabulated: a picture has millions of values, and 4096 steps are finer than 8 bits anywhere.
class SrgbTable {
 public:
  SrgbTable() {
    for (int i = 0; i <= kSize; ++i)
      values_[i] = float(255 * srgb_of(double(i) * i / (double(kSize) * kSize)));
  }
  // `dither` in [0, 1) hides the steps of 8 bits in soft shades.
  png_byte operator()(float c, float dither) const {
    const int i = int(std::lround(std::sqrt(std::clamp(c, 0.0f, 1.0f)) * kSize));
    return png_byte(std::min(255, int(values_[i] + dither)));
  }

 private:
  static constexpr int kSize = 4096;
  float values_[kSize + 1];
};

void append_bytes(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}

[[noreturn]] void fail_png(png_structp, png_const_charp text) {
  throw Error("png", std::string("the picture cannot be written: ") + text);
}

void blend_pixel(Color& pixel, const Color& color, double share) {
  pixel = mix(pixel, color, float(share));
}

}  // namespace

Color to_linear(const Rgb& c) { return {linear_of(c[0]), linear_of(c[1]), linear_of(c[2])}; }

Rgb to_srgb(const Color& c) {
  const auto byte = [](float x) {
    return std::uint8_t(std::lround(255 * srgb_of(std::clamp(double(x), 0.0, 1.0))));
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

double stroke_coverage(Vec2 p, Vec2 from, Vec2 to, double width) {
  const Vec2 along = to - from, off = p - from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(off, along) / squared, 0.0, 1.0) : 0;
  const double distance = length(off - t * along);
  // Lines thinner than a pixel fade instead of breaking up.
  const double half = std::max(width, 1.0) / 2;
  return std::clamp(half + 0.5 - distance, 0.0, 1.0) * std::min(width, 1.0);
}

void Picture::stroke(Vec2 from, Vec2 to, double width, const Color& color, double opacity) {
  const double reach = width / 2 + 1;
  const int x0 = std::max(0, int(std::min(from.x, to.x) - reach));
  const int y0 = std::max(0, int(std::min(from.y, to.y) - reach));
  const int x1 = std::min(width_ - 1, int(std::max(from.x, to.x) + reach));
  const int y1 = std::min(height() - 1, int(std::max(from.y, to.y) + reach));
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      if (const double c = stroke_coverage({x + 0.5, y + 0.5}, from, to, width); c > 0)
        blend_pixel(at(x, y), color, c * opacity);
}

void Picture::fill_box(Vec2 corner, Vec2 size, double radius, const Color& color, double opacity) {
  const Vec2 middle = corner + 0.5 * size;
  for (int y = std::max(0, int(corner.y) - 1); y < std::min(height(), int(corner.y + size.y) + 2);
       ++y)
    for (int x = std::max(0, int(corner.x) - 1); x < std::min(width_, int(corner.x + size.x) + 2);
         ++x) {
      const double dx = std::fabs(x + 0.5 - middle.x) - size.x / 2 + radius;
      const double dy = std::fabs(y + 0.5 - middle.y) - size.y / 2 + radius;
      const double outside = length(Vec2{std::max(dx, 0.0), std::max(dy, 0.0)}) +
                             std::min(std::max(dx, dy), 0.0) - radius;
      if (const double c = std::clamp(0.5 - outside, 0.0, 1.0); c > 0)
        blend_pixel(at(x, y), color, c * opacity);
    }
}

void write_png(const Picture& picture, const ByteSink& out) {
  static const SrgbTable kSrgb;
  // A 4 x 4 ordered pattern, the same in every picture.
  static constexpr float kDither[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail_png, nullptr);
  MRSIM_ASSERT(png != nullptr);
  png_infop info = png_create_info_struct(png);
  MRSIM_ASSERT(info != nullptr);
  png_set_write_fn(png, &bytes, append_bytes, nullptr);
  png_set_IHDR(png, info, png_uint_32(picture.width()), png_uint_32(picture.height()), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
               PNG_FILTER_TYPE_BASE);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 4);
  png_set_filter(png, 0, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_write_info(png, info);
  std::vector<png_byte> row(3 * std::size_t(picture.width()));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Color& c = picture.at(x, y);
      const float dither = (kDither[4 * (y % 4) + x % 4] + 0.5f) / 16;
      row[3 * std::size_t(x)] = kSrgb(c.r, dither);
      row[3 * std::size_t(x) + 1] = kSrgb(c.g, dither);
      row[3 * std::size_t(x) + 2] = kSrgb(c.b, dither);
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  out(bytes.data(), bytes.size());
}

}  // namespace mrsim
