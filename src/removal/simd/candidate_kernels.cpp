// Instruction sets of the pruning loops: each namespace defines a register V of floats and how to
// fill it, then includes the loops. As in sweep_kernels.cpp one build runs everywhere.
#include "removal/simd/candidate_kernels.h"

#include "removal/simd/sweep_kernels.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define MRSIM_X86 1
#ifndef __clang__  // GCC 12 warns of its own AVX-512 header (GCC bug 105593)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>
#endif

namespace mrsim {
namespace {
constexpr float kLaneNumbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}  // namespace

namespace candidates_scalar {
namespace {

constexpr std::size_t kLanes = 1;
using V = float;
using M = bool;
#define MRSIM_LANE inline
MRSIM_LANE V splat(float a) { return a; }
MRSIM_LANE V load(const float* p) { return *p; }
MRSIM_LANE void store(float* p, V v) { *p = v; }
MRSIM_LANE V vmin(V a, V b) { return a < b ? a : b; }
MRSIM_LANE V vmax(V a, V b) { return a > b ? a : b; }
MRSIM_LANE V vabs(V a) { return std::fabs(a); }
MRSIM_LANE V vsqrt(V a) { return std::sqrt(a); }
MRSIM_LANE M less(V a, V b) { return a < b; }
MRSIM_LANE M less_equal(V a, V b) { return a <= b; }
MRSIM_LANE M equal(V a, V b) { return a == b; }
MRSIM_LANE V select(M m, V a, V b) { return m ? a : b; }
MRSIM_LANE M splat_mask(bool b) { return b; }
MRSIM_LANE M first_lanes(std::size_t) { return true; }
MRSIM_LANE M both(M a, M b) { return a && b; }
MRSIM_LANE M either(M a, M b) { return a || b; }
MRSIM_LANE M except(M a, M b) { return a && !b; }
MRSIM_LANE bool any(M m) { return m; }
MRSIM_LANE std::size_t first_set(M m) { return m ? 0 : kLanes; }
MRSIM_LANE float least_lane(V v) { return v; }
MRSIM_LANE std::size_t compress(float* out, V v, M m) {
  *out = v;
  return m ? 1 : 0;
}
#include "removal/simd/candidate_kernels.inl"
#undef MRSIM_LANE

}  // namespace
}  // namespace candidates_scalar

#ifdef MRSIM_X86

namespace {
// Which lanes of eight a mask keeps, first to last.
constexpr auto kPacked = [] {
  std::array<std::array<std::int32_t, 8>, 256> table{};
  for (unsigned mask = 0; mask < 256; ++mask)
    for (int lane = 0, to = 0; lane < 8; ++lane)
      if (mask >> lane & 1) table[mask][static_cast<std::size_t>(to++)] = lane;
  return table;
}();
}  // namespace

#define MRSIM_LANE static inline __attribute__((always_inline))

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace candidates_avx2 {
namespace {

constexpr std::size_t kLanes = 8;
using V = __m256;
using M = __m256;
MRSIM_LANE V splat(float a) { return _mm256_set1_ps(a); }
MRSIM_LANE V load(const float* p) { return _mm256_loadu_ps(p); }
MRSIM_LANE void store(float* p, V v) { _mm256_storeu_ps(p, v); }
MRSIM_LANE V vmin(V a, V b) { return _mm256_min_ps(a, b); }
MRSIM_LANE V vmax(V a, V b) { return _mm256_max_ps(a, b); }
MRSIM_LANE V vabs(V a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); }
MRSIM_LANE V vsqrt(V a) { return _mm256_sqrt_ps(a); }
MRSIM_LANE M less(V a, V b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
MRSIM_LANE M less_equal(V a, V b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
MRSIM_LANE M equal(V a, V b) { return _mm256_cmp_ps(a, b, _CMP_EQ_OQ); }
MRSIM_LANE V select(M m, V a, V b) { return _mm256_blendv_ps(b, a, m); }
MRSIM_LANE M splat_mask(bool b) { return _mm256_castsi256_ps(_mm256_set1_epi32(b ? -1 : 0)); }
MRSIM_LANE M first_lanes(std::size_t n) {
  const int count = n < kLanes ? static_cast<int>(n) : static_cast<int>(kLanes);
  return _mm256_castsi256_ps(
      _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7)));
}
MRSIM_LANE M both(M a, M b) { return _mm256_and_ps(a, b); }
MRSIM_LANE M either(M a, M b) { return _mm256_or_ps(a, b); }
MRSIM_LANE M except(M a, M b) { return _mm256_andnot_ps(b, a); }
MRSIM_LANE unsigned bits(M m) { return static_cast<unsigned>(_mm256_movemask_ps(m)); }
MRSIM_LANE bool any(M m) { return bits(m) != 0; }
MRSIM_LANE std::size_t first_set(M m) {
  return static_cast<std::size_t>(std::countr_zero(bits(m) | 256u));
}
MRSIM_LANE float least_lane(V v) {
  __m128 m = _mm_min_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}
MRSIM_LANE std::size_t compress(float* out, V v, M m) {
  const unsigned mask = bits(m);
  const auto* lanes = reinterpret_cast<const __m256i_u*>(kPacked[mask].data());
  store(out, _mm256_permutevar8x32_ps(v, _mm256_loadu_si256(lanes)));
  return static_cast<std::size_t>(std::popcount(mask));
}
#include "removal/simd/candidate_kernels.inl"

}  // namespace
}  // namespace candidates_avx2
#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,popcnt")
#endif
namespace candidates_avx512 {
namespace {

constexpr std::size_t kLanes = 16;
using V = __m512;
using M = __mmask16;
MRSIM_LANE V splat(float a) { return _mm512_set1_ps(a); }
MRSIM_LANE V load(const float* p) { return _mm512_loadu_ps(p); }
MRSIM_LANE void store(float* p, V v) { _mm512_storeu_ps(p, v); }
MRSIM_LANE V vmin(V a, V b) { return _mm512_min_ps(a, b); }
MRSIM_LANE V vmax(V a, V b) { return _mm512_max_ps(a, b); }
MRSIM_LANE V vabs(V a) { return _mm512_abs_ps(a); }
MRSIM_LANE V vsqrt(V a) { return _mm512_sqrt_ps(a); }
MRSIM_LANE M less(V a, V b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
MRSIM_LANE M less_equal(V a, V b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
MRSIM_LANE M equal(V a, V b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
MRSIM_LANE V select(M m, V a, V b) { return _mm512_mask_blend_ps(m, b, a); }
MRSIM_LANE M splat_mask(bool b) { return static_cast<M>(b ? 0xffff : 0); }
MRSIM_LANE M first_lanes(std::size_t n) {
  return static_cast<M>(n < kLanes ? (1u << n) - 1 : 0xffffu);
}
MRSIM_LANE M both(M a, M b) { return static_cast<M>(a & b); }
MRSIM_LANE M either(M a, M b) { return static_cast<M>(a | b); }
MRSIM_LANE M except(M a, M b) { return static_cast<M>(a & ~b); }
MRSIM_LANE bool any(M m) { return m != 0; }
MRSIM_LANE std::size_t first_set(M m) {
  return static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(m) | 0x10000u));
}
MRSIM_LANE float least_lane(V v) { return _mm512_reduce_min_ps(v); }
MRSIM_LANE std::size_t compress(float* out, V v, M m) {
  store(out, _mm512_maskz_compress_ps(m, v));
  return static_cast<std::size_t>(std::popcount(static_cast<unsigned>(m)));
}
#include "removal/simd/candidate_kernels.inl"

}  // namespace
}  // namespace candidates_avx512
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#endif  // MRSIM_X86

const CandidateKernels* candidate_kernels(InstructionSet isa) {
#ifdef MRSIM_X86
  return kernels_at<CandidateKernels>(
      isa,
      {&candidates_scalar::kKernels, &candidates_avx2::kKernels, &candidates_avx512::kKernels});
#else
  return kernels_at<CandidateKernels>(isa, {&candidates_scalar::kKernels, nullptr, nullptr});
#endif
}

const CandidateKernels& candidate_kernels() {
  static const CandidateKernels& best = *candidate_kernels(best_instruction_set());
  return best;
}

}  // namespace mrsim
