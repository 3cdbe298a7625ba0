#include "removal/prune/measured_list.h"

#include <algorithm>
#include <cmath>

namespace mrsim {
namespace {

// Shorter lists of costly sweeps are not worth the nearest points of their skeletons.
constexpr std::size_t kFewOthers = 6;
constexpr double kRoom = 1e-3;       // mm: far above the slack of rounding
constexpr double kRoomShare = 2e-5;  // of lengths: far above RegionArgs::delta

constexpr std::size_t kMeasuredTogether = 512;  // a multiple of any register
constexpr std::size_t kLongSlice = 512, kProbes = 16;

using Kernel = decltype(CandidateKernels::strip);
Kernel kernel_of(const CandidateKernels& kernels, SweepClass::Form form) {
  return form == SweepClass::Form::strip  ? kernels.strip
         : form == SweepClass::Form::line ? kernels.line
                                          : kernels.arc;
}

}  // namespace

void MeasuredList::Rows::resize(std::size_t slots) {
  stride_ = slots + CandidateList::kPad;
  if (data_.size() < 7 * stride_) data_.resize(7 * stride_);
}

MeasuredList::Scratch& MeasuredList::scratch() {
  static thread_local Scratch s;
  return s;
}

MeasuredList::MeasuredList(const SweepTable& table, const PruneRegion& region, double reach,
                           double band, const CandidateList& in, bool undercuts)
    : columns_(table.columns()),
      in_(in),
      kernels_(candidate_kernels()),
      region_(region),
      deep_(-reach),
      at_(region_args(region, in.origin)),
      heights_(band + distance_slack(table)),
      undercuts_(undercuts) {
  const auto& slices = in.slices();
  for (std::size_t i = 0; band > 0 && i < slices.size(); ++i)
    by_heights_ = by_heights_ || type(i).form == SweepClass::Form::segment;
  measure(table);
}

bool MeasuredList::is_swept_by_nearest() const {
  const double band = -deep_ - region_.radius;
  if (!(double(least_) + at_.delta < -band)) return false;
  const auto& slices = in_.slices();
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (!is_strip(type(i)) || scratch_.least[i].distance > least_) continue;
    const std::size_t k = kernels_.find(rows(i).distance, slices[i].count, least_);
    if (k == slices[i].count) continue;
    const CandidateRows r = rows(i);
    return farthest(region_, r.x[k], r.y[k], r.z[k]) - type(i).tool.round + 2 * at_.delta < -band;
  }
  return false;
}

void MeasuredList::measure(const SweepTable& table) {
  scratch_.least.clear();
  if (in_.slices().empty()) return;
  scratch_.rows.resize(end_of(in_.slices().back()) + CandidateList::kPad);
  double extent = near_extent(at_, in_);
  for (std::size_t i = 0; i < in_.slices().size(); ++i)
    if (is_other(i))
      extent = std::max(extent, measure_others(table, in_.slices()[i]));
    else
      scratch_.least.push_back({});
  if (has_packs()) {
    scratch_.least.back() = measure_packs(in_.slices().back());
    extent = std::max(extent, std::fabs(scratch_.turned.distance));
  }
  set_delta(at_, extent, region_.radius);
  for (std::size_t i = 0; i < in_.slices().size(); ++i)
    if (!is_bounded(i)) spread_ = std::max(spread_, type(i).spread);
  for (std::size_t i = 0; i < in_.slices().size() && !is_swept(); ++i) probe_slice(i);
  for (std::size_t i = 0; i < in_.slices().size() && !is_swept(); ++i)
    if (!is_bounded(i)) measure_slice(i);
  if (by_heights_ && !is_swept()) measure_heights();
}

// Sweeps without columns: in double, then rounded. Returns the largest value.
double MeasuredList::measure_others(const SweepTable& table, const CandidateList::Slice& slice) {
  Scratch& s = scratch_;
  s.ids.resize(slice.count), s.distance.resize(slice.count);
  for (std::size_t k = 0; k < slice.count; ++k) s.ids[k] = in_.number(slice, k);
  const Vec3& p = region_.center;
  const double radius = region_.radius;
  const double room = kRoom + kRoomShare * (near_extent(at_, in_) + radius - deep_);
  table.near_distances(s.ids, p, 2 * radius + room, s.distance.data());
  const CandidateRows out = s.rows.at(slice.first);
  LeastDistance& least =
      s.least.emplace_back(LeastDistance{kFloatInfinity, kFloatInfinity, kFloatInfinity});
  const std::size_t padded =
      (slice.count + CandidateList::kPad - 1) / CandidateList::kPad * CandidateList::kPad;
  std::fill(out.distance + slice.count, out.distance + padded, kFloatInfinity);
  std::fill(out.squared + slice.count, out.squared + padded, kFloatInfinity);
  std::fill(out.z + slice.count, out.z + padded, kFloatInfinity);
  // Where a sweep is dropped by its distance, its nearest point is not needed.
  const double nearest = *std::min_element(s.distance.begin(), s.distance.end());
  const double limit =
      slice.count < kFewOthers || nearest > -deep_ ? deep_ : nearest + 2 * region_.radius + kRoom;
  double extent = 0;
  for (std::size_t k = 0; k < slice.count; ++k) {
    const SweepColumns::Foot f =
        s.distance[k] > limit ? SweepColumns::Foot{} : columns_.foot(columns_.refs[s.ids[k]], p);
    out.distance[k] = static_cast<float>(s.distance[k]);
    out.squared[k] = static_cast<float>(f.squared);
    out.x[k] = static_cast<float>(f.offset.x), out.y[k] = static_cast<float>(f.offset.y);
    out.z[k] = static_cast<float>(f.offset.z);
    out.rest[k] =
        f.convex ? static_cast<float>(region_.radius * region_.radius * 1.00001) : kFloatInfinity;
    out.height_number[k] =
        columns_.height_numbers.empty()
            ? 0
            : static_cast<float>(height_number(columns_.height_numbers[s.ids[k]]));
    least.distance = std::min(least.distance, out.distance[k]);
    least.squared = std::min(least.squared, out.squared[k]);
    least.z = std::min(least.z, out.z[k]);
    if (std::isfinite(s.distance[k]))
      extent = std::max({extent, std::fabs(s.distance[k]), length(f.offset)});
  }
  return extent;
}

// Measures all packs of the slice. Returns the nearest one and its distance.
LeastDistance MeasuredList::measure_packs(const CandidateList::Slice& slice) {
  scratch_.packs.clear(), scratch_.turned = {};
  const Vec3& c = region_.center;
  const double rho = std::sqrt(c.x * c.x + c.y * c.y);
  for (std::size_t k = 0; k < slice.count; ++k) {
    scratch_.packs.push_back(in_.number(slice, k) -
                             static_cast<std::uint32_t>(columns_.refs.size()));
    columns_.turn_tree.nearest(scratch_.packs.back(), rho, c.z, scratch_.turned);
  }
  return {static_cast<float>(scratch_.turned.distance), kFloatInfinity, kFloatInfinity};
}

// Asks a few sweeps of a long slice first: in most regions that lie deep in a sweep one of them
// shows it, as no point of such a region is farther from a sweep than the tool is wide.
void MeasuredList::probe_slice(std::size_t i) {
  const CandidateList::Slice& slice = in_.slices()[i];
  if (slice.count < kLongSlice || type(i).form > SweepClass::Form::arc) return;
  at_.tool = type(i).tool;
  if (at_.tool.core + at_.tool.round < -deep_) return;
  const std::size_t stretch = slice.count / kProbes / CandidateList::kPad * CandidateList::kPad;
  for (std::size_t k = 0; k < slice.count && !is_swept(); k += stretch) {
    const std::size_t some = std::min(slice.count - k, CandidateList::kPad);
    const LeastDistance found = kernel_of(kernels_, type(i).form)(
        in_.columns(slice.first + k), some, at_, scratch_.rows.at(slice.first + k));
    least_ = std::min(least_, found.distance + spread_of(type(i)));
  }
}

void MeasuredList::measure_slice(std::size_t i) {
  const CandidateList::Slice& slice = in_.slices()[i];
  LeastDistance& least = scratch_.least[i];
  at_.tool = type(i).tool;
  set_margin(at_, static_cast<float>(kWiderSpread * (type(i).spread + spread_)));
  if (type(i).form == SweepClass::Form::turn) {
    least_ = std::min(least_, least.distance);
    return;
  }
  if (is_other(i)) {
    const CandidateRows r = rows(i);
    for (std::size_t k = 0; k < slice.count; ++k)
      r.rest[k] += at_.fixed + at_.per_root * std::sqrt(r.squared[k]) + kTieMargin * r.squared[k];
    least_ = std::min(least_, least.distance);
    return;
  }
  const Kernel kernel = kernel_of(kernels_, type(i).form);
  least = {kFloatInfinity, kFloatInfinity, kFloatInfinity};
  for (std::size_t k = 0; k < slice.count && !is_swept(); k += kMeasuredTogether) {
    const LeastDistance some =
        kernel(in_.columns(slice.first + k), std::min(slice.count - k, kMeasuredTogether), at_,
               scratch_.rows.at(slice.first + k));
    least.distance = std::min(least.distance, some.distance);
    least.squared = std::min(least.squared, some.squared);
    least.z = std::min(least.z, some.z);
    least_ = std::min(least_, some.distance + spread_of(type(i)));
  }
}

// Bounds the heights of the list's sweeps over the square. A sweep that lies above the lowest upper
// bound, or above the region, decides nothing in it.
void MeasuredList::measure_heights() {
  heights_.begin(at_, lateral(at_));
  scratch_.lower.resize(
      std::max(scratch_.lower.size(), end_of(in_.slices().back()) + CandidateList::kPad));
  for (std::size_t i = 0; i < in_.slices().size() && !heights_.is_swept(); ++i) {
    const CandidateList::Slice& slice = in_.slices()[i];
    float* lower = scratch_.lower.data() + slice.first;
    if (is_bounded(i))
      heights_.add(kernels_.segment_heights(in_.columns(slice.first), slice.count,
                                            heights_.args(type(i)), lower));
    else if (is_measured_horizontal(i))
      heights_.add(
          kernels_.horizontal_heights(rows(i), slice.count, heights_.args(type(i)), lower));
  }
  for (std::size_t i = 0; i < in_.slices().size() && !heights_.is_swept(); ++i)
    if (is_measured_horizontal(i)) drop_high(i);
}

void MeasuredList::drop_high(std::size_t i) {
  const CandidateRows r = rows(i);
  const float* lower = scratch_.lower.data() + in_.slices()[i].first;
  for (std::size_t k = 0; k < in_.slices()[i].count; ++k)
    if (lower[k] > heights_.limit()) r.distance[k] = kFloatInfinity;
}

}  // namespace mrsim
