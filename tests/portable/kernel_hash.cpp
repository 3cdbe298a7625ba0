// Hashes of what every machine must compute to the last bit: traces of programs, distances, faces
// and gradients of random sweeps of every tool, what pruning leaves, and meshes. One line each, so
// that two machines are compared by diff (scripts/check_arm64.sh). Needs neither OpenVDB nor TBB.
#include "core/numbers/units.h"
#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "interp/interpreter.h"
#include "mesh/mesh_part.h"
#include "removal/part/part_field.h"
#include "removal/prune/candidate_list.h"
#include "removal/prune/list_candidates.h"
#include "removal/prune/prune.h"
#include "removal/simd/sweep_kernels.h"
#include "removal/sweep/sweep_table.h"
#include "support/collecting_sink.h"
#include "support/random.h"
#include <mrsim/mrsim.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace mrsim {
namespace {

using testing::Random;

class Bits {
 public:
  void add(std::uint64_t v) { state_ = (state_ ^ v) * 0x9e3779b97f4a7c15u, state_ ^= state_ >> 29; }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  void add(const std::string& text) {
    for (const char c : text) add(std::uint64_t(static_cast<unsigned char>(c)));
  }
  void print(const char* what, const std::string& name) const {
    std::printf("%s %s %016llx\n", what, name.c_str(), static_cast<unsigned long long>(state_));
  }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3u;
};

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

void hash_trace(const std::string& path) {
  InterpOptions options;
  Tool tool;
  tool.diameter = 10;
  options.table.tools.push_back(tool);
  options.require_tools = false;
  testing::CollectingSink found;
  Bits bits;
  try {
    Program program = interpret(path, options, found);
    program.files = {base_name(path)};
    for (const Motion& m : found.motions) bits.add(motion_json(program, m));
    for (const Diagnostic& d : found.diagnostics) bits.add(d.code + d.text);
  } catch (const Error& error) {
    bits.add(error.code());
  }
  bits.print("trace", base_name(path));
}

struct Kind {
  const char* name;
  Tool tool;
};

std::vector<Kind> kinds() {
  std::vector<Kind> out;
  const auto add = [&](const char* name, ToolType type) -> Tool& {
    out.push_back({name, {}});
    out.back().tool.type = type;
    out.back().tool.diameter = 6;
    return out.back().tool;
  };
  add("endmill", ToolType::endmill);
  add("endmill-closed", ToolType::endmill).flute_length = 8;
  add("ballmill", ToolType::ballmill);
  add("bullmill", ToolType::bullmill).corner_radius = 1;
  Tool& chamfer = add("chamfer", ToolType::chamfer);
  chamfer.tip_diameter = 1;
  Tool& taper = add("taper", ToolType::taper);
  taper.tip_diameter = 2, taper.taper_angle = 0.2;
  add("drill", ToolType::drill);
  Tool& slot = add("tslot", ToolType::tslot);
  slot.flute_length = 3, slot.neck_diameter = 3, slot.corner_radius = 0.5;
  add("lollipop", ToolType::lollipop).neck_diameter = 2;
  Tool& barrel = add("barrel", ToolType::barrel);
  barrel.profile_radius = 20, barrel.corner_radius = 1;
  Tool& form = add("form", ToolType::form);
  form.profile = {{0, 0, 0}, {2, 0, 0.3}, {3, 2, 0}, {2, 4, 0}, {2, 9, 0}};
  Tool& insert = add("turning", ToolType::turning);
  insert.insert = "D", insert.nose_radius = 0.4, insert.diameter = 0;
  Tool& round = add("turning-round", ToolType::turning);
  round.insert = "R", round.diameter = 6;
  Tool& groove = add("grooving", ToolType::grooving);
  groove.width = 3, groove.nose_radius = 0.2, groove.diameter = 0;
  add("boring", ToolType::boring).insert = "C";
  add("threading", ToolType::threading).diameter = 0;
  return out;
}

Motion random_motion(Random& r, bool turning) {
  Motion m;
  m.tool = 0, m.line = 1;
  m.start = {r(4, 12), turning ? 0 : r(-8, 8), r(-4, 4)};
  const int kind = r.pick(turning ? 2 : 6);
  m.kind = kind % 2 ? MotionKind::arc : MotionKind::line;
  if (kind % 2 == 0) {
    m.end = {r(4, 12), turning ? 0 : r(-8, 8), r(-4, 4)};
    if (kind == 0 && !turning) m.end.z = m.start.z;
    if (kind == 2) m.end.x = m.start.x, m.end.y = m.start.y;
    return m;
  }
  // A right angle of rational sides: the end needs no sine.
  m.radius = 1 + r.pick(4);
  m.axis = turning || kind == 5 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  m.sweep = (r.pick(2) ? 1 : -1) * kPi / 2;
  m.rise = kind == 3 ? r(-3, 3) : 0;
  m.center = m.start - Vec3{m.radius, 0, 0};
  const double s = m.sweep > 0 ? 1 : -1;
  m.end = m.center + (m.axis.y > 0 ? Vec3{0, 0, -s * m.radius} : Vec3{0, s * m.radius, m.rise});
  return m;
}

void hash_sweeps(const Kind& kind) {
  Random r(7);
  const bool turning = is_turning(kind.tool.type);
  Bits bits;
  for (int scene = 0; scene < 6; ++scene) {
    std::vector<Motion> motions;
    for (int k = 0; k < 30; ++k) motions.push_back(random_motion(r, turning));
    const SweepTable table(motions, std::span(&kind.tool, 1));
    std::vector<std::uint32_t> ids(table.size());
    std::iota(ids.begin(), ids.end(), 0u);
    std::vector<double> d(ids.size());
    for (int k = 0; k < 20; ++k) {
      const Vec3 p{r(0, 15), r(-10, 10), r(-6, 10)};
      table.distances(ids, p, d.data());
      for (std::size_t i = 0; i < ids.size(); ++i) {
        const SweepSample at = table.sample(i, p);
        bits.add(d[i]);
        bits.add(static_cast<std::uint64_t>(at.patch));
        bits.add(table.gradient(i, p, at.patch));
        bits.add(table.patch_distance(i, p, at.patch));
      }
      CandidateList all, left;
      list_candidates(table, table.all(), p, all);
      const PruneRegion region = PruneRegion::cube(p, 0.5);
      bits.add(std::uint64_t(prune(table, region, region.radius + 1, 1, all, left)));
      for (const CandidateList::Slice& slice : left.slices())
        for (std::size_t k2 = 0; k2 < slice.count; ++k2)
          bits.add(std::uint64_t(left.number(slice, k2)));
    }
  }
  bits.print("sweeps", kind.name);
}

void hash_mesh(const std::string& path, const StockShape& stock, double voxel, double tolerance) {
  testing::CollectingSink found;
  const Program program = interpret(path, {}, found);
  const PartField field(StockSolid(stock), SweepTable(found.motions, program.tools));
  MeshPlan options;
  options.tolerance = tolerance;
  options.threads = 1;
  const TriMesh mesh = mesh_part(field, voxel, options);
  Bits bits;
  for (const auto& v : mesh.vertices)
    for (const float x : v) bits.add(std::uint64_t(std::bit_cast<std::uint32_t>(x)));
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) bits.add(std::uint64_t(v));
  for (const std::int32_t owner : mesh.owners) bits.add(static_cast<std::uint64_t>(owner));
  bits.print(tolerance > 0 ? "mesh-certified" : "mesh-uniform", base_name(path));
}

void hash_all(const std::string& data, const std::vector<std::string>& programs) {
  for (const std::string& path : programs) hash_trace(path);
  for (const Kind& kind : kinds()) hash_sweeps(kind);
  StockShape block, bar;
  block.box = {{0, -60, 0}, {100, 0, 10}};
  bar.kind = StockShape::Kind::cylinder;
  bar.outer_radius = 25;
  bar.box = {{-25, -25, 0}, {25, 25, 51}};
  for (const double tolerance : {0.0, 0.02}) {
    hash_mesh(data + "/PRIMER_2F.MPF", block, 1, tolerance);
    hash_mesh(data + "/PRIMER_2S.MPF", bar, 1, tolerance);
  }
}

}  // namespace
}  // namespace mrsim

// kernel_hash DATA_FOLDER PROGRAM...
int main(int argc, char** argv) {
  if (argc < 2) return 2;
  mrsim::hash_all(argv[1], std::vector<std::string>(argv + 2, argv + argc));
}
