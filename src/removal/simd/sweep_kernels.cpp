// Instruction sets: each namespace defines a register V and how to fill it, then includes the forms
// and the loops. Targets are set for these functions alone, so that one build runs everywhere; FMA
// is never among them (contraction would change bits).
#include "removal/simd/sweep_kernels.h"

#include "core/numbers/units.h"
#include "core/process/error.h"
#include "core/words/suggest.h"
#include "removal/simd/lane_scalar.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>

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

// A record as the numbers that it begins with. load_columns() takes eight of them of each lane's.
template <class Record>
const double* numbers_of(const Record* records, std::uint32_t row) {
  static_assert(sizeof(Record) % sizeof(double) == 0);
  return reinterpret_cast<const double*>(records + row);
}

}  // namespace

namespace lane {
namespace {

constexpr std::size_t kLanes = 1;
constexpr const char* kName = "scalar";
#define MRSIM_LANE inline
MRSIM_LANE V load(const double* p) { return *p; }
template <class Record>
MRSIM_LANE void load_columns(const Record* r, std::size_t from, const std::uint32_t* rows, V* c) {
  const double* p = numbers_of(r, rows[0]) + from;
  for (int i = 0; i < 8; ++i) c[i] = p[i];
}
MRSIM_LANE void load_line(const LineRecord* r, const std::uint32_t* rows, V* c) {
  load_columns(r, 0, rows, c);
}
MRSIM_LANE void load_arc(const ArcRecord* r, const std::uint32_t* rows, V* c) {
  for (int i = 0; i < 11; ++i) c[i] = r[rows[0]].c[i];
}
MRSIM_LANE void store(double* out, V v) { *out = v; }
MRSIM_LANE void store_some(double* out, V v, std::size_t) { *out = v; }
#include "removal/simd/sweep_kernels.inl"
#undef MRSIM_LANE

}  // namespace
}  // namespace lane

#ifdef MRSIM_X86

#define MRSIM_LANE static inline __attribute__((always_inline))

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2 {
namespace {

constexpr std::size_t kLanes = 4;
constexpr const char* kName = "AVX2";
using V = __m256d;
using M = __m256d;
MRSIM_LANE V splat(double a) { return _mm256_set1_pd(a); }
MRSIM_LANE V load(const double* p) { return _mm256_loadu_pd(p); }
MRSIM_LANE M less(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
MRSIM_LANE M both(M a, M b) { return _mm256_and_pd(a, b); }
MRSIM_LANE M either(M a, M b) { return _mm256_or_pd(a, b); }
MRSIM_LANE M except(M a, M b) { return _mm256_andnot_pd(b, a); }
MRSIM_LANE unsigned bits(M m) { return static_cast<unsigned>(_mm256_movemask_pd(m)); }
MRSIM_LANE V vmin(V a, V b) { return _mm256_min_pd(a, b); }
MRSIM_LANE V vmax(V a, V b) { return _mm256_max_pd(a, b); }
MRSIM_LANE V vabs(V a) { return _mm256_max_pd(a, -a); }
MRSIM_LANE V vsqrt(V a) { return _mm256_sqrt_pd(a); }
MRSIM_LANE V vfloor(V a) { return _mm256_floor_pd(a); }
MRSIM_LANE M less_equal(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_LE_OQ); }
MRSIM_LANE V select(M m, V a, V b) { return _mm256_blendv_pd(b, a, m); }
// Four rows of four into four columns.
MRSIM_LANE void transpose(const double* a, const double* b, const double* c, const double* d,
                          V* out) {
  const V ra = _mm256_loadu_pd(a), rb = _mm256_loadu_pd(b), rc = _mm256_loadu_pd(c),
          rd = _mm256_loadu_pd(d);
  const V ab0 = _mm256_unpacklo_pd(ra, rb), ab1 = _mm256_unpackhi_pd(ra, rb);
  const V cd0 = _mm256_unpacklo_pd(rc, rd), cd1 = _mm256_unpackhi_pd(rc, rd);
  out[0] = _mm256_permute2f128_pd(ab0, cd0, 0x20);
  out[1] = _mm256_permute2f128_pd(ab1, cd1, 0x20);
  out[2] = _mm256_permute2f128_pd(ab0, cd0, 0x31);
  out[3] = _mm256_permute2f128_pd(ab1, cd1, 0x31);
}
template <class Record>
MRSIM_LANE void load_columns(const Record* r, std::size_t from, const std::uint32_t* rows, V* c) {
  const double *p0 = numbers_of(r, rows[0]) + from, *p1 = numbers_of(r, rows[1]) + from,
               *p2 = numbers_of(r, rows[2]) + from, *p3 = numbers_of(r, rows[3]) + from;
  transpose(p0, p1, p2, p3, c);
  transpose(p0 + 4, p1 + 4, p2 + 4, p3 + 4, c + 4);
}
MRSIM_LANE void load_line(const LineRecord* r, const std::uint32_t* rows, V* c) {
  load_columns(r, 0, rows, c);
}
MRSIM_LANE void load_arc(const ArcRecord* r, const std::uint32_t* rows, V* c) {
  load_columns(r, 0, rows, c);
  const double *p0 = r[rows[0]].c, *p1 = r[rows[1]].c, *p2 = r[rows[2]].c, *p3 = r[rows[3]].c;
  c[ArcSlot::core] =
      _mm256_set_pd(p3[ArcSlot::core], p2[ArcSlot::core], p1[ArcSlot::core], p0[ArcSlot::core]);
  c[ArcSlot::round] =
      _mm256_set_pd(p3[ArcSlot::round], p2[ArcSlot::round], p1[ArcSlot::round], p0[ArcSlot::round]);
  c[ArcSlot::top] =
      _mm256_set_pd(p3[ArcSlot::top], p2[ArcSlot::top], p1[ArcSlot::top], p0[ArcSlot::top]);
}
MRSIM_LANE void store(double* out, V v) { _mm256_storeu_pd(out, v); }
MRSIM_LANE void store_some(double* out, V v, std::size_t n) {
  if (n >= kLanes) return _mm256_storeu_pd(out, v);
  alignas(32) double lanes[kLanes];
  _mm256_store_pd(lanes, v);
  for (std::size_t j = 0; j < n; ++j) out[j] = lanes[j];
}
#include "core/numbers/trig_lanes.inl"
//
#include "removal/simd/all_lanes.inl"
//
#include "removal/simd/sweep_kernels.inl"

}  // namespace
}  // namespace avx2
#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f")
#endif
namespace avx512 {
namespace {

constexpr std::size_t kLanes = 8;
constexpr const char* kName = "AVX-512";
using V = __m512d;
using M = __mmask8;
MRSIM_LANE V splat(double a) { return _mm512_set1_pd(a); }
MRSIM_LANE V load(const double* p) { return _mm512_loadu_pd(p); }
MRSIM_LANE M less(V a, V b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
MRSIM_LANE M both(M a, M b) { return static_cast<M>(a & b); }
MRSIM_LANE M either(M a, M b) { return static_cast<M>(a | b); }
MRSIM_LANE M except(M a, M b) { return static_cast<M>(a & ~b); }
MRSIM_LANE unsigned bits(M m) { return m; }
MRSIM_LANE V vmin(V a, V b) { return _mm512_min_pd(a, b); }
MRSIM_LANE V vmax(V a, V b) { return _mm512_max_pd(a, b); }
MRSIM_LANE V vabs(V a) { return _mm512_max_pd(a, -a); }
MRSIM_LANE V vsqrt(V a) { return _mm512_sqrt_pd(a); }
MRSIM_LANE V vfloor(V a) { return _mm512_floor_pd(a); }
MRSIM_LANE M less_equal(V a, V b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
MRSIM_LANE V select(M m, V a, V b) { return _mm512_mask_blend_pd(m, b, a); }
// Eight rows of eight into eight columns: pairs, then pairs of pairs, then halves.
MRSIM_LANE void transpose(const V* r, V* c) {
  V pair[8], quad[8];
  for (int i = 0; i < 4; ++i) {
    pair[2 * i] = _mm512_unpacklo_pd(r[2 * i], r[2 * i + 1]);
    pair[2 * i + 1] = _mm512_unpackhi_pd(r[2 * i], r[2 * i + 1]);
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      quad[4 * i + j] = _mm512_shuffle_f64x2(pair[4 * i + j], pair[4 * i + j + 2], 0x88);
      quad[4 * i + j + 2] = _mm512_shuffle_f64x2(pair[4 * i + j], pair[4 * i + j + 2], 0xdd);
    }
  }
  for (int j = 0; j < 2; ++j) {
    c[j] = _mm512_shuffle_f64x2(quad[j], quad[4 + j], 0x88);
    c[j + 4] = _mm512_shuffle_f64x2(quad[j], quad[4 + j], 0xdd);
    c[j + 2] = _mm512_shuffle_f64x2(quad[j + 2], quad[4 + j + 2], 0x88);
    c[j + 6] = _mm512_shuffle_f64x2(quad[j + 2], quad[4 + j + 2], 0xdd);
  }
}
template <class Record>
MRSIM_LANE void load_columns(const Record* r, std::size_t from, const std::uint32_t* rows, V* c) {
  V row[8];
  for (int j = 0; j < 8; ++j) row[j] = _mm512_loadu_pd(numbers_of(r, rows[j]) + from);
  transpose(row, c);
}
MRSIM_LANE void load_line(const LineRecord* r, const std::uint32_t* rows, V* c) {
  load_columns(r, 0, rows, c);
}
MRSIM_LANE V column(const ArcRecord* r, const std::uint32_t* rows, int i) {
  return _mm512_set_pd(r[rows[7]].c[i], r[rows[6]].c[i], r[rows[5]].c[i], r[rows[4]].c[i],
                       r[rows[3]].c[i], r[rows[2]].c[i], r[rows[1]].c[i], r[rows[0]].c[i]);
}
MRSIM_LANE void load_arc(const ArcRecord* r, const std::uint32_t* rows, V* c) {
  load_columns(r, 0, rows, c);
  c[ArcSlot::core] = column(r, rows, ArcSlot::core);
  c[ArcSlot::round] = column(r, rows, ArcSlot::round);
  c[ArcSlot::top] = column(r, rows, ArcSlot::top);
}
MRSIM_LANE void store(double* out, V v) { _mm512_storeu_pd(out, v); }
MRSIM_LANE void store_some(double* out, V v, std::size_t n) {
  _mm512_mask_storeu_pd(out, static_cast<__mmask8>((1u << n) - 1), v);
}
#include "core/numbers/trig_lanes.inl"
//
#include "removal/simd/all_lanes.inl"
//
#include "removal/simd/sweep_kernels.inl"

}  // namespace
}  // namespace avx512
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

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
