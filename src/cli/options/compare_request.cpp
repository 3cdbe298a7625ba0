#include "cli/options/compare_request.h"

#include "cli/options/option_values.h"
#include "cli/options/typed_options.h"

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

Alignment alignment_value(const std::string& text) {
  if (text.empty() || text == "none") return Alignment::none;
  if (text == "bbox") return Alignment::bbox;
  if (text == "icp") return Alignment::icp;
  fail_usage(fmt::format("--align is none, bbox or icp, not \"{}\"", text));
}

}  // namespace

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
  out.options.align = alignment_value(typed.text("--align"));
  typed.read("--density", out.options.density, number_value);
  if (typed.has("--density") && !(out.options.density > 0))
    fail_usage(
        fmt::format("--density {} must be above 0, in samples a mm2", typed.text("--density")));
  typed.read("--deflection", out.deflection, positive_value);
  const std::string& colors = typed.text("--colors");
  if (!colors.empty() && colors != "standard" && colors != "safe")
    fail_usage(fmt::format("--colors is standard or safe, not \"{}\"", colors));
  if (colors == "safe") out.scheme = DeviationScheme::safe;
  return out;
}

}  // namespace mrsim::cli
