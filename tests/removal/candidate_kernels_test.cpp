// The loops of pruning: the same for every instruction set, whatever the columns hold.
#include "removal/simd/candidate_kernels.h"

#include "removal/prune/candidate_list.h"
#include "removal/simd/sweep_kernels.h"
#include "sweep_support.h"

#include <bit>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace testing;

constexpr std::size_t kSlots = 96;

struct Table {
  alignas(64) float slots[kCandidateColumns][kSlots] = {};
  CandidateColumns columns() const { return {slots[0], kSlots}; }
};

Table random_columns(Random& r, int form) {
  Table t;
  for (std::size_t k = 0; k < kSlots; ++k) {
    const auto put = [&](std::initializer_list<double> values) {
      std::size_t i = 0;
      for (const double v : values) t.slots[i++][k] = static_cast<float>(v);
    };
    const double angle = r(-4, 4), c = std::cos(angle), s = std::sin(angle), half = r(0, 3.1);
    const double x = r(-3, 3), y = r(-3, 3), z = 0.5 * r.pick(4), slope = r(-2, 2);
    if (form == 0) put({x, y, z, c, s, r(0, 1), slope, 1 / (1 + slope * slope)});
    if (form == 1) put({x, y, c, s, 1, z, z});
    if (form == 2) put({x, y, r(0.2, 4), c, s, std::cos(half), std::sin(half), z, z});
    t.slots[kIdColumn][k] = std::bit_cast<float>(static_cast<std::uint32_t>(3 * k));
  }
  return t;
}

// Rows, and the indices of what is kept, of one step of pruning.
std::vector<float> one_step(const CandidateKernels& kernels, const Table& table, int form,
                            std::size_t n) {
  Table found, kept;
  const CandidateRows rows{found.slots[0], found.slots[1], found.slots[2], found.slots[3],
                           found.slots[4], found.slots[5], found.slots[6]};
  KeepArgs args;
  args.at = {0.5f, 1, -0.5f, 0.25f, 0.25f, 0.43f, true, 1e-5f, 1e-4f, 1e-5f, {2, 1, 9, 1.9f, true}};
  const CandidateColumns c = table.columns();
  const LeastDistance least = (form == 0   ? kernels.strip
                               : form == 1 ? kernels.line
                                           : kernels.arc)(c, n, args.at, rows);
  const PlanBeaters j = kernels.plan(rows, n, least, 1.5f);
  const auto beater = [&](std::size_t k) {
    return Beater{rows.squared[k],       rows.x[k],      rows.y[k], rows.z[k],
                  rows.height_number[k], c[kIdColumn][k]};
  };
  args.plan = form > 0, args.rising = true, args.limit = least.distance + 1.2f, args.beyond = 9;
  args.beaters = 2, args.beater[0] = beater(j.nearest), args.beater[1] = beater(j.lowest);
  args.has_cover = form > 0 && j.cover < n;
  if (args.has_cover) args.cover = beater(j.cover);
  args.within = least.distance + 1.1f;
  bool reaches = false;
  const std::size_t left = kernels.keep(args, rows, c, n, 9, kept.slots[0], kSlots, reaches);
  std::vector<float> result(kept.slots[kIdColumn], kept.slots[kIdColumn] + left);
  result.push_back(reaches);
  if (form == 0) {
    float ids[kSlots + CandidateList::kPad];
    StripAt quarters[4];
    kernels.strip_quarters(c, n, args.at, 0.5f * args.at.half, quarters);
    for (const StripAt& own : quarters) {
      result.push_back(own.squared);
      result.push_back(static_cast<float>(own.slot));
    }
    const Beater strip = kernels.strip_beater({c.base + quarters[0].slot, c.stride}, 0, args.at);
    const float nearest = strip.squared;
    for (const float value : {strip.squared, strip.x, strip.y, strip.z}) result.push_back(value);
    bool strips_reach = false;
    const std::size_t some =
        kernels.strip_ids(c, n, args.at, strip, nearest + 4, std::sqrt(nearest), ids, strips_reach);
    result.insert(result.end(), ids, ids + some);
    result.push_back(strips_reach);
  }
  for (const auto& row : found.slots) result.insert(result.end(), row, row + n);
  return result;
}

TEST(CandidateKernels, QuartersHaveTheStripsNearestToThem) {
  Random r(4);
  const CandidateKernels& kernels = candidate_kernels();
  for (int round = 0; round < 200; ++round) {
    const Table table = random_columns(r, 0);
    const std::size_t n = 1 + static_cast<std::size_t>(r.pick(kSlots));
    Table found;
    const CandidateRows rows{found.slots[0], found.slots[1], found.slots[2], found.slots[3],
                             found.slots[4], found.slots[5], found.slots[6]};
    const RegionArgs at{0.5f, 1, -0.5f, 0.5f, 0.5f, 0.87f, true, 1e-5f, 1e-4f, 1e-5f, {2, 1, 9}};
    kernels.strip(table.columns(), n, at, rows);
    StripAt quarters[4];
    kernels.strip_quarters(table.columns(), n, at, 0.25f, quarters);
    for (int part = 0; part < 4; ++part) {
      const double x = part >> 1 ? 0.25 : -0.25, y = part & 1 ? 0.25 : -0.25;
      const auto squared = [&](std::size_t k) {
        const double dx = rows.x[k] - x, dy = rows.y[k] - y, dz = rows.z[k];
        return dx * dx + dy * dy + dz * dz;
      };
      ASSERT_LT(quarters[part].slot, n);
      for (std::size_t k = 0; k < n; ++k)
        EXPECT_LE(squared(quarters[part].slot), squared(k) + 1e-4) << "part " << part;
    }
  }
}

// All instruction sets run the same operations in the same order.
TEST(CandidateKernels, EveryInstructionSetKeepsTheSame) {
  Random r(3);
  for (int round = 0; round < 200; ++round)
    for (int form = 0; form < 3; ++form) {
      const Table table = random_columns(r, form);
      const std::size_t n = 1 + static_cast<std::size_t>(r.pick(kSlots));
      const std::vector<float> plain =
          one_step(*candidate_kernels(InstructionSet::scalar), table, form, n);
      for (const InstructionSet isa : {InstructionSet::avx2, InstructionSet::avx512}) {
        const CandidateKernels* set = candidate_kernels(isa);
        if (set == nullptr) continue;
        const std::vector<float> wide = one_step(*set, table, form, n);
        ASSERT_EQ(plain.size(), wide.size()) << "form " << form;
        ASSERT_EQ(std::memcmp(plain.data(), wide.data(), plain.size() * sizeof(float)), 0)
            << "form " << form << ", " << n << " sweeps";
      }
    }
}

}  // namespace
}  // namespace mrsim
