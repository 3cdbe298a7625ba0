#include "interp/turning/thread_cycles.h"

#include "core/numbers/trig.h"
#include "interp/cycles/iso_pitch.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mrsim {

bool ThreadCycles::run() {
  if (call_.name == "CYCLE97") return thread_list();
  return call_.name == "CYCLE98" ? thread_chain() : thread_turning();
}

// Finds the depths of the passes from TDEP FAL NRC NID. VARI says whether depths or cross-sections
// are equal. Then come the finishing cut and NID more passes.
bool ThreadCycles::thread_depths(Thread& t, int kind, bool rough, bool finish) {
  const double unit = scale(), full = std::abs(call_.get("TDEP")) * unit;
  const double left = full - std::abs(call_.get("FAL")) * unit;
  const double number = call_.get("NRC"), spare = call_.get("NID");
  if (full <= 0 || left <= 0)
    return fail("value-range", fmt::format("{} needs TDEP, its depth, above FAL", call_.name));
  if (number < 1 || number > 1000 || spare < 0 || spare > 1000)
    return fail("value-range",
                fmt::format("{}: NRC is 1 to 1000 cuts and NID 0 to 1000", call_.name));
  const int n = rough ? static_cast<int>(number) : 0;
  for (int i = 1; i <= n; ++i) {
    const double share = static_cast<double>(i) / n;
    t.depths.push_back(left * (kind > 2 ? std::sqrt(share) : share));
  }
  if (finish && (full > left || !rough)) t.depths.push_back(full);
  if (finish) t.depths.insert(t.depths.end(), static_cast<std::size_t>(spare), full);
  t.inside = kind == 2 || kind == 4;
  return true;
}

// The values of CYCLE97: PIT MPIT SPL FPL DM1 DM2 APP ROP TDEP FAL IANG NSP NRC NID VARI NUMT VRT.
bool ThreadCycles::thread_list() {
  const double unit = scale(), kind = call_.get("VARI", 1);
  double pitch = std::abs(call_.get("PIT")) * unit;
  if (pitch == 0) pitch = iso_pitch(std::abs(call_.get("MPIT")));
  if (kind < 1 || kind > 4 || kind != std::floor(kind))
    return fail("not-supported", fmt::format("CYCLE97: VARI {:g} is not supported yet", kind));
  Thread t;
  t.points = {{call_.get("DM1") * unit / 2, 0, call_.get("SPL") * unit},
              {call_.get("DM2") * unit / 2, 0, call_.get("FPL") * unit}};
  t.pitches = {pitch};
  return old_thread(t, static_cast<int>(kind));
}

// Reads the values that CYCLE97 and CYCLE98 have in common.
bool ThreadCycles::old_thread(Thread& t, int kind) {
  const double unit = scale();
  t.run_in = std::abs(call_.get("APP")) * unit;
  t.run_out = std::abs(call_.get("ROP")) * unit;
  t.flank = call_.get("IANG");
  t.starts = std::clamp(static_cast<int>(call_.get("NUMT", 1)), 1, 100);
  t.clear = call_.get("VRT") > 0 ? call_.get("VRT") * unit : 1;
  return thread_depths(t, kind, true, true) && thread(t);
}

// The values of CYCLE98: PO1 DM1 PO2 DM2 PO3 DM3 PO4 DM4 APP ROP TDEP FAL IANG NSP NRC NID PP1 PP2
// PP3 VARI NUMT VRT.
bool ThreadCycles::thread_chain() {
  const double unit = scale(), kind = call_.get("VARI", 1);
  if (call_.values.size() > 22) return refuse("a list of more than 22 values");
  if (kind < 1 || kind > 4 || kind != std::floor(kind))
    return fail("not-supported", fmt::format("CYCLE98: VARI {:g} is not supported yet", kind));
  Thread t;
  static constexpr ValueName kPoints[][2] = {
      {"PO1", "DM1"}, {"PO2", "DM2"}, {"PO3", "DM3"}, {"PO4", "DM4"}};
  for (const auto& [place, diameter] : kPoints) {
    if (!call_.given({place, diameter}))
      return fail("value-missing", "CYCLE98 needs four points, PO1 DM1 to PO4 DM4");
    t.points.push_back({call_.get(diameter) * unit / 2, 0, call_.get(place) * unit});
  }
  for (const ValueName pitch : std::initializer_list<ValueName>{"PP1", "PP2", "PP3"})
    t.pitches.push_back(std::abs(call_.get(pitch)) * unit);
  return old_thread(t, static_cast<int>(kind));
}

// The values of CYCLE99: SPL SPD FPL FPD APP ROP TDEP FAL IANG NSP NRC NID PIT VARI NUMTH SDIS MID
// GDEP PIT1 FDEP GST GUD IFLANK PITA PITM PTAB PTABA DMODE AMODE.
bool ThreadCycles::thread_turning() {
  const double unit = scale();
  const int kind = call_.digit("VARI", 0), work = call_.digit("VARI", 5);
  if (!call_.given({"SPL", "SPD", "FPL", "PIT", "VARI"}))
    return fail("value-missing", "CYCLE99 needs SPL, SPD, FPL, PIT and VARI");
  if (call_.values.size() > 29) return refuse("a list of more than 29 values");
  if (call_.get("AMODE") != 0) return refuse("an incremental end point or run-in (AMODE)");
  if (call_.get("PIT1") != 0) return refuse("a pitch that changes (PIT1)");
  if (call_.get("PITA") > 1) return refuse("a pitch in threads per inch or modules (PITA)");
  if (call_.digit("VARI", 4) != 0) return refuse("passes by the first infeed (VARI)");
  if (kind < 1 || kind > 4 || work > 3) return refuse("this VARI");
  Thread t;
  const double from = call_.get("SPD") * unit / 2;
  t.points = {
      {from, 0, call_.get("SPL") * unit},
      {call_.given("FPD") ? call_.get("FPD") * unit / 2 : from, 0, call_.get("FPL") * unit}};
  t.pitches = {std::abs(call_.get("PIT")) * unit};
  t.run_in = std::abs(call_.get("APP")) * unit;
  t.run_out = std::abs(call_.get("ROP")) * unit;
  t.flank = call_.get("IANG");
  t.starts = std::clamp(static_cast<int>(call_.get("NUMTH", 1)), 1, 100);
  t.clear = call_.get("SDIS") > 0 ? call_.get("SDIS") * unit : 1;
  return thread_depths(t, kind, work != 2, work != 1) && thread(t);
}

bool ThreadCycles::thread(const Thread& t) {
  const Vec3 first = t.points.front(), last = t.points.back();
  for (const double pitch : t.pitches)
    if (pitch <= 0)
      return fail("thread-lead", fmt::format("{} needs the pitch of the thread", call_.name));
  if (std::abs(last.z - first.z) <= std::abs(last.x - first.x)) return refuse("a thread on a face");
  const double along = last.z < first.z ? -1 : 1, in = t.inside ? 1 : -1;
  const auto slope = [&](std::size_t i) {
    const Vec3 d = t.points[i + 1] - t.points[i];
    return d.x / d.z;
  };
  const double begin = first.z - along * t.run_in;
  const Vec3 end = last + along * t.run_out * Vec3{slope(t.pitches.size() - 1), 0, 1};
  const double run_in = first.x + (begin - first.z) * slope(0);
  double clear = t.inside ? std::min(run_in, end.x) : std::max(run_in, end.x);
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    if (i > 0 && (t.points[i].z - t.points[i - 1].z) * along <= 0)
      return fail("value-range",
                  fmt::format("{}: the points of the thread run back along Z", call_.name));
    clear = t.inside ? std::min(clear, t.points[i].x) : std::max(clear, t.points[i].x);
  }
  clear -= in * t.clear;
  const SinCos flank = sincos_deg(t.flank);
  to(clear, position_.programmed.z, MotionKind::rapid);
  for (int k = 0; k < t.starts; ++k)
    for (const double depth : t.depths) {
      const double z = begin + along * depth * flank.sin / flank.cos;
      to(clear, z, MotionKind::rapid);
      to(first.x + (z - first.z) * slope(0) + in * depth, z, MotionKind::rapid);
      for (std::size_t i = 1; i + 1 < t.points.size(); ++i)
        to(t.points[i].x + in * depth, t.points[i].z, MotionKind::line, t.pitches[i - 1]);
      to(end.x + in * depth, end.z, MotionKind::line, t.pitches.back());
      to(clear, end.z, MotionKind::rapid);
    }
  to(clear, begin, MotionKind::rapid);
  return true;
}

}  // namespace mrsim
