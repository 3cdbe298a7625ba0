#include "compare/report/display_mesh.h"
#include "core/text/text_io.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include <mrsim/report_html.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

const Acceptance kBand{-0.02, 0.02};

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TriMesh part_with_owners() {
  TriMesh part = testing::sphere_mesh(40, 10.05);
  part.owners.assign(part.triangles.size(), 0);
  part.origin = {{"EVIL</script><script>alert(1)</script>.MPF"}, {"4"}, {{0, 0, 1, 0}}};
  return part;
}

TEST(ReportHtml, NothingFromTheProgramBecomesMarkup) {
  const TriMesh part = part_with_owners(), nominal = testing::sphere_mesh(40, 10);
  CompareOptions options;
  options.accept = kBand;
  options.samples = 2000;
  const std::vector<std::vector<std::string>> text{
      {"N1 G1 ; </script><script>window.evil = 1</script> <!-- <b>", "\xFF\xFE latin \x80"}};
  Comparison c = compare(part, nominal, options, text);
  c.part_name = "</script>\u202Elts.\u2067";
  ReportFacts facts;
  facts.title = "<img src=x onerror=alert(1)>";
  facts.diagnostics.push_back({Severity::warning, "w", "</script>", {"<i>", 1, 1}, 1, "", {}});
  const std::string html = report_html(part, nominal, c, facts);
  const std::string empty = report_html({}, {}, {}, {});
  for (const char* tag : {"</script", "<img", "<!--", "<b>", "<i>"})
    EXPECT_EQ(count(html, tag), count(empty, tag)) << tag;
  for (const char* mark : {"\u202E", "\u2067"}) EXPECT_EQ(count(html, mark), 0u) << "backwards";
  EXPECT_EQ(count(html, "latin "), 1u);  // lines stay text that a search finds
  EXPECT_EQ(html.find("https://"), empty.find("https://"));
  EXPECT_EQ(html, report_html(part, nominal, c, facts, 1));
}

TEST(RefineForDisplay, KeepsTheSurfaceClosedAndFindsWhatLiesInside) {
  // A long plate with a bump of the nominal under the middle of its two top triangles.
  const TriMesh part = testing::box_mesh({0, 0, 0}, {100, 60, 10});
  const TriMesh nominal = testing::joined(testing::box_mesh({0, 0, 0}, {100, 60, 10}),
                                          testing::box_mesh({40, 20, 10.5}, {60, 40, 12}));
  const DisplayMesh shown = refine_for_display(part, NominalSurface(nominal), 0.005, 200000, 0);
  testing::expect_closed_manifold(shown.mesh);
  EXPECT_NEAR(check_mesh(shown.mesh).volume, 60000, 0.1);
  EXPECT_GT(shown.mesh.triangles.size(), 1000u);
  EXPECT_EQ(shown.deviation.size(), shown.mesh.vertices.size());
}

TEST(ClusterForDisplay, StaysBelowTheLimitAndKeepsTheWorst) {
  DisplayMesh fine{testing::sphere_mesh(300, 10), {}};
  fine.deviation.assign(fine.mesh.vertices.size(), 0.0f);
  fine.deviation[1234] = -0.7f;
  const DisplayMesh coarse = cluster_for_display(fine, 10000);
  EXPECT_LE(coarse.mesh.triangles.size(), 10000u);
  EXPECT_GT(coarse.mesh.triangles.size(), 3000u);
  EXPECT_EQ(*std::min_element(coarse.deviation.begin(), coarse.deviation.end()), -0.7f);
}

TEST(DeviationColor, TellsTheThreeCasesApart) {
  for (const auto scheme : {DeviationScheme::standard, DeviationScheme::safe}) {
    const auto left = deviation_color(0.1, kBand, scheme), good = deviation_color(0, kBand, scheme),
               gouge = deviation_color(-0.1, kBand, scheme);
    EXPECT_GT(left[2], left[0]);    // blue
    EXPECT_GT(gouge[0], gouge[2]);  // red or orange
    EXPECT_NE(good, left);
    EXPECT_EQ(deviation_color(0.02, kBand, scheme), good);
  }
}

TEST(DeviationMesh, IsClosedAndColoured) {
  const TriMesh part = part_with_owners(), nominal = testing::sphere_mesh(40, 10);
  CompareOptions options;
  options.accept = kBand;
  options.samples = 2000;
  const TriMesh colored = deviation_mesh(part, nominal, compare(part, nominal, options));
  testing::expect_closed_manifold(colored);
  ASSERT_EQ(colored.colors.size(), colored.vertices.size());
  EXPECT_EQ(colored.owners.size(), colored.triangles.size());
  EXPECT_GT(colored.colors[0][2], colored.colors[0][0]);
  // The legend says with numbers what the colours are.
  ASSERT_GE(colored.legend.size(), 5u);
  EXPECT_EQ(colored.legend.front().color, deviation_color(1, kBand, DeviationScheme::standard));
  EXPECT_EQ(colored.legend.back().color, deviation_color(-1, kBand, DeviationScheme::standard));
  const bool numbers =
      std::any_of(colored.legend.begin(), colored.legend.end(), [](const ColorLabel& label) {
        return label.color == deviation_color(0, kBand, DeviationScheme::standard) &&
               label.text == "-0.02 .. +0.02 mm: in tolerance";
      });
  EXPECT_TRUE(numbers);
}

}  // namespace
}  // namespace mrsim
