// The registers of each instruction set: how many numbers they hold, how these are loaded, compared
// and stored. The kernels are written once in terms of these functions and compiled once for each
// set (*_kernels.inl).
//
// Functions of one name do the same, lane by lane, in every set, for doubles and for floats: `less`
// gives a mask, select(m, a, b) takes a where m is set, except(a, b) is a and not b, bits(m) has a
// bit for each lane. Only operations that IEEE 754 rounds in one way are here; FMA is none of them.
// So all sets give the same bits.
//
// Targets are set for these functions alone, so that one build runs everywhere.
#pragma once

#include "core/numbers/lane_scalar.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define MRSIM_X86 1
#ifndef __clang__  // GCC 12 warns of its own AVX-512 header (GCC bug 105593)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>
#endif

// One number at a time. Arithmetic of doubles is in core/numbers/lane_scalar.h.
namespace mrsim::lane {

using Doubles = V;
using DoubleMask = M;
inline constexpr std::size_t kDoubleLanes = 1;
inline Doubles load(const double* p) { return *p; }
inline void store(double* out, Doubles v) { *out = v; }
inline void store_some(double* out, Doubles v, std::size_t) { *out = v; }
/// Number i of each row, one row a lane.
inline Doubles gather(const double* const* rows, std::size_t i) { return rows[0][i]; }
/// Numbers 0 to 7 of each row, one row a lane.
inline void load_eight(const double* const* rows, Doubles* out) {
  for (int i = 0; i < 8; ++i) out[i] = rows[0][i];
}

using Floats = float;
using FloatMask = bool;
inline constexpr std::size_t kFloatLanes = 1;
inline Floats splat(float a) { return a; }
inline Floats load(const float* p) { return *p; }
inline void store(float* p, Floats v) { *p = v; }
inline Floats vmin(Floats a, Floats b) { return a < b ? a : b; }
inline Floats vmax(Floats a, Floats b) { return a > b ? a : b; }
inline Floats vabs(Floats a) { return std::fabs(a); }
inline Floats vsqrt(Floats a) { return std::sqrt(a); }
inline FloatMask less(Floats a, Floats b) { return a < b; }
inline FloatMask less_equal(Floats a, Floats b) { return a <= b; }
inline FloatMask equal(Floats a, Floats b) { return a == b; }
inline Floats select(FloatMask m, Floats a, Floats b) { return m ? a : b; }
inline FloatMask splat_mask(bool b) { return b; }
/// Set in the first n lanes.
inline FloatMask first_lanes(std::size_t) { return true; }
/// The first lane that is set; kFloatLanes where none is.
inline std::size_t first_set(FloatMask m) { return m ? 0 : kFloatLanes; }
inline float least_lane(Floats v) { return v; }
/// Writes the lanes that m sets, one after the other; how many. Overwrites a whole register.
inline std::size_t compress(float* out, Floats v, FloatMask m) {
  *out = v;
  return m ? 1 : 0;
}

}  // namespace mrsim::lane

#ifdef MRSIM_X86

#define MRSIM_PRAGMA(...) _Pragma(#__VA_ARGS__)
/// Functions between these two are compiled for an instruction set.
#ifdef __clang__
#define MRSIM_BEGIN_TARGET(set) \
  MRSIM_PRAGMA(clang attribute push(__attribute__((target(set))), apply_to = function))
#define MRSIM_END_TARGET MRSIM_PRAGMA(clang attribute pop)
#else
#define MRSIM_BEGIN_TARGET(set) MRSIM_PRAGMA(GCC push_options) MRSIM_PRAGMA(GCC target set)
#define MRSIM_END_TARGET MRSIM_PRAGMA(GCC pop_options)
#endif

#define MRSIM_REGISTER static inline __attribute__((always_inline))
MRSIM_BEGIN_TARGET("avx2")
#include "removal/simd/registers_avx2.inl"
MRSIM_END_TARGET
MRSIM_BEGIN_TARGET("avx512f")
#include "removal/simd/registers_avx512.inl"
MRSIM_END_TARGET
#undef MRSIM_REGISTER

#endif  // MRSIM_X86
