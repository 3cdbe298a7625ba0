// The kernels of candidate lists, once for each instruction set (registers.h).
#include "removal/simd/candidate_kernels.h"

#include "removal/simd/registers.h"
#include "removal/simd/sweep_kernels.h"

#include <cmath>
#include <limits>

namespace mrsim {
namespace {
constexpr float kLaneNumbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}  // namespace

#define MRSIM_LANE inline
namespace lane {
namespace candidates {
namespace {

using V = Floats;
using M = FloatMask;
constexpr std::size_t kLanes = kFloatLanes;
#include "removal/simd/candidate_kernels.inl"

}  // namespace
}  // namespace candidates
}  // namespace lane
#undef MRSIM_LANE

#ifdef MRSIM_X86

#define MRSIM_LANE static inline __attribute__((always_inline))

MRSIM_BEGIN_TARGET("avx2")
namespace avx2 {
namespace candidates {
namespace {

using V = Floats;
using M = FloatMask;
constexpr std::size_t kLanes = kFloatLanes;
#include "removal/simd/candidate_kernels.inl"

}  // namespace
}  // namespace candidates
}  // namespace avx2
MRSIM_END_TARGET

MRSIM_BEGIN_TARGET("avx512f")
namespace avx512 {
namespace candidates {
namespace {

using V = Floats;
using M = FloatMask;
constexpr std::size_t kLanes = kFloatLanes;
#include "removal/simd/candidate_kernels.inl"

}  // namespace
}  // namespace candidates
}  // namespace avx512
MRSIM_END_TARGET

#endif  // MRSIM_X86

const CandidateKernels* candidate_kernels(InstructionSet isa) {
#ifdef MRSIM_X86
  return kernels_at<CandidateKernels>(
      isa,
      {&lane::candidates::kKernels, &avx2::candidates::kKernels, &avx512::candidates::kKernels});
#else
  return kernels_at<CandidateKernels>(isa, {&lane::candidates::kKernels, nullptr, nullptr});
#endif
}

const CandidateKernels& candidate_kernels() {
  static const CandidateKernels& best = *candidate_kernels(best_instruction_set());
  return best;
}

}  // namespace mrsim
