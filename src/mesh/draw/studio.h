// The studio: a soft key light from the upper left, a fill light from the right, a bright sky.
#pragma once

#include "core/numbers/vec.h"
#include "mesh/draw/picture.h"
#include "mesh/draw/view.h"

#include <array>
#include <vector>

namespace mrsim {

/// Pixels take turns with the directions they try, in squares of 4 x 4; averaged over a square
/// they have tried them all. A fixed pattern, so that pictures are the same every time.
inline constexpr int kTile = 4;
inline constexpr int kSkyRays = 5;  ///< a pixel
inline constexpr int kKeyRays = 2;

class Studio {
 public:
  explicit Studio(const View& view);

  /// Direction number `i` < kSkyRays to the sky about `normal`, for the pixel (x, y).
  Vec3 sky_direction(const Vec3& normal, int x, int y, int i) const;
  /// Direction number `i` < kKeyRays to the key light.
  Vec3 key_direction(int x, int y, int i) const;

  /// Light that a surface sends to the eye. `sky` and `key` are the shares of either that it sees.
  Color shade(const Color& paint, const Vec3& normal, const Vec3& to_eye, float sky,
              float key) const;

 private:
  Vec3 key_, fill_, key_x_, key_y_;
  std::vector<Vec3> sky_pattern_;
  std::vector<Vec2> key_pattern_, tile_turns_;
};

}  // namespace mrsim
