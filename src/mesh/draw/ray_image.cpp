#include "mesh/draw/ray_image.h"

#include "core/numbers/rounding.h"
#include "core/process/parallel.h"
#include "mesh/solid/check.h"
#include "mesh/solid/half_edges.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

enum class Kind : std::uint8_t { nothing, part, ground };

// What a ray has met, and the light there.
struct Surfel {
  Vec3 position, normal, face_normal;
  std::uint32_t face = 0;
  Color paint;
  Kind kind = Kind::nothing;
};

// Shares of sky and key light that a place sees.
struct Seen {
  float sky = 1, key = 1;
  friend bool operator==(const Seen&, const Seen&) = default;
};

// Rows of the picture from `begin` to before `end`.
struct Rows {
  int begin = 0, end = 0;
};

// Pictures are drawn in bands, so that memory does not grow with their height. Light is smoothed
// over up to 12 rows and borrowed over one: a band is worked out with so many more on both sides
// that it is the same as in one piece.
constexpr int kMarginRows = 16, kBandRows = kMostHeldRows - 2 * kMarginRows;

class RayImage {
 public:
  RayImage(const RayImageInput& in, Rows held, Picture& picture);
  void draw(Rows wanted);

 private:
  Surfel trace(Vec2 pixel) const;
  Surfel part_surfel(const RayHit& hit, const Vec3& direction) const;
  Surfel ground_surfel(const Vec3& direction) const;
  Seen light(const Surfel& s, int x, int y) const;
  Seen smoothed(const std::vector<Seen>& from, int x, int y, int stride) const;
  bool same_surface(const Surfel& a, const Surfel& b) const;
  bool is_border(int x, int y) const;
  Color color_of(const Surfel& s, const Seen& seen, Vec2 pixel) const;
  Color supersampled(int x, int y) const;
  Seen borrowed_light(const Surfel& s, int x, int y) const;
  std::size_t index(int x, int y) const { return std::size_t(y - rows_.begin) * width_ + x; }
  const Surfel& at(int x, int y) const { return surfels_[index(x, y)]; }
  void each_pixel(Rows rows, const std::function<void(int, int)>& body) const;

  const RayImageInput& in_;
  Picture& picture_;
  Rows rows_;  // the rows of pixels that surfels_ holds
  int width_, height_;
  Studio studio_;
  Box3 box_;
  double size_ = 0;    // diagonal of the part
  double offset_ = 0;  // of rays from the surface they leave
  std::vector<Surfel> surfels_;
  std::vector<Seen> seen_;
  // The background, brighter above.
  Color top_ = to_linear({250, 251, 252}), bottom_ = to_linear({226, 230, 235});
};

RayImage::RayImage(const RayImageInput& in, Rows held, Picture& picture)
    : in_(in),
      picture_(picture),
      rows_(held),
      width_(picture.width()),
      height_(picture.height()),
      studio_(in.view) {
  box_ = mesh_bounds(in.mesh);
  size_ = std::max(length(box_.hi - box_.lo), 1e-3);
  offset_ = 4e-4 * size_;
  surfels_.resize(std::size_t(width_) * std::size_t(held.end - held.begin));
  seen_.resize(surfels_.size());
}

void RayImage::each_pixel(Rows rows, const std::function<void(int, int)>& body) const {
  parallel_for(std::size_t(rows.end - rows.begin), in_.options.threads, [&](std::size_t row) {
    for (int x = 0; x < width_; ++x) body(x, rows.begin + int(row));
  });
}

Surfel RayImage::part_surfel(const RayHit& hit, const Vec3& direction) const {
  Surfel s;
  s.kind = Kind::part;
  s.face = hit.face;
  s.position = in_.view.eye + hit.distance * direction;
  s.face_normal = in_.shape.face_normals[hit.face];
  const double weights[3] = {1.0 - hit.u - hit.v, hit.u, hit.v};
  Vec3 n;
  for (std::uint32_t k = 0; k < 3; ++k)
    n += weights[k] * to_vec(in_.shape.normals[3 * hit.face + k]);
  s.normal = normalized(n);
  if (dot(s.face_normal, direction) > 0) {  // the inside of an open mesh
    s.face_normal = -s.face_normal;
    s.normal = -s.normal;
  }
  s.paint = in_.paints[in_.paints.size() == 1 ? 0 : hit.face];
  if (!in_.mesh.colors.empty()) {
    s.paint = {};
    for (int k = 0; k < 3; ++k) {
      const Color c = to_linear(in_.mesh.colors[in_.mesh.triangles[hit.face][k]]);
      s.paint.r += float(weights[k]) * c.r;
      s.paint.g += float(weights[k]) * c.g;
      s.paint.b += float(weights[k]) * c.b;
    }
  }
  return s;
}

Surfel RayImage::ground_surfel(const Vec3& direction) const {
  Surfel s;
  if (!in_.options.ground || !(direction.z < 0) || !(in_.view.eye.z > box_.lo.z)) return s;
  s.position = in_.view.eye + (box_.lo.z - in_.view.eye.z) / direction.z * direction;
  const Box3 near = inflated(box_, 0.5 * size_);
  if (s.position.x < near.lo.x || s.position.x > near.hi.x || s.position.y < near.lo.y ||
      s.position.y > near.hi.y)
    return s;
  s.kind = Kind::ground;
  s.normal = s.face_normal = {0, 0, 1};
  return s;
}

Surfel RayImage::trace(Vec2 pixel) const {
  const Vec3 direction = in_.view.direction(pixel);
  const auto hit = in_.scene.first_hit(in_.view.eye, direction);
  return hit ? part_surfel(*hit, direction) : ground_surfel(direction);
}

Seen RayImage::light(const Surfel& s, int x, int y) const {
  if (s.kind == Kind::nothing) return {};
  const Vec3 from = s.position + offset_ * s.face_normal;
  int sky = kSkyRays, key = kKeyRays;
  if (in_.options.ambient_occlusion)
    for (int i = 0; i < kSkyRays; ++i)
      sky -=
          in_.scene.is_blocked(from, studio_.sky_direction(s.face_normal, x, y, i), 0.35 * size_);
  for (int i = 0; i < kKeyRays; ++i)
    key -= in_.scene.is_blocked(from, studio_.key_direction(x, y, i), 4 * size_);
  return {float(sky) / kSkyRays, float(key) / kKeyRays};
}

bool RayImage::same_surface(const Surfel& a, const Surfel& b) const {
  if (a.kind != b.kind || dot(a.normal, b.normal) < 0.9) return false;
  const Vec3 apart = b.position - a.position;
  return std::fabs(dot(a.normal, apart)) <= 0.3 * length(apart) + 0.1 * offset_;
}

// Each of the 16 turns has weight one in the 5 x 5 window: the outer rows count half. Later passes
// take the window wider.
Seen RayImage::smoothed(const std::vector<Seen>& from, int x, int y, int stride) const {
  const std::size_t middle = index(x, y);
  const Surfel& surfel = surfels_[middle];
  if (surfel.kind == Kind::nothing) return {};
  float sky = 0, key = 0, sum = 0;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const int column = x + i * stride, row = y + j * stride;
      if (column < 0 || row < rows_.begin || column >= width_ || row >= rows_.end) continue;
      const std::size_t at = index(column, row);
      if (from[at] == from[middle] ? surfels_[at].kind != surfel.kind
                                   : !same_surface(surfel, surfels_[at]))
        continue;
      const float weight = (std::abs(i) == 2 ? 0.5f : 1) * (std::abs(j) == 2 ? 0.5f : 1);
      sky += weight * from[at].sky;
      key += weight * from[at].key;
      sum += weight;
    }
  return {sky / sum, key / sum};
}

bool RayImage::is_border(int x, int y) const {
  const Surfel& s = at(x, y);
  const int next[4][2] = {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
  for (const auto& [i, j] : next) {
    if (i < 0 || j < rows_.begin || i >= width_ || j >= rows_.end) continue;
    const Surfel& other = at(i, j);
    const bool both_behind = s.kind != Kind::part && other.kind != Kind::part;
    if (both_behind || (s.kind == other.kind && s.face == other.face)) continue;
    if (!same_surface(s, other) || dot(s.normal, other.normal) < 0.98 ||
        std::fabs(s.paint.r - other.paint.r) + std::fabs(s.paint.g - other.paint.g) +
                std::fabs(s.paint.b - other.paint.b) >
            0.02f)
      return true;
  }
  return false;
}

Color RayImage::color_of(const Surfel& s, const Seen& seen, Vec2 pixel) const {
  if (s.kind == Kind::part)
    return studio_.shade(s.paint, s.normal, normalized(in_.view.eye - s.position), seen.sky,
                         seen.key);
  const Color back = mix(top_, bottom_, float(pixel.y / height_));
  if (s.kind == Kind::nothing) return back;
  const float left = (1 - 0.55f * (1 - seen.sky)) * (1 - 0.25f * (1 - seen.key));
  return {back.r * left, back.g * left, back.b * (left + 0.02f * (1 - left))};
}

// Light changes little along a surface, so the light of the best matching neighbour is used.
Seen RayImage::borrowed_light(const Surfel& s, int x, int y) const {
  double least = kInfinity;
  Seen best;
  for (int j = std::max(y - 1, rows_.begin); j <= std::min(y + 1, rows_.end - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i) {
      const Surfel& other = at(i, j);
      if (other.kind != s.kind) continue;
      const Vec3 apart = other.position - s.position;
      const double misfit = 1 - dot(s.normal, other.normal) +
                            (std::fabs(dot(s.normal, apart)) + 0.01 * length(apart)) / offset_;
      if (misfit >= least) continue;
      least = misfit;
      best = seen_[index(i, j)];
    }
  return best;
}

Color RayImage::supersampled(int x, int y) const {
  constexpr int kSide = 4;
  Color sum;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      // Rows and columns shifted against each other: 16 different heights and widths.
      const Vec2 pixel{x + (i + (j + 0.5) / kSide) / kSide, y + (j + (i + 0.5) / kSide) / kSide};
      const Surfel s = trace(pixel);
      const Color c = color_of(s, borrowed_light(s, x, y), pixel);
      sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
  constexpr float kShare = 1.0f / (kSide * kSide);
  return {kShare * sum.r, kShare * sum.g, kShare * sum.b};
}

void RayImage::draw(Rows wanted) {
  each_pixel(rows_, [&](int x, int y) {
    Surfel& s = surfels_[index(x, y)];
    s = trace({x + 0.5, y + 0.5});
    seen_[index(x, y)] = light(s, x, y);
  });
  for (const int stride : {1, 2, 3}) {
    const std::vector<Seen> before = seen_;
    each_pixel(rows_, [&](int x, int y) { seen_[index(x, y)] = smoothed(before, x, y, stride); });
  }
  each_pixel(wanted, [&](int x, int y) {
    picture_.at(x, y) = is_border(x, y)
                            ? supersampled(x, y)
                            : color_of(at(x, y), seen_[index(x, y)], {x + 0.5, y + 0.5});
  });
}

}  // namespace

void draw_surface(const RayImageInput& input, Picture& picture) {
  for (int row = 0; row < picture.height(); row += kBandRows) {
    const Rows band{row, std::min(row + kBandRows, picture.height())};
    const Rows held{std::max(band.begin - kMarginRows, 0),
                    std::min(band.end + kMarginRows, picture.height())};
    RayImage(input, held, picture).draw(band);
  }
}

}  // namespace mrsim
