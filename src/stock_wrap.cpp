#include "stock_wrap.h"

#include "compare/hausdorff.h"
#include "mesh/solid/wrap.h"

#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr double kError = 0.02;  // of the wrap's distance: of what is measured

}  // namespace

StockRepair wrap_stock(TriMesh& mesh, const StockWrap& options) {
  Wrap wrap = wrap_surface(mesh, options);
  const HausdorffBound found =
      surface_distance(wrap.solid, wrap.closed, kError * options.distance, 0);
  mesh = std::move(wrap.solid);
  return {true, wrap.openings, wrap.widest, found.lower, found.upper, found.place};
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
