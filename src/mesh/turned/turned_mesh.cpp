#include "mesh/turned/turned_mesh.h"

#include "core/numbers/trig.h"
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "mesh/cells/mesh_memory.h"
#include "mesh/cells/step_timer.h"
#include "mesh/solid/check.h"
#include "mesh/solid/self_intersection.h"
#include "mesh/solid/vertex_lattice.h"
#include "mesh/turned/turned_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mrsim::detail {
namespace {

constexpr std::uint32_t kFewestSides = 24;  ///< of a ring: no facet is taken for a face of its own
constexpr std::uint32_t kMostSides = 1 << 20;
constexpr double kLowest = 1.0 / 64;  ///< of the tolerance: how exactly the outline is found
constexpr double kFinest = 1.0 / 8;   ///< of the tolerance: the smallest parts of a voxel
constexpr double kTriangleMemory = 170, kSquareMemory = 200;  ///< bytes, as measured
// Shares of the tolerance that chords may take; the sides of rings have the rest.
constexpr std::array<double, 8> kShares{0.06, 0.12, 0.25, 0.375, 0.5, 0.625, 0.75, 0.85};

double sagitta(double radius, std::uint32_t sides) {
  return radius * (1 - sincos(kPi / sides).cos);
}

std::uint32_t sides_for(double radius, double limit) {
  std::uint32_t low = 2, high = kFewestSides;
  while (high < kMostSides && sagitta(radius, high) > limit) low = high, high *= 2;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (sagitta(radius, middle) > limit ? low : high) = middle;
  }
  return std::max(high, kFewestSides);
}

/// Chooses how many sides a ring has: a base times a power of two, so that each corner of a ring is
/// at the angle of a corner of every ring with more sides. The base is a multiple of four, so that
/// diameters along X and Y are those of the part.
class TurnedSides {
 public:
  /// `least`, `most`: what the rings need.
  TurnedSides(std::uint32_t least, std::uint32_t most) {
    std::uint32_t step = 1;
    while (most / (2 * step) >= least) step *= 2;
    base_ = (most + 4 * step - 1) / (4 * step) * 4;
  }
  std::uint32_t at_least(std::uint32_t needed) const {
    std::uint32_t n = base_;
    while (n < needed) n *= 2;
    return n;
  }

 private:
  std::uint32_t base_;
};

/// A ring of vertices about the axis; a single vertex on it.
struct Ring {
  double radius = 0, z = 0;
  std::uint32_t first = 0, sides = 1;

  std::uint32_t vertex(std::uint32_t k) const { return first + k % sides; }
};

struct Strip {
  std::size_t from = 0, to = 0;  ///< rings, the material on the left of the way
  std::int32_t owner = kStockOwner;
  double height = 0;
};

/// What the triangles are made of, and how many there will be.
struct Rings {
  std::vector<Ring> rings;
  std::vector<Strip> strips;
  std::size_t vertices = 0, triangles = 0;
  double bound = 0;
};

// The sides of a ring may be as far from the part as the limit leaves after the chords beside it.
std::vector<std::uint32_t> needed_sides(const Outline& line, double limit) {
  const std::size_t count = line.points.size();
  std::vector<std::uint32_t> needed(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double after = line.closed || k + 1 < count ? line.points[k].height : 0;
    const double before = line.closed || k > 0 ? line.points[(k + count - 1) % count].height : 0;
    const double radius = line.points[k].at.x;
    needed[k] = radius > 0 ? sides_for(radius, limit - std::max(after, before)) : 1;
  }
  return needed;
}

Rings rings_of(const std::vector<Outline>& outlines, double limit, bool all_alike) {
  std::vector<std::vector<std::uint32_t>> needed;
  std::uint32_t least = kMostSides, most = kFewestSides;
  for (const Outline& line : outlines) {
    needed.push_back(needed_sides(line, limit));
    for (const std::uint32_t n : needed.back()) {
      if (n > 1) least = std::min(least, n);
      most = std::max(most, n);
    }
  }
  const TurnedSides sides(all_alike ? most : least, most);
  Rings out;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Outline& line = outlines[i];
    const std::size_t first = out.rings.size(), count = line.points.size();
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t n = needed[i][k] > 1 ? sides.at_least(needed[i][k]) : 1;
      out.rings.push_back(
          {line.points[k].at.x, line.points[k].at.z, static_cast<std::uint32_t>(out.vertices), n});
      out.vertices += n;
    }
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < count; ++k) {
      const Strip strip{first + k, first + (k + 1) % count, line.points[k].face.owner,
                        line.points[k].height};
      const Ring &a = out.rings[strip.from], &b = out.rings[strip.to];
      out.triangles += (a.sides > 1 ? a.sides : 0) + (b.sides > 1 ? b.sides : 0);
      out.bound = std::max(out.bound, strip.height + std::max(sagitta(a.radius, a.sides),
                                                              sagitta(b.radius, b.sides)));
      out.strips.push_back(strip);
    }
  }
  return out;
}

class Turner {
 public:
  explicit Turner(const Rings& rings) : rings_(rings) {
    mesh_.vertices.reserve(rings.vertices);
    mesh_.triangles.reserve(rings.triangles);
    mesh_.owners.reserve(rings.triangles);
    for (const Ring& ring : rings.rings) add(ring);
    for (const Strip& strip : rings.strips) add(strip);
  }
  TriMesh& mesh() { return mesh_; }

 private:
  void add(const Ring& ring) {
    for (std::uint32_t k = 0; k < ring.sides; ++k) {
      const SinCos at = sincos_deg(360.0 * k / ring.sides);
      mesh_.vertices.push_back({static_cast<float>(snap(ring.radius * at.cos)),
                                static_cast<float>(snap(ring.radius * at.sin)),
                                static_cast<float>(snap(ring.z))});
    }
  }

  void add(const Strip& strip) {
    const Ring &a = rings_.rings[strip.from], &b = rings_.rings[strip.to];
    const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      mesh_.triangles.push_back({i, j, k});
      mesh_.owners.push_back(strip.owner);
    };
    const bool fine_first = a.sides > b.sides;
    const Ring &fine = fine_first ? a : b, &coarse = fine_first ? b : a;
    const std::uint32_t ratio = fine.sides / coarse.sides;
    for (std::uint32_t i = 0; i < fine.sides; ++i) {
      const std::uint32_t j = i / ratio + (i % ratio < ratio / 2 ? 0 : 1);  // the nearest
      if (fine_first)
        add(a.vertex(i), a.vertex(i + 1), b.vertex(j));
      else
        add(a.vertex(j), b.vertex(i + 1), b.vertex(i));
    }
    for (std::uint32_t j = 0; coarse.sides > 1 && j < coarse.sides; ++j) {
      const std::uint32_t middle = j * ratio + ratio / 2;
      if (fine_first)
        add(a.vertex(middle), b.vertex(j + 1), b.vertex(j));
      else
        add(a.vertex(j), a.vertex(j + 1), b.vertex(middle));
    }
  }

  const Rings& rings_;
  TriMesh mesh_;
};

// The mesh's volume less that of the part, by Pappus.
double volume_excess(const std::vector<Outline>& outlines, const TriMesh& mesh) {
  double exact = 0;
  for (const Outline& line : outlines)
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < line.points.size(); ++k) {
      const OutlinePoint& p = line.points[k];
      const Vec3 &a = p.at, &b = line.points[(k + 1) % line.points.size()].at;
      exact += (a.x * a.x + a.x * b.x + b.x * b.x) / 3 * (b.z - a.z) - p.excess * (a.x + b.x);
    }
  return signed_volume(mesh) - kPi * exact;
}

// What is done so that the sides of thin walls do not meet. `sides`: all rings have equally many
// sides, so every section through the axis is the outline, a little narrower. `all`: the outline
// also keeps all its points; with them it does not meet itself.
enum class Care : std::uint8_t { none, sides, all };

class TurnedMesher {
 public:
  TurnedMesher(const ExactField& field, double voxel, const MeshPlan& options, MeshReport& report)
      : field_(field),
        voxel_(voxel),
        options_(options),
        report_(report),
        timer_(report, options.progress) {
    const Box3 bounds = field.bounds();
    // By how much coordinates are rounded.
    const double largest =
        std::max({std::abs(bounds.hi.x), std::abs(bounds.lo.z), std::abs(bounds.hi.z)});
    limit_ = options.tolerance - 2 * coordinate_step(largest);
  }

  std::optional<TriMesh> run() {
    if (!(limit_ > 0.5 * options_.tolerance)) return {};
    const TurnedSection section =
        turned_section(field_, voxel_, kLowest * limit_, kFinest * limit_, options_.threads);
    timer_.step("outline");
    if (section.outlines.empty()) return TriMesh{};
    std::vector<Outline> outlines;
    for (const Outline& line : section.outlines) outlines.push_back(straightened(line));
    for (const Care care : {Care::none, Care::sides, Care::all}) {
      const Rings rings = care == Care::all ? rings_of(outlines, limit_, true)
                                            : fewest_rings(outlines, care == Care::sides);
      if (rings.bound > limit_) return {};
      report_.memory = kTriangleMemory * static_cast<double>(rings.triangles) +
                       kSquareMemory * static_cast<double>(section.squares);
      require_mesh_memory(report_.memory, options_.max_memory, options_.tolerance);
      timer_.step("chords");
      TriMesh mesh = std::move(Turner(rings).mesh());
      timer_.step("surface");
      const bool sound = is_sound(mesh, options_.threads);
      timer_.step("check");
      if (!sound) continue;
      write_report(section, rings, mesh);
      return mesh;
    }
    return {};
  }

 private:
  Rings fewest_rings(const std::vector<Outline>& outlines, bool all_alike) const {
    double best = kShares[0];
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const double share : kShares) {
      const Rings rings = chosen(outlines, fewest_chords, share, all_alike);
      if (rings.bound <= limit_ && rings.triangles < fewest) best = share, fewest = rings.triangles;
    }
    return chosen(outlines, even_chords, best, all_alike);
  }

  Rings chosen(const std::vector<Outline>& outlines,
               Outline (*choose)(const Outline&, const ChordLimits&), double share,
               bool all_alike) const {
    const ChordLimits limits{share * limit_, options_.tolerance / 8, 0.5 * voxel_};
    std::vector<Outline> chords;
    for (const Outline& line : outlines) chords.push_back(choose(line, limits));
    return rings_of(chords, limit_, all_alike);
  }

  void write_report(const TurnedSection& section, const Rings& rings, const TriMesh& mesh) const {
    for (const Outline& line : section.outlines) report_.cells += line.points.size();
    report_.passes = 1;
    report_.triangles_before = mesh.triangles.size();
    report_.bound = rings.bound + (options_.tolerance - limit_);
    report_.volume_excess = volume_excess(section.outlines, mesh);
    report_.thin = distinct(section.lost);
  }

  const ExactField& field_;
  double voxel_;
  const MeshPlan& options_;
  MeshReport& report_;
  StepTimer timer_;
  double limit_ = 0;  ///< mm: the tolerance, less the rounding of coordinates
};

}  // namespace

std::optional<TriMesh> turned_mesh(const ExactField& field, double voxel, const MeshPlan& options,
                                   MeshReport& report) {
  return TurnedMesher(field, voxel, options, report).run();
}

}  // namespace mrsim::detail
