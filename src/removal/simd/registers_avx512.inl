// The registers of AVX-512 (its foundation alone); included by registers.h, which says what the
// functions do.
namespace mrsim::avx512 {

using Doubles = __m512d;
using DoubleMask = __mmask8;
inline constexpr std::size_t kDoubleLanes = 8;
MRSIM_REGISTER Doubles splat(double a) { return _mm512_set1_pd(a); }
MRSIM_REGISTER Doubles load(const double* p) { return _mm512_loadu_pd(p); }
MRSIM_REGISTER void store(double* out, Doubles v) { _mm512_storeu_pd(out, v); }
MRSIM_REGISTER void store_some(double* out, Doubles v, std::size_t n) {
  _mm512_mask_storeu_pd(out, static_cast<__mmask8>((1u << n) - 1), v);
}
MRSIM_REGISTER Doubles vmin(Doubles a, Doubles b) { return _mm512_min_pd(a, b); }
MRSIM_REGISTER Doubles vmax(Doubles a, Doubles b) { return _mm512_max_pd(a, b); }
MRSIM_REGISTER Doubles vabs(Doubles a) { return _mm512_max_pd(a, -a); }
MRSIM_REGISTER Doubles vsqrt(Doubles a) { return _mm512_sqrt_pd(a); }
MRSIM_REGISTER Doubles vfloor(Doubles a) { return _mm512_floor_pd(a); }
MRSIM_REGISTER DoubleMask less(Doubles a, Doubles b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
MRSIM_REGISTER DoubleMask less_equal(Doubles a, Doubles b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
MRSIM_REGISTER DoubleMask both(DoubleMask a, DoubleMask b) {
  return static_cast<DoubleMask>(a & b);
}
MRSIM_REGISTER DoubleMask either(DoubleMask a, DoubleMask b) {
  return static_cast<DoubleMask>(a | b);
}
MRSIM_REGISTER DoubleMask except(DoubleMask a, DoubleMask b) {
  return static_cast<DoubleMask>(a & ~b);
}
MRSIM_REGISTER unsigned bits(DoubleMask m) { return m; }
MRSIM_REGISTER bool any(DoubleMask m) { return m != 0; }
MRSIM_REGISTER Doubles select(DoubleMask m, Doubles a, Doubles b) {
  return _mm512_mask_blend_pd(m, b, a);
}
MRSIM_REGISTER Doubles gather(const double* const* rows, std::size_t i) {
  return _mm512_set_pd(rows[7][i], rows[6][i], rows[5][i], rows[4][i], rows[3][i], rows[2][i],
                       rows[1][i], rows[0][i]);
}
// Eight rows into eight columns: pairs, then pairs of pairs, then halves.
MRSIM_REGISTER void load_eight(const double* const* rows, Doubles* out) {
  Doubles row[8], pair[8], quad[8];
  for (int j = 0; j < 8; ++j) row[j] = load(rows[j]);
  for (int i = 0; i < 4; ++i) {
    pair[2 * i] = _mm512_unpacklo_pd(row[2 * i], row[2 * i + 1]);
    pair[2 * i + 1] = _mm512_unpackhi_pd(row[2 * i], row[2 * i + 1]);
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      quad[4 * i + j] = _mm512_shuffle_f64x2(pair[4 * i + j], pair[4 * i + j + 2], 0x88);
      quad[4 * i + j + 2] = _mm512_shuffle_f64x2(pair[4 * i + j], pair[4 * i + j + 2], 0xdd);
    }
  }
  for (int j = 0; j < 2; ++j) {
    out[j] = _mm512_shuffle_f64x2(quad[j], quad[4 + j], 0x88);
    out[j + 4] = _mm512_shuffle_f64x2(quad[j], quad[4 + j], 0xdd);
    out[j + 2] = _mm512_shuffle_f64x2(quad[j + 2], quad[4 + j + 2], 0x88);
    out[j + 6] = _mm512_shuffle_f64x2(quad[j + 2], quad[4 + j + 2], 0xdd);
  }
}

using Floats = __m512;
using FloatMask = __mmask16;
inline constexpr std::size_t kFloatLanes = 16;
MRSIM_REGISTER Floats splat(float a) { return _mm512_set1_ps(a); }
MRSIM_REGISTER Floats load(const float* p) { return _mm512_loadu_ps(p); }
MRSIM_REGISTER void store(float* p, Floats v) { _mm512_storeu_ps(p, v); }
MRSIM_REGISTER Floats vmin(Floats a, Floats b) { return _mm512_min_ps(a, b); }
MRSIM_REGISTER Floats vmax(Floats a, Floats b) { return _mm512_max_ps(a, b); }
MRSIM_REGISTER Floats vabs(Floats a) { return _mm512_abs_ps(a); }
MRSIM_REGISTER Floats vsqrt(Floats a) { return _mm512_sqrt_ps(a); }
MRSIM_REGISTER FloatMask less(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
MRSIM_REGISTER FloatMask less_equal(Floats a, Floats b) {
  return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}
MRSIM_REGISTER FloatMask equal(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
MRSIM_REGISTER Floats select(FloatMask m, Floats a, Floats b) {
  return _mm512_mask_blend_ps(m, b, a);
}
MRSIM_REGISTER FloatMask splat_mask(bool b) { return static_cast<FloatMask>(b ? 0xffff : 0); }
MRSIM_REGISTER FloatMask first_lanes(std::size_t n) {
  return static_cast<FloatMask>(n < kFloatLanes ? (1u << n) - 1 : 0xffffu);
}
MRSIM_REGISTER FloatMask both(FloatMask a, FloatMask b) { return static_cast<FloatMask>(a & b); }
MRSIM_REGISTER FloatMask either(FloatMask a, FloatMask b) { return static_cast<FloatMask>(a | b); }
MRSIM_REGISTER FloatMask except(FloatMask a, FloatMask b) { return static_cast<FloatMask>(a & ~b); }
MRSIM_REGISTER bool any(FloatMask m) { return m != 0; }
MRSIM_REGISTER std::size_t first_set(FloatMask m) {
  return static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(m) | 0x10000u));
}
MRSIM_REGISTER float least_lane(Floats v) { return _mm512_reduce_min_ps(v); }
MRSIM_REGISTER std::size_t compress(float* out, Floats v, FloatMask m) {
  store(out, _mm512_maskz_compress_ps(m, v));
  return static_cast<std::size_t>(std::popcount(static_cast<unsigned>(m)));
}

}  // namespace mrsim::avx512
