#include "compare/report/play_json.h"

#include "compare/report/packed.h"
#include "core/numbers/vec.h"
#include "core/text/text_io.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLength = 1e-4;  // mm, the step of places
constexpr double kAngle = 1e-7;   // rad, and of the parts of unit vectors
constexpr double kTime = 1e-6;    // s
constexpr double kVolume = 1e-4;  // mm^3

std::int64_t steps(double x, double step) { return std::isfinite(x) ? std::llround(x / step) : 0; }

// A voxel as a byte: what it is the same as, or that its number follows.
enum Symbol : char { kSameZ, kSameY, kSameX, kAir, kStays, kNumber };

struct VoxelStreams {
  std::string symbols;
  Packer numbers;
};

VoxelStreams pack_voxels(const Play& play) {
  VoxelStreams out;
  out.symbols.reserve(play.gone.size());
  const auto [nx, ny, nz] = play.size;
  const std::size_t row = std::size_t(nz), layer = std::size_t(ny) * row;
  std::int64_t last = 0;
  std::size_t i = 0;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z, ++i) {
        const std::int32_t gone = play.gone[i];
        Symbol symbol = kNumber;
        if (z > 0 && gone == play.gone[i - 1])
          symbol = kSameZ;
        else if (gone == 0)
          symbol = kAir;
        else if (gone == kNeverGoes)
          symbol = kStays;
        else if (y > 0 && gone == play.gone[i - row])
          symbol = kSameY;
        else if (x > 0 && gone == play.gone[i - layer])
          symbol = kSameX;
        else
          out.numbers.add(gone, last);
        out.symbols.push_back(symbol);
      }
  return out;
}

// One byte of all surfaces after the other: neighbours are alike.
template <typename Items, typename Surface>
Json pack_surfaces(const Items& items, Surface surface) {
  std::string bytes;
  bytes.reserve(3 * items.size());
  for (const auto& item : items) bytes.push_back(char(surface(item).share));
  for (const auto& item : items) bytes.push_back(char(surface(item).u));
  for (const auto& item : items) bytes.push_back(char(surface(item).v));
  return packed_bytes(bytes);
}

Json volume_json(const Play& play) {
  const VoxelStreams voxels = pack_voxels(play);
  Packer late;
  std::int64_t face = 0, moment = 0;
  for (const LateSurface& l : play.late) late.add(l.face, face), late.add(l.moment, moment);
  return {{"voxel", play.voxel},
          {"halfPlane", play.half_plane},
          {"origin", {play.origin.x, play.origin.y, play.origin.z}},
          {"size", play.size},
          {"symbols", packed_bytes(voxels.symbols)},
          {"numbers", voxels.numbers.json()},
          {"faceCount", play.faces.size()},
          {"faces", pack_surfaces(play.faces, [](const FaceSurface& s) { return s; })},
          {"lateCount", play.late.size()},
          {"late", late.json()},
          {"lateFaces", pack_surfaces(play.late, [](const LateSurface& l) { return l.surface; })}};
}

// Bits of a motion's first number.
enum Flag : std::int64_t { kKind = 3, kAssumed = 4, kJumps = 8, kTilted = 16 };

class MotionPacker {
 public:
  void add(const Motion& m) {
    // A motion that starts elsewhere than the last one ended says where.
    const bool jumps = !(m.start == last_end_), tilted = !(m.tool_axis == Vec3{0, 0, 1});
    heads_.put(std::int64_t(m.kind) | kAssumed * m.assumed_start | kJumps * jumps |
               kTilted * tilted);
    heads_.add(m.file, file_), heads_.add(m.line, line_), heads_.add(m.tool, tool_);
    if (jumps) add_place(m.start);
    add_place(m.end);
    if (m.kind == MotionKind::arc) {
      for (int k = 0; k < 3; ++k)
        places_.put(steps(component(m.center, k) - component(m.start, k), kLength));
      unit(m.axis);
      places_.put(steps(m.sweep, kAngle)), places_.put(steps(m.rise, kLength));
    }
    if (tilted) unit(m.tool_axis);
    last_end_ = m.end;
  }
  Json heads() const { return heads_.json(); }
  Json places() const { return places_.json(); }

 private:
  void add_place(const Vec3& p) {
    for (int k = 0; k < 3; ++k) places_.add(steps(component(p, k), kLength), at_[k]);
  }
  void unit(const Vec3& v) {
    for (int k = 0; k < 3; ++k) places_.put(steps(component(v, k), kAngle));
  }
  Packer heads_, places_;
  std::int64_t file_ = 0, line_ = 0, tool_ = 0, at_[3] = {0, 0, 0};
  Vec3 last_end_;
};

Json motions_json(const ReportRun& run) {
  MotionPacker motions;
  Packer moments, seconds, removed;
  const std::size_t count = run.program->motions.size();
  for (std::size_t i = 0; i < count; ++i) {
    motions.add(run.program->motions[i]);
    moments.put(run.play->first[i + 1] - run.play->first[i]);
    seconds.put(steps(run.cycle->seconds[i], kTime));
    removed.put(steps(run.play->removed[i], kVolume));
  }
  return {{"count", count},
          {"heads", motions.heads()},
          {"places", motions.places()},
          {"moments", moments.json()},
          {"seconds", seconds.json()},
          {"removed", removed.json()}};
}

Json stock_json(const StockShape& stock) {
  static constexpr const char* kNames[] = {"box", "cylinder", "tube", "mesh"};
  const Box3& b = stock.box;
  return {{"kind", kNames[std::size_t(stock.kind)]},
          {"lo", {b.lo.x, b.lo.y, b.lo.z}},
          {"hi", {b.hi.x, b.hi.y, b.hi.z}},
          {"outer", stock.outer_radius},
          {"inner", stock.inner_radius},
          {"axis", {stock.axis_point.x, stock.axis_point.y}}};
}

// Calls `body(i, other)` for each two neighbouring voxels of different moments, in the order of
// Play::faces.
template <typename Body>
void for_each_face(const Play& play, Body body) {
  const auto [nx, ny, nz] = play.size;
  const std::size_t row = std::size_t(nz), layer = std::size_t(ny) * row;
  std::size_t i = 0;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z, ++i) {
        if (x + 1 < nx && play.gone[i] != play.gone[i + layer]) body(i, i + layer);
        if (y + 1 < ny && play.gone[i] != play.gone[i + row]) body(i, i + row);
        if (z + 1 < nz && play.gone[i] != play.gone[i + 1]) body(i, i + 1);
      }
}

// Faces of a play that are seen at a moment.
std::size_t count_faces(const Play& play, std::int32_t moment) {
  std::size_t count = 0;
  for_each_face(play, [&](std::size_t a, std::size_t b) {
    count += (play.gone[a] <= moment) != (play.gone[b] <= moment);
  });
  return count;
}

// Faces that are seen at a few moments, so that a test of the page can compare.
Json checks_json(const Play& play) {
  Json out = Json::array();
  for (int k = 0; k <= 4; ++k) {
    const auto moment = std::int32_t(std::int64_t(play.first.back()) * k / 4);
    out.push_back({moment, count_faces(play, moment)});
  }
  return out;
}

Json tools_json(const ReportRun& run) {
  Json out = Json::array();
  for (std::size_t i = 0; i < run.play->tools.size(); ++i) {
    Json pieces = Json::array();
    for (const ToolOutline& o : run.play->tools[i])
      pieces.push_back(
          {{"part", o.part}, {"points", o.points}, {"round", o.round}, {"insert", o.insert}});
    out.push_back({{"id", to_utf8(run.program->tools[i].id)}, {"pieces", std::move(pieces)}});
  }
  return out;
}

}  // namespace

Json play_json(const ReportRun& run, std::size_t files) {
  if (run.play == nullptr || run.play->first.empty()) return nullptr;
  Json out = volume_json(*run.play);
  const std::size_t own = run.program->files.size();
  out["firstFile"] = files > own ? files - own : 0;
  out["motions"] = motions_json(run);
  out["tools"] = tools_json(run);
  out["stock"] = run.stock != nullptr ? stock_json(*run.stock) : Json(nullptr);
  out["checks"] = checks_json(*run.play);
  return out;
}

}  // namespace mrsim
