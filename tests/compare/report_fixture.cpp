// Writes reports for the browser test: a plate with a gouge, a missing pass and a hostile program;
// with a number, a sphere of about that many triangles, cut by a line for each 10 mm of height.
#include "core/text/text_io.h"
#include "support/shapes.h"
#include "support/slot_parts.h"
#include <mrsim/report_html.h>

#include <algorithm>
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
  Diagnostic missing;
  missing.severity = Severity::warning;
  missing.code = "feed-missing";
  missing.text = "no feed is given: <b>check</b> it";
  missing.place = {"SLOTS.MPF", 30, 1};
  out.diagnostics.push_back(missing);
  ReportCollision deep;
  deep.part = "shank", deep.tool = "4", deep.file = "SLOTS.MPF", deep.line = 31;
  deep.text = "N31 G0 X115 Y85 <i>Z30</i>", deep.rapid = true;
  deep.depth = 2.5, deep.volume = 1234, deep.seconds = 83.4, deep.place = {115, 85, 30},
  deep.motion = 17;
  ReportCollision light = deep;
  light.part = "cutter", light.line = 45, light.depth = 0.25, light.place = {3, 3, 12};
  out.collisions = {deep, light};
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
  part.origin.files = {"BALL.MPF"};
  part.origin.tools = {"1"};
  for (int k = 0; k < 11; ++k) part.origin.origins.push_back({k, 0, 10 * (k + 1), 0});
  for (std::size_t f = 0; f < part.triangles.size(); ++f) {
    float z = 0;
    for (const std::uint32_t v : part.triangles[f]) z += part.vertices[v][2] / 3;
    part.owners.push_back(std::clamp(int((z + 55) / 10), 0, 10));
  }
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
