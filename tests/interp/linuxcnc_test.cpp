// LinuxCNC's own interpreter tests: accepted or refused as its interpreter does, and the same
// motions. The programs are not part of this repository: MRSIM_LINUXCNC_DIR names a folder with
// each program, NAME.ngc, beside what the stand-alone interpreter said of it, NAME.ngc.canon.
#include "core/vec.h"
#include "interp/support.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

namespace mrsim {
namespace {

namespace fs = std::filesystem;

// Of ends and centres, mm: the calls are printed with 7 decimals of the program's unit.
constexpr double kSame = 2e-3;

/// One motion as the interpreter called for it, in mm.
struct CanonMove {
  MotionKind kind{};
  Vec3 end;
  double center[2] = {0, 0};  // in the plane
  int turns = 0;              // negative: clockwise
  int plane = 0;
};

struct Canon {
  bool accepted = false;
  std::vector<CanonMove> moves;
};

constexpr int kFirst[] = {0, 2, 1}, kSecond[] = {1, 0, 2}, kThird[] = {2, 1, 0};

std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> out;
  std::stringstream in(line.substr(line.find('(') + 1));
  for (std::string part; std::getline(in, part, ',');) out.push_back(std::atof(part.c_str()));
  return out;
}

// Calls without travel say nothing about the path; mrsim leaves some of them out.
void add(Canon& canon, Vec3& at, const CanonMove& move) {
  if (move.kind == MotionKind::arc || length(move.end - at) > 1e-6) canon.moves.push_back(move);
  at = move.end;
}

Canon read_canon(const fs::path& path) {
  Canon canon;
  std::ifstream in(path);
  double unit = 1;
  int plane = 0;
  Vec3 at;
  for (std::string line; std::getline(in, line);) {
    const std::string name = line.substr(0, line.find('('));
    CanonMove move;
    move.plane = plane;
    if (line == "exit 0") canon.accepted = true;
    if (name == "USE_LENGTH_UNITS") unit = line.find("INCHES") != std::string::npos ? 25.4 : 1;
    if (name == "SELECT_PLANE")
      plane = line.find("XY") != std::string::npos   ? 0
              : line.find("XZ") != std::string::npos ? 1
                                                     : 2;
    if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") {
      const std::vector<double> v = numbers_in(line);
      move.kind = name == "STRAIGHT_FEED" ? MotionKind::line : MotionKind::rapid;
      move.end = unit * Vec3{v[0], v[1], v[2]};
      add(canon, at, move);
    } else if (name == "ARC_FEED") {
      const std::vector<double> v = numbers_in(line);
      move.kind = MotionKind::arc;
      component(move.end, kFirst[plane]) = unit * v[0];
      component(move.end, kSecond[plane]) = unit * v[1];
      component(move.end, kThird[plane]) = unit * v[5];
      move.center[0] = unit * v[2];
      move.center[1] = unit * v[3];
      move.turns = static_cast<int>(v[4]);
      add(canon, at, move);
    }
  }
  return canon;
}

InterpOptions linuxcnc_options(const fs::path& program) {
  InterpOptions options = at_origin(Dialect::ngc);
  options.comp = CompRadius::automatic;
  options.require_tools = false;
  options.places.zero = {{"G54", {}}};  // machine and program coordinates agree at the start
  options.table.tools.clear();
  for (int i = 1; i <= 200; ++i) {
    Tool tool;
    tool.id = std::to_string(i);
    tool.diameter = 6;
    tool.origin = "test";
    options.table.tools.push_back(tool);
  }
  options.search_path.push_back((program.parent_path() / "subs").string());
  return options;
}

// Why the motion differs from the call, or empty.
std::string difference(const Motion& m, const CanonMove& c) {
  if (m.kind != c.kind) return "another kind of motion";
  if (length(m.end - c.end) > kSame)
    return fmt::format("ends at {:.4f} {:.4f} {:.4f}, not {:.4f} {:.4f} {:.4f}", m.end.x, m.end.y,
                       m.end.z, c.end.x, c.end.y, c.end.z);
  if (m.kind != MotionKind::arc) return {};
  const double u = component(m.center, kFirst[c.plane]) - c.center[0],
               v = component(m.center, kSecond[c.plane]) - c.center[1];
  if (std::abs(u) > kSame || std::abs(v) > kSame)
    return fmt::format("the centre differs by {:.4f} {:.4f}", u, v);
  const double normal = component(m.axis, kThird[c.plane]);
  const double sweep = normal > 0 ? m.sweep : -m.sweep;
  if ((sweep > 0) != (c.turns > 0)) return "the other direction";
  const double whole = std::abs(sweep) / kTwoPi;
  if (std::abs(c.turns) != static_cast<int>(std::ceil(whole - 1e-9))) return "other turns";
  return {};
}

std::string compare(const Program& p, const Canon& canon) {
  const bool accepted = codes(p, Severity::error).empty();
  if (accepted != canon.accepted)
    return accepted ? "accepted, LinuxCNC refuses"
                    : "refused, LinuxCNC accepts: " + codes(p, Severity::error);
  if (!accepted) return {};
  std::vector<const Motion*> moves;
  for (const Motion& m : p.motions)
    if (m.kind == MotionKind::arc || length(m.end - m.start) > 1e-6) moves.push_back(&m);
  for (std::size_t i = 0; i < std::min(moves.size(), canon.moves.size()); ++i) {
    const std::string why = difference(*moves[i], canon.moves[i]);
    if (!why.empty()) return fmt::format("motion {} (line {}): {}", i + 1, moves[i]->line, why);
  }
  if (moves.size() != canon.moves.size())
    return fmt::format("{} motions, not {}", moves.size(), canon.moves.size());
  return {};
}

// Programs that differ, and why; docs/ngc.md says more.
const char* known_difference(const std::string& name) {
  constexpr std::pair<const char*, const char*> kKnown[] = {
      {"good/good-arc", "the centre is moved to the bisector, where LinuxCNC's radius drifts"},
      {"inside-corners/", "the same"},
      {"crazy-paths/", "arcs shorter than the tool's radius at inside corners"},
      {"g10/", "the calls are in the program's coordinates, motions in the stock's"},
      {"rotation/", "the same; rotary axes"},
      {"machine-coord-params/", "the same"},
      {"unit-conversion/", "rotary axes"},
      {"g33.1/", "a rigid tap is a call of its own"},
      {"g84/", "a rigid tap is a call of its own"},
      {"g71-", "turning cycles"},
      {"g72-", "turning cycles"},
      {"m98m99/11-main-program-oword/test-illegal-", "a program may end without M2"},
      {"nested-sub-in-file-error/", "a sub is looked for in the whole file"},
      {"sub-call-from-sub/", "its files are at hand here"},
  };
  for (const auto& [start, why] : kKnown)
    if (name.starts_with(start)) return why;
  return nullptr;
}

TEST(LinuxCnc, RunsItsInterpretersTestsAlike) {
  const char* folder = std::getenv("MRSIM_LINUXCNC_DIR");
  if (!folder) GTEST_SKIP() << "MRSIM_LINUXCNC_DIR names no folder of LinuxCNC's tests";
  std::size_t programs = 0, different = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".canon") continue;
    fs::path program = entry.path();
    program.replace_extension();
    ++programs;
    const Canon canon = read_canon(entry.path());
    const std::string why =
        compare(read_program(program.string(), linuxcnc_options(program)), canon);
    if (why.empty()) continue;
    ++different;
    const std::string name = fs::relative(program, folder).string();
    EXPECT_NE(known_difference(name), nullptr) << name << ": " << why;
  }
  EXPECT_EQ(programs, 126U);
  EXPECT_EQ(different, 33U);
}

}  // namespace
}  // namespace mrsim
