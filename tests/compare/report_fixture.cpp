// Writes reports for the browser test: a plate with a gouge, a missing pass and a hostile program;
// with a number, a sphere of about that many triangles.
#include "core/text_io.h"
#include "support/shapes.h"
#include "support/slot_parts.h"
#include <mrsim/compare.h>

#include <cmath>
#include <cstdlib>

namespace mrsim {
namespace {

ReportFacts facts() {
  ReportFacts out;
  out.title = "SLOTS.MPF";
  out.facts = {{"Stock", "box 120 x 90 x 10 mm, exact"}, {"Voxel", "0.25 mm, stock / 400"}};
  out.times = {{"interpret", 0.004}, {"carve", 0.21}, {"mesh", 0.33}};
  Tool tool;
  tool.id = "4";
  tool.diameter = 6;
  tool.origin = "tools.toml";
  out.tools = {tool};
  out.diagnostics = {{Severity::warning,
                      "feed-missing",
                      "no feed is given: <b>check</b> it",
                      {"SLOTS.MPF", 30, 1},
                      3,
                      "",
                      {}}};
  return out;
}

std::string slots_report() {
  std::array<float, 6> depth = testing::kRight;
  depth[1] = 4.1f;
  depth[4] = 0;
  auto text = testing::texts();
  for (int k = 0; k < 6; ++k)
    text[0][std::size_t(10 * k + 9)] =
        "N" + std::to_string(10 * k + 10) + " G1 X110 F300 ; slot " + std::to_string(k + 1);
  text[0][11] = "; </script><script>window.evil = true</script>";
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.05};
  const TriMesh part = testing::build(testing::slots(depth)),
                nominal = testing::build(testing::slots(testing::kRight));
  Comparison c = compare(part, nominal, options, text);
  c.part_name = "slots.ply";
  c.nominal_name = "slots.step";
  return report_html(part, nominal, c, facts());
}

std::string sphere_report(double triangles) {
  const int n = int(std::sqrt(triangles));
  TriMesh part = testing::sphere_mesh(n, 50.01);
  const TriMesh nominal = testing::sphere_mesh(200, 50);
  CompareOptions options;
  options.accept = Acceptance{-0.02, 0.02};
  return report_html(part, nominal, compare(part, nominal, options));
}

}  // namespace
}  // namespace mrsim

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string html =
      argc > 2 ? mrsim::sphere_report(std::atof(argv[2])) : mrsim::slots_report();
  mrsim::write_file_atomically(argv[1],
                               [&](const mrsim::ByteSink& out) { out(html.data(), html.size()); });
}
