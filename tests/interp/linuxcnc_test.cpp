// LinuxCNC's own interpreter tests: accepted or refused as its interpreter does, and the same
// motions. The programs are not part of this repository: MRSIM_LINUXCNC_DIR names a folder with
// each program, NAME.ngc, beside what the stand-alone interpreter said of it, NAME.ngc.canon.
#include "core/numbers/trig.h"
#include "core/numbers/vec.h"
#include "interp/support.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

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

/// Where the calls of a program are: LinuxCNC prints them in the coordinates in force, motions are
/// in the stock's. Worked out from the G10, G52 and G92 of the programs; in their units.
struct CallFrame {
  const char* program;
  int last;        ///< call that it counts for, from 1 on
  double turn;     ///< degrees, G10 R
  Vec3 work, own;  ///< of G10 L2; of G52 and G92, within the turn
};

constexpr double kHalf = 0.70710678118654752;
constexpr CallFrame kFrames[] = {
    {"g10/g10-l2-while-active/", 1, 0, {}, {}},
    {"g10/g10-l2-while-active/", 2, 0, {1, 0, 0}, {}},
    {"g10/g10-l2-while-active/", 3, -45, {1, 0, 0}, {}},
    {"g10/g10-l2-while-active/", 4, 90, {2, 1, 0}, {}},
    {"g10/g10-l2-while-active/", 5, 90, {}, {}},
    {"g10/g10-l20-while-active/", 1, 45, {}, {}},
    {"g10/g10-l20-while-active/", 2, 45, {kHalf, kHalf, 0}, {}},
    {"g10/g10-l20-while-active/", 3, 45, {0, 2 * kHalf, 0}, {}},
    {"g10/g10-l20-while-active/", 4, 45, {}, {}},
    {"g10/g10-l11/", 1, 10, {1, 2, -3}, {}},
    {"g10/g10-l11/", 2, 20, {4, 5, -6}, {}},
    {"g10/g10-l11/", 3, 10, {1, 2, -3}, {-43.0621778, -47.4282032, -76}},
    {"g10/g10-l11/", 4, 20, {4, 5, -6}, {-43.0621778, -47.4282032, -76}},
    {"g10/g10-with-g92/", 1, 10, {1, 2, 3}, {}},
    {"g71-endless-loop_2/", 10, 0, {}, {0, 0, -1.9}},
    {"machine-coord-params/", 2, 0, {}, {}},
    {"machine-coord-params/", 4, 0, {3, 7, 0}, {}},
    {"machine-coord-params/", 6, 45, {}, {}},
    {"machine-coord-params/", 8, 45, {3, 7, 0}, {}},
    {"machine-coord-params/", 10, 0, {}, {-2, -5, 0}},
    {"rotation/abs-pts/", 2, 0, {}, {}},
    {"rotation/abs-pts/", 4, 0, {3, 7, 0}, {}},
    {"rotation/abs-pts/", 6, 45, {}, {}},
    {"rotation/abs-pts/", 8, 45, {3, 7, 0}, {}},
    {"rotation/abs-pts/", 10, 0, {}, {-2, -5, 0}},
    {"rotation/abs-pts/", 12, 0, {3, 7, 0}, {-5, -12, 0}},
    {"rotation/abs-pts/", 14, 45, {3, 7, 0}, {-7.9497475, -9.1213203, 0}},
    {"rotation/abs-pts/", 16, 0, {}, {}},
    {"rotation/abs-pts/", 18, 0, {3, 7, 0}, {}},
    {"rotation/abs-pts/", 20, 45, {}, {}},
    {"rotation/abs-pts/", 22, 45, {3, 7, 0}, {}},
    {"rotation/abs-pts/", 24, 0, {}, {-2, -5, 0}},
    {"rotation/abs-pts/", 26, 0, {3, 7, 0}, {-5, -12, 0}},
    {"rotation/abs-pts/", 28, 45, {3, 7, 0}, {-7.9497475, -9.1213203, 0}},
};

Vec3 in_stock(const std::string& program, int call, Vec3 p) {
  for (const CallFrame& f : kFrames) {
    if (!program.starts_with(f.program) || call > f.last) continue;
    const SinCos turn = sincos_deg(f.turn);
    p = p + f.own;
    return Vec3{turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y, p.z} + f.work;
  }
  return p;
}

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

Canon read_canon(const fs::path& path, const std::string& program) {
  Canon canon;
  int calls = 0;
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
      move.end = unit * in_stock(program, ++calls, {v[0], v[1], v[2]});
      add(canon, at, move);
    } else if (name == "RIGID_TAP") {  // in, and out again
      const std::vector<double> v = numbers_in(line);
      const Vec3 from = at;
      move.kind = MotionKind::line;
      move.end = unit * in_stock(program, ++calls, {v[0], v[1], v[2]});
      add(canon, at, move);
      move.end = from;
      add(canon, at, move);
    } else if (name == "ARC_FEED") {
      const std::vector<double> v = numbers_in(line);
      move.kind = MotionKind::arc;
      Vec3 center;
      component(move.end, kFirst[plane]) = v[0];
      component(move.end, kSecond[plane]) = v[1];
      component(move.end, kThird[plane]) = v[5];
      component(center, kFirst[plane]) = v[2];
      component(center, kSecond[plane]) = v[3];
      move.end = unit * in_stock(program, ++calls, move.end);
      center = unit * in_stock(program, calls, center);
      move.center[0] = component(center, kFirst[plane]);
      move.center[1] = component(center, kSecond[plane]);
      move.turns = static_cast<int>(v[4]);
      add(canon, at, move);
    }
  }
  return canon;
}

InterpOptions linuxcnc_options() {
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
      {"rotation/g", "rotary axes"},
      {"unit-conversion/", "rotary axes"},
      {"g84/g18/", "its G84 exchanges the axes outside of G17: refused"},
      {"g84/g19/", "the same"},
      {"machine-coord-params/", "G53 counts to the tip, whatever the tool's length"},
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
    const std::string name = fs::relative(program, folder).string();
    const Canon canon = read_canon(entry.path(), name);
    const std::string why = compare(read_program(program.string(), linuxcnc_options()), canon);
    if (why.empty()) continue;
    ++different;
    EXPECT_NE(known_difference(name), nullptr) << name << ": " << why;
  }
  EXPECT_EQ(programs, 126U);
  EXPECT_EQ(different, 15U);
}

}  // namespace
}  // namespace mrsim
