#include "run/files/stock_wrap.h"

#include "compare/distance/hausdorff.h"
#include "core/process/child_process.h"
#include "core/process/error.h"
#include "mesh/solid/wrap.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kWrapError = 0.02;  // of the wrap's distance: of what is measured

// The work takes what the limit of memory leaves, and its two million triangles at most take
// minutes.
constexpr int kSeconds = 3600;
constexpr double kSecondsATriangle = 6e-5;  // measured, on a core of its own
constexpr std::size_t kAllMemory = std::size_t(1) << 46;

ChildParcel wrap_parcel(const TriMesh& mesh, const StockWrap& options) {
  Wrap wrap = wrap_surface(mesh, options);
  const HausdorffBound found =
      surface_distance(wrap.solid, wrap.closed, {kWrapError * options.distance, 0}, 1);
  return {{double(wrap.openings), wrap.widest, found.lower, found.upper, found.place.x,
           found.place.y, found.place.z},
          {},
          std::move(wrap.solid)};
}

// The work itself does not tell how far it is, so its time is expected from its size.
std::function<bool(double)> progress_of(const Progress& progress, double triangles) {
  if (!progress) return {};
  return [&progress, expected = kSecondsATriangle * triangles](double seconds) {
    constexpr double kLast = 0.98;  // as far as it seems until it is done
    return progress("wrapping", std::min(kLast, seconds / expected));
  };
}

[[noreturn]] void refuse_wrap(ChildOutcome::End end) {
  using End = ChildOutcome::End;
  if (end == End::out_of_memory)
    throw Error("memory", "--stock-repair takes more memory than there is; a larger W takes less");
  throw Error("stock-wrap",
              fmt::format("--stock-repair: CGAL {} the stock's surface; try a larger W",
                          end == End::too_long ? "takes too long to wrap" : "crashed on"));
}

}  // namespace

StockRepair wrap_stock(TriMesh& mesh, const StockOptions& options) {
  const StockWrap& wrap = options.wrap;
  ChildLimits limits;
  limits.what = fmt::format("--stock-repair wrap={:g}", wrap.distance);
  limits.goes_on = progress_of(options.progress, wrapped_triangles(mesh, wrap));
  limits.seconds = kSeconds;
  limits.bytes = kAllMemory;
  ChildDelivery done = deliver_from_child(limits, [&] { return wrap_parcel(mesh, wrap); });
  if (done.end != ChildOutcome::End::done) refuse_wrap(done.end);
  mesh = std::move(done.parcel.mesh);
  const std::vector<double>& n = done.parcel.numbers;
  return {true, std::size_t(n[0]), n[1], n[2], n[3], {n[4], n[5], n[6]}};
}

std::string wrap_text(const std::string& name, const StockRepair& repair) {
  std::string text = name + " was wrapped (--stock-repair)";
  if (repair.openings > 0)
    text +=
        fmt::format(", openings closed: {}, up to {:.4g} mm wide", repair.openings, repair.widest);
  return text + fmt::format(
                    "; wrap and surface are at most {:.3g} mm apart, {:.3g} mm at ({:.3f}, {:.3f}, "
                    "{:.3f})",
                    repair.most, repair.least, repair.place.x, repair.place.y, repair.place.z);
}

}  // namespace mrsim
