#include "support/moves.h"
#include <mrsim/cycle_time.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

Motion line(const Vec3& start, const Vec3& end, double feed) {
  Motion m = testing::line(start, end);
  m.feed = feed;
  return m;
}

Motion rapid(const Vec3& start, const Vec3& end) {
  Motion m = line(start, end, 0);
  m.kind = MotionKind::rapid;
  return m;
}

Event dwell(std::size_t before, double seconds, int tool) {
  Event event;
  event.before = before, event.seconds = seconds, event.tool = tool;
  return event;
}

Event spindle(std::size_t before, SpindleTurn turn) {
  Event event;
  event.kind = EventKind::spindle;
  event.before = before, event.turn = turn;
  return event;
}

Event path(std::size_t before, PathMode mode) {
  Event event;
  event.kind = EventKind::path_mode;
  event.before = before, event.path = mode;
  return event;
}

Program program_of(std::vector<Motion> motions) {
  Program program;
  program.motions = std::move(motions);
  return program;
}

MachineData machine() {
  MachineData m;
  m.rapid = {12000, 12000, 6000};  // 200, 200, 100 mm/s
  m.acceleration = {1000, 1000, 500};
  m.spindle_acceleration = 1e12;
  return m;
}

TEST(CycleTime, LineWithRampsIsATrapezoid) {
  // 100 mm at 50 mm/s with 1000 mm/s^2: L / v + v / a.
  const CycleTime t = cycle_time(program_of({line({0, 0, 0}, {100, 0, 0}, 3000)}), machine());
  EXPECT_NEAR(t.cutting, 100.0 / 50 + 50.0 / 1000, 1e-12);
  EXPECT_EQ(t.total, t.cutting);
}

TEST(CycleTime, ShortRapidIsATriangle) {
  // 10 mm never reach 200 mm/s: 2 sqrt(L / a).
  const CycleTime t = cycle_time(program_of({rapid({0, 0, 0}, {0, 10, 0})}), machine());
  EXPECT_NEAR(t.rapid, 2 * std::sqrt(10.0 / 1000), 1e-12);
}

TEST(CycleTime, RapidsAreLimitedByTheSlowestAxis) {
  // Z takes half of the length at 100 mm/s and 500 mm/s^2: the path 200 and 1000.
  const double z = 300 * 0.5, x = 300 * std::sqrt(0.75);
  const CycleTime t = cycle_time(program_of({rapid({0, 0, 0}, {x, 0, z})}), machine());
  EXPECT_NEAR(t.rapid, 300.0 / 200 + 200.0 / 1000, 1e-9);
}

TEST(CycleTime, LinesInOneDirectionAreOneLine) {
  const auto whole = cycle_time(program_of({line({0, 0, 0}, {100, 0, 0}, 3000)}), machine());
  std::vector<Motion> parts;
  for (int i = 0; i < 1000; ++i)
    parts.push_back(line({i * 0.1, 0, 0}, {(i + 1) * 0.1, 0, 0}, 3000));
  EXPECT_NEAR(cycle_time(program_of(parts), machine()).cutting, whole.cutting, 1e-9);
}

TEST(CycleTime, ACornerIsRoundedWithinTheTolerance) {
  // Rounded by an arc that cuts the corner off by 0.01 mm: r = d cos45 / (1 - cos45), v = sqrt(a
  // r).
  const double half = std::sqrt(0.5), r = 0.01 * half / (1 - half), v = std::sqrt(1000 * r);
  const CycleTime t = cycle_time(
      program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {50, 50, 0}, 3000)}),
      machine());
  const double ramps = (50.0 * 50 + (50.0 * 50 - v * v)) / (2 * 1000);
  const double each = 50.0 / 1000 + (50 - v) / 1000 + (50 - ramps) / 50;
  EXPECT_NEAR(t.cutting, 2 * each, 1e-12);
}

TEST(CycleTime, AReversalStopsTheAxes) {
  const CycleTime t =
      cycle_time(program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {0, 0, 0}, 3000)}),
                 machine());
  EXPECT_NEAR(t.cutting, 2 * (50.0 / 50 + 50.0 / 1000), 1e-12);
}

TEST(CycleTime, FacingAtConstantSurfaceSpeedHasTheClosedForm) {
  // dt = 2 pi r dr 60 / (1000 S f): pi (R^2 - r^2) 60 / (1000 S f).
  Motion m = line({40, 0, 0}, {20, 0, 0}, 0.2);
  m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  const CycleTime t = cycle_time(program_of({m}), fast);
  EXPECT_NEAR(t.cutting, std::numbers::pi * (1600 - 400) * 60 / (1000 * 200 * 0.2), 1e-6);
}

TEST(CycleTime, FacingToTheCentreIsCapped) {
  Motion m = line({40, 0, 0}, {0, 0, 0}, 0.2);
  m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  fast.max_spindle = 2000;
  const double capped = 1000 * 200 / (2 * std::numbers::pi * 2000);
  const double slow = std::numbers::pi * (1600 - capped * capped) * 60 / (1000 * 200 * 0.2);
  EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, slow + capped / (0.2 * 2000 / 60), 1e-6);
}

// A facing cut that goes on beyond the axis: the radius falls and grows again.
TEST(CycleTime, FacingBeyondTheCentreKeepsToTheHighestSpeed) {
  Motion m = line({40, 0, 0}, {-1, 0, 0}, 0.2);
  m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  fast.max_spindle = 2000;
  const double capped = 1000 * 200 / (2 * std::numbers::pi * 2000);
  const double slow = std::numbers::pi * (1600 - capped * capped) * 60 / (1000 * 200 * 0.2);
  EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, slow + (capped + 1) / (0.2 * 2000 / 60),
              1e-6);
}

// A ball of 60 mm turned from its pole, and a groove's round bottom, whose ends lie at one radius.
TEST(CycleTime, ArcsAtConstantSurfaceSpeedHaveTheClosedForm) {
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  Motion m = testing::arc({0, 0, 0}, {0, 0, -30}, {0, 1, 0}, std::numbers::pi / 2);
  m.feed = 0.2, m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
  const double slow = 2 * std::numbers::pi * 60 / (1000 * 200 * 0.2);  // s for each mm^2 of r ds
  for (const double limit : {1e9, 3000.0}) {
    m.speed_limit = fast.max_spindle = limit;
    const double capped = std::asin(1000 * 200 / (2 * std::numbers::pi * limit) / 30);
    const double exact = slow * 900 * std::cos(capped) + 30 * capped / (0.2 * limit / 60);
    EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, exact, 1e-5 * exact) << limit;
  }
  Motion groove = testing::arc({25, 0, 3}, {25, 0, 0}, {0, 1, 0}, -std::numbers::pi);
  groove.feed = 0.2, groove.feed_unit = FeedUnit::mm_per_rev, groove.speed = 200;
  groove.constant_surface_speed = true, groove.speed_limit = fast.max_spindle = 1e9;
  const double exact = slow * (25 * 3 * std::numbers::pi - 2 * 9);
  EXPECT_NEAR(cycle_time(program_of({groove}), fast).cutting, exact, 1e-5 * exact);
}

// From rest to the speed at the first radius, and again where the spindle turns round or leaves it.
TEST(CycleTime, TheSpindleStartsUnderConstantSurfaceSpeed) {
  const auto turns = [](double radius) { return 1000 * 200 / (2 * std::numbers::pi * radius); };
  const auto face = [](double from, double to) {
    Motion m = line({from, 0, 0}, {to, 0, 0}, 0.2);
    m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
    return m;
  };
  const double a = machine().spindle_acceleration;
  EXPECT_NEAR(cycle_time(program_of({face(40, 20), face(30, 25)}), machine()).spindle,
              turns(40) / a, 1e-9);
  Motion even = line({25, 0, 0}, {25, 0, -9}, 0.2);
  even.feed_unit = FeedUnit::mm_per_rev, even.speed = 500;
  EXPECT_NEAR(cycle_time(program_of({face(40, 20), even, face(40, 20)}), machine()).spindle,
              (turns(40) + turns(20) - 500 + turns(40) - 500) / a, 1e-9);
  Program back = program_of({face(40, 20), face(20, 40)});
  for (const std::size_t at : {0, 1}) {
    Event event;
    event.kind = EventKind::spindle, event.before = at;
    event.turn = at == 0 ? SpindleTurn::clockwise : SpindleTurn::counter_clockwise;
    back.events.push_back(event);
  }
  EXPECT_NEAR(cycle_time(back, machine()).spindle, (turns(40) + 2 * turns(20)) / a, 1e-9);
}

// G50 S, LIMS: the slower of machine and program counts.
TEST(CycleTime, ProgramsLimitTheSpindle) {
  Motion m = line({40, 0, 0}, {0, 0, 0}, 0.2);
  m.feed_unit = FeedUnit::mm_per_rev, m.constant_surface_speed = true, m.speed = 200;
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  for (const double machines : {500.0, 6000.0})
    for (const double programs : {500.0, 6000.0}) {
      fast.max_spindle = machines, m.speed_limit = programs;
      const double limit = std::min(machines, programs);
      const double capped = std::min(1000 * 200 / (2 * std::numbers::pi * limit), 40.0);
      const double slow = std::numbers::pi * (1600 - capped * capped) * 60 / (1000 * 200 * 0.2);
      EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, slow + capped / (0.2 * limit / 60),
                  1e-6)
          << machines << " " << programs;
    }
  m.constant_surface_speed = false, m.speed = 3000, m.speed_limit = 1500;
  EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, 40 / (0.2 * 1500 / 60), 1e-6);
}

// A feed is limited by the axes that it moves: here Z, the slowest, stands.
TEST(CycleTime, FeedsAreLimitedByTheirAxes) {
  const CycleTime t = cycle_time(program_of({line({0, 0, 0}, {100, 0, 0}, 9000)}), machine());
  EXPECT_NEAR(t.cutting, 100.0 / 150 + 150.0 / 1000, 1e-9);
  Motion round = line({1000, 0, 0}, {1000, 0, 0}, 9000);
  round.kind = MotionKind::arc, round.radius = 1000, round.sweep = 2 * std::numbers::pi;
  const double way = 2000 * std::numbers::pi;
  EXPECT_NEAR(cycle_time(program_of({round}), machine()).cutting, way / 150 + 150.0 / 1000, 1e-6);
  round.rise = 1e-3;  // now Z takes part
  EXPECT_NEAR(cycle_time(program_of({round}), machine()).cutting, way / 100 + 100.0 / 500, 1e-3);
}

TEST(CycleTime, InverseTimeIsSharesOfAMinute) {
  Motion m = line({0, 0, 0}, {10, 0, 0}, 12);  // a twelfth of a minute
  m.feed_unit = FeedUnit::inverse_time;
  MachineData fast = machine();
  fast.acceleration = {1e12, 1e12, 1e12};
  EXPECT_NEAR(cycle_time(program_of({m}), fast).cutting, 5, 1e-6);
}

// Whatever the feed of the cuts before was.
TEST(CycleTime, ThreadsRunAtTheirLead) {
  Motion m = line({10, 0, 4}, {10, 0, -12}, 0.05);
  m.feed_unit = FeedUnit::mm_per_rev, m.speed = 500, m.lead = 1.5;
  const double v = 500 * 1.5 / 60;
  EXPECT_NEAR(cycle_time(program_of({m}), machine()).cutting, 16 / v + v / 500, 1e-9);
  m.lead = -1.5;  // left-hand
  EXPECT_NEAR(cycle_time(program_of({m}), machine()).cutting, 16 / v + v / 500, 1e-9);
  m.end = {12, 0, -12};  // on a cone the lead counts along Z
  m.lead = 1.5;
  EXPECT_NEAR(cycle_time(program_of({m}), machine()).cutting, 16 / v, 0.05);
  m.feed = 0;
  EXPECT_EQ(cycle_time(program_of({m}), machine()).without_feed, 0u);
}

TEST(CycleTime, ArcIsLimitedByItsRadius) {
  Motion m = line({1, 0, 0}, {1, 0, 0}, 60000);
  m.kind = MotionKind::arc, m.center = {0, 0, 0}, m.radius = 1, m.sweep = 200 * std::numbers::pi;
  MachineData flat = machine();
  flat.acceleration = {500, 500, 500};
  const double v = std::sqrt(500.0), length = 200 * std::numbers::pi;
  EXPECT_NEAR(cycle_time(program_of({m}), flat).cutting, length / v + v / 500, 1e-9);
}

TEST(CycleTime, ToolsAreSummedAndChanged) {
  Motion a = line({0, 0, 0}, {100, 0, 0}, 6000), b = a, c = a;
  b.tool = 1;
  const CycleTime t = cycle_time(program_of({a, b, c}), machine());
  ASSERT_EQ(t.tools.size(), 2u);
  EXPECT_EQ(t.tool_changes, 2u);
  EXPECT_NEAR(t.tools[0].cutting, 2 * t.tools[1].cutting, 1e-12);
  EXPECT_NEAR(t.total, t.cutting + 12, 1e-12);
}

// A line in two halves, with a stop between them: each half has ramps of its own.
TEST(CycleTime, DwellsCountAndStopTheTool) {
  Program program =
      program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {100, 0, 0}, 3000)});
  program.events = {dwell(1, 2.5, 0), dwell(2, 0.5, 0)};
  const CycleTime t = cycle_time(program, machine());
  EXPECT_NEAR(t.cutting, 2 * (50.0 / 50 + 50.0 / 1000), 1e-12);
  EXPECT_EQ(t.dwell, 3);
  EXPECT_NEAR(t.total, t.cutting + 3, 1e-12);
  ASSERT_EQ(t.tools.size(), 1u);
  EXPECT_EQ(t.tools[0].dwell, 3);
  EXPECT_EQ(t.seconds.size(), 2u);
}

TEST(CycleTime, DwellsBehindAToolChangeAreThoseOfTheNextTool) {
  Motion a = line({0, 0, 0}, {50, 0, 0}, 3000), way = rapid({50, 0, 0}, {50, 0, 9}), b = a;
  way.tool = -1, b.tool = 1;
  Program program = program_of({a, way, b});
  program.events = {dwell(0, 1, -1), dwell(1, 2, 0), dwell(1, 4, -1), dwell(2, 8, -1),
                    dwell(3, 16, -1)};
  const CycleTime t = cycle_time(program, machine());
  EXPECT_EQ(t.dwell, 31);
  for (const ToolTime& tool : t.tools)
    EXPECT_EQ(tool.dwell, tool.tool == 0 ? 3 : tool.tool == 1 ? 12 : 16) << tool.tool;
}

// Two halves of a line: in one go under G64, with a stop between them under G60, G61.1 and G9.
TEST(CycleTime, ExactStopsStopAtTheEndOfEachMotion) {
  Program program =
      program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {100, 0, 0}, 3000)});
  const double v = 50, through = 100 / v + v / 1000, stopped = 2 * (50 / v + v / 1000);
  const auto cutting = [&](std::vector<Event> events) {
    program.events = std::move(events);
    return cycle_time(program, machine()).cutting;
  };
  EXPECT_NEAR(cutting({path(0, PathMode::exact_stop)}), stopped, 1e-12);
  EXPECT_NEAR(cutting({path(1, PathMode::exact_once)}), stopped, 1e-12);
  EXPECT_NEAR(cutting({path(0, PathMode::exact_stop), path(1, PathMode::continuous)}), stopped,
              1e-12)
      << "the first motion ran under G60";
  EXPECT_NEAR(cutting({path(0, PathMode::exact_stop), path(0, PathMode::continuous)}), through,
              1e-12);
  EXPECT_NEAR(cutting({path(1, PathMode::exact_stop)}), through, 1e-12)
      << "the second motion stops at its end, as it does anyway";
  EXPECT_NEAR(cutting({path(0, PathMode::exact_path)}), through, 1e-12) << "no corner";
}

TEST(CycleTime, AnExactPathStopsAtCorners) {
  Program program =
      program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {50, 50, 0}, 3000)});
  program.events = {path(0, PathMode::exact_path)};
  EXPECT_NEAR(cycle_time(program, machine()).cutting, 2 * (50.0 / 50 + 50.0 / 1000), 1e-12);
}

// 1000 rev/min at 500 rev/min a second: 2 s from rest, 4 s from one direction into the other.
TEST(CycleTime, ASpindleThatWasStoppedRunsUpAgain) {
  Motion a = line({0, 0, 0}, {50, 0, 0}, 3000), b = line({50, 0, 0}, {100, 0, 0}, 3000);
  a.speed = b.speed = 1000;
  Program program = program_of({a, b});
  MachineData slow = machine();
  slow.spindle_acceleration = 500;
  const auto seconds = [&](std::vector<Event> events) {
    program.events = std::move(events);
    return cycle_time(program, slow).spindle;
  };
  using enum SpindleTurn;
  EXPECT_NEAR(seconds({}), 2, 1e-12) << "a program without a word about it";
  EXPECT_NEAR(seconds({spindle(0, clockwise)}), 2, 1e-12);
  EXPECT_NEAR(seconds({spindle(0, clockwise), spindle(1, off), spindle(1, clockwise)}), 4, 1e-12);
  EXPECT_NEAR(seconds({spindle(0, clockwise), spindle(1, counter_clockwise)}), 6, 1e-12);
  EXPECT_NEAR(seconds({spindle(0, clockwise), spindle(2, off)}), 2, 1e-12);
  EXPECT_NEAR(seconds({spindle(0, clockwise), spindle(1, off)}), 2, 1e-12) << "it stands";
}

TEST(CycleTime, ProgrammedStopsAreCountedAndStopTheTool) {
  Program program =
      program_of({line({0, 0, 0}, {50, 0, 0}, 3000), line({50, 0, 0}, {100, 0, 0}, 3000)});
  Event stop;
  stop.kind = EventKind::stop;
  stop.before = 1;
  Event perhaps = stop, end = stop;
  perhaps.stop = StopKind::optional, end.stop = StopKind::end;
  perhaps.before = end.before = 2;
  program.events = {stop, perhaps, end};
  const CycleTime t = cycle_time(program, machine());
  EXPECT_EQ(t.stops, 1u);
  EXPECT_EQ(t.optional_stops, 1u);
  EXPECT_NEAR(t.total, 2 * (50.0 / 50 + 50.0 / 1000), 1e-12);
}

TEST(CycleTime, CutsWithoutAFeedAreCounted) {
  const CycleTime t = cycle_time(program_of({line({0, 0, 0}, {1, 0, 0}, 0)}), machine());
  EXPECT_EQ(t.without_feed, 1u);
  EXPECT_EQ(t.total, 0);
}

}  // namespace
}  // namespace mrsim
