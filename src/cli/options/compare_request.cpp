#include "cli/options/compare_request.h"

#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"

#include <fmt/format.h>

namespace mrsim::cli {

CompareRequest named_request(const TypedOptions& typed) {
  CompareRequest out;
  out.nominal = typed.text("--nominal");
  out.report = typed.text("--report");
  out.json = typed.text("--json");
  out.junit = typed.text("--junit");
  out.deviation = typed.text("--deviation");
  return out;
}

CompareRequest compare_request(const TypedOptions& typed) {
  CompareRequest out = named_request(typed);
  if (typed.has("--accept")) out.options.accept = parse_acceptance(typed.text("--accept"));
  typed.read("--align", out.options.align, align_value);
  typed.read("--density", out.options.density, number_value);
  if (typed.has("--density") && !(out.options.density > 0))
    fail_usage(
        fmt::format("--density {} must be above 0, in samples a mm2", typed.text("--density")));
  typed.read("--deflection", out.deflection, positive_value);
  typed.read("--colors", out.scheme, scheme_value);
  return out;
}

}  // namespace mrsim::cli
