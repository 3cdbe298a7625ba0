// The kernels of sweeps, once for each instruction set (registers.h).
#include "removal/simd/sweep_kernels.h"

#include "core/numbers/units.h"
#include "core/process/error.h"
#include "core/words/suggest.h"
#include "removal/simd/registers.h"
#include "removal/simd/scalar_forms.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace mrsim {
namespace {

// A record as the numbers that it begins with. load_columns() takes eight of them of each lane's.
template <class Record>
const double* numbers_of(const Record* records, std::uint32_t row) {
  static_assert(sizeof(Record) % sizeof(double) == 0);
  return reinterpret_cast<const double*>(records + row);
}

}  // namespace

namespace lane {
namespace {

constexpr std::size_t kLanes = kDoubleLanes;
constexpr const char* kName = "scalar";
#define MRSIM_LANE inline
#include "removal/simd/sweep_kernels.inl"
#undef MRSIM_LANE

}  // namespace
}  // namespace lane

#ifdef MRSIM_X86

#define MRSIM_LANE static inline __attribute__((always_inline))

MRSIM_BEGIN_TARGET("avx2")
namespace avx2 {
namespace {

using V = Doubles;
using M = DoubleMask;
constexpr std::size_t kLanes = kDoubleLanes;
constexpr const char* kName = "AVX2";
#include "core/numbers/trig_lanes.inl"
//
#include "removal/simd/all_lanes.inl"
//
#include "removal/simd/sweep_kernels.inl"

}  // namespace
}  // namespace avx2
MRSIM_END_TARGET

MRSIM_BEGIN_TARGET("avx512f")
namespace avx512 {
namespace {

using V = Doubles;
using M = DoubleMask;
constexpr std::size_t kLanes = kDoubleLanes;
constexpr const char* kName = "AVX-512";
#include "core/numbers/trig_lanes.inl"
//
#include "removal/simd/all_lanes.inl"
//
#include "removal/simd/sweep_kernels.inl"

}  // namespace
}  // namespace avx512
MRSIM_END_TARGET

#endif  // MRSIM_X86

bool has_simd(InstructionSet isa) {
#ifdef MRSIM_X86
  if (isa == InstructionSet::avx512) return __builtin_cpu_supports("avx512f");
  if (isa == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
#endif
  return isa == InstructionSet::scalar;
}

const SweepKernels* sweep_kernels(InstructionSet isa) {
#ifdef MRSIM_X86
  return kernels_at<SweepKernels>(isa, {&lane::kKernels, &avx2::kKernels, &avx512::kKernels});
#else
  return kernels_at<SweepKernels>(isa, {&lane::kKernels, nullptr, nullptr});
#endif
}

InstructionSet best_instruction_set() {
  static constexpr std::string_view kNames[] = {"scalar", "avx2", "avx512"};
  const char* set = std::getenv("MRSIM_SIMD");
  const std::string_view most = set == nullptr || *set == 0 ? kNames[2] : set;
  const auto* name = std::find(std::begin(kNames), std::end(kNames), most);
  if (name == std::end(kNames))
    throw Error("simd-unknown",
                fmt::format("MRSIM_SIMD={} in the environment is none of scalar, avx2 and avx512{}",
                            most, suggestion(most, kNames)),
                Error::Kind::usage);
  auto isa = static_cast<int>(name - std::begin(kNames));
  while (!has_simd(static_cast<InstructionSet>(isa))) --isa;
  return static_cast<InstructionSet>(isa);
}

const SweepKernels& sweep_kernels() {
  static const SweepKernels& best = *sweep_kernels(best_instruction_set());
  return best;
}

}  // namespace mrsim
