// The registers of AVX2; included by registers.h, which says what the functions do.
namespace mrsim::avx2 {

using Doubles = __m256d;
using DoubleMask = __m256d;
inline constexpr std::size_t kDoubleLanes = 4;
MRSIM_REGISTER Doubles splat(double a) { return _mm256_set1_pd(a); }
MRSIM_REGISTER Doubles load(const double* p) { return _mm256_loadu_pd(p); }
MRSIM_REGISTER void store(double* out, Doubles v) { _mm256_storeu_pd(out, v); }
MRSIM_REGISTER void store_some(double* out, Doubles v, std::size_t n) {
  if (n >= kDoubleLanes) return _mm256_storeu_pd(out, v);
  alignas(32) double lanes[kDoubleLanes];
  _mm256_store_pd(lanes, v);
  for (std::size_t j = 0; j < n; ++j) out[j] = lanes[j];
}
MRSIM_REGISTER Doubles vmin(Doubles a, Doubles b) { return _mm256_min_pd(a, b); }
MRSIM_REGISTER Doubles vmax(Doubles a, Doubles b) { return _mm256_max_pd(a, b); }
MRSIM_REGISTER Doubles vabs(Doubles a) { return _mm256_max_pd(a, -a); }
MRSIM_REGISTER Doubles vsqrt(Doubles a) { return _mm256_sqrt_pd(a); }
MRSIM_REGISTER Doubles vfloor(Doubles a) { return _mm256_floor_pd(a); }
MRSIM_REGISTER DoubleMask less(Doubles a, Doubles b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
MRSIM_REGISTER DoubleMask less_equal(Doubles a, Doubles b) {
  return _mm256_cmp_pd(a, b, _CMP_LE_OQ);
}
MRSIM_REGISTER DoubleMask both(DoubleMask a, DoubleMask b) { return _mm256_and_pd(a, b); }
MRSIM_REGISTER DoubleMask either(DoubleMask a, DoubleMask b) { return _mm256_or_pd(a, b); }
MRSIM_REGISTER DoubleMask except(DoubleMask a, DoubleMask b) { return _mm256_andnot_pd(b, a); }
MRSIM_REGISTER unsigned bits(DoubleMask m) { return static_cast<unsigned>(_mm256_movemask_pd(m)); }
MRSIM_REGISTER bool any(DoubleMask m) { return bits(m) != 0; }
MRSIM_REGISTER Doubles select(DoubleMask m, Doubles a, Doubles b) {
  return _mm256_blendv_pd(b, a, m);
}
MRSIM_REGISTER Doubles gather(const double* const* rows, std::size_t i) {
  return _mm256_set_pd(rows[3][i], rows[2][i], rows[1][i], rows[0][i]);
}
// Numbers `from` to `from` + 3 of four rows into four columns.
MRSIM_REGISTER void load_four(const double* const* rows, std::size_t from, Doubles* out) {
  const Doubles a = load(rows[0] + from), b = load(rows[1] + from), c = load(rows[2] + from),
                d = load(rows[3] + from);
  const Doubles ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
  const Doubles cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
  out[0] = _mm256_permute2f128_pd(ab0, cd0, 0x20);
  out[1] = _mm256_permute2f128_pd(ab1, cd1, 0x20);
  out[2] = _mm256_permute2f128_pd(ab0, cd0, 0x31);
  out[3] = _mm256_permute2f128_pd(ab1, cd1, 0x31);
}
MRSIM_REGISTER void load_eight(const double* const* rows, Doubles* out) {
  load_four(rows, 0, out);
  load_four(rows, 4, out + 4);
}

using Floats = __m256;
using FloatMask = __m256;
inline constexpr std::size_t kFloatLanes = 8;
MRSIM_REGISTER Floats splat(float a) { return _mm256_set1_ps(a); }
MRSIM_REGISTER Floats load(const float* p) { return _mm256_loadu_ps(p); }
MRSIM_REGISTER void store(float* p, Floats v) { _mm256_storeu_ps(p, v); }
MRSIM_REGISTER Floats vmin(Floats a, Floats b) { return _mm256_min_ps(a, b); }
MRSIM_REGISTER Floats vmax(Floats a, Floats b) { return _mm256_max_ps(a, b); }
MRSIM_REGISTER Floats vabs(Floats a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a); }
MRSIM_REGISTER Floats vsqrt(Floats a) { return _mm256_sqrt_ps(a); }
MRSIM_REGISTER FloatMask less(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
MRSIM_REGISTER FloatMask less_equal(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
MRSIM_REGISTER FloatMask equal(Floats a, Floats b) { return _mm256_cmp_ps(a, b, _CMP_EQ_OQ); }
MRSIM_REGISTER Floats select(FloatMask m, Floats a, Floats b) { return _mm256_blendv_ps(b, a, m); }
MRSIM_REGISTER FloatMask splat_mask(bool b) {
  return _mm256_castsi256_ps(_mm256_set1_epi32(b ? -1 : 0));
}
MRSIM_REGISTER FloatMask first_lanes(std::size_t n) {
  const int count = n < kFloatLanes ? static_cast<int>(n) : static_cast<int>(kFloatLanes);
  return _mm256_castsi256_ps(
      _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7)));
}
MRSIM_REGISTER FloatMask both(FloatMask a, FloatMask b) { return _mm256_and_ps(a, b); }
MRSIM_REGISTER FloatMask either(FloatMask a, FloatMask b) { return _mm256_or_ps(a, b); }
MRSIM_REGISTER FloatMask except(FloatMask a, FloatMask b) { return _mm256_andnot_ps(b, a); }
MRSIM_REGISTER unsigned bits(FloatMask m) { return static_cast<unsigned>(_mm256_movemask_ps(m)); }
MRSIM_REGISTER bool any(FloatMask m) { return bits(m) != 0; }
MRSIM_REGISTER std::size_t first_set(FloatMask m) {
  return static_cast<std::size_t>(std::countr_zero(bits(m) | 256u));
}
MRSIM_REGISTER float least_lane(Floats v) {
  __m128 m = _mm_min_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}
// Which lanes of eight a mask keeps, first to last.
inline constexpr auto kKeptLanes = [] {
  std::array<std::array<std::int32_t, 8>, 256> table{};
  for (unsigned mask = 0; mask < 256; ++mask)
    for (int lane = 0, to = 0; lane < 8; ++lane)
      if (mask >> lane & 1) table[mask][static_cast<std::size_t>(to++)] = lane;
  return table;
}();
MRSIM_REGISTER std::size_t compress(float* out, Floats v, FloatMask m) {
  const unsigned mask = bits(m);
  const auto* lanes = reinterpret_cast<const __m256i_u*>(kKeptLanes[mask].data());
  store(out, _mm256_permutevar8x32_ps(v, _mm256_loadu_si256(lanes)));
  return static_cast<std::size_t>(std::popcount(mask));
}

}  // namespace mrsim::avx2
