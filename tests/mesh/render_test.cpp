#include "mesh/draw/render.h"

#include "mesh/draw/picture.h"
#include "mesh/draw/picture_text.h"
#include "mesh/draw/view.h"
#include "mesh/solid/creases.h"
#include "mesh/solid/half_edges.h"
#include "mesh/solid/weld.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mrsim {
namespace {

using namespace mrsim::testing;

RenderOptions small() {
  RenderOptions o;
  o.width = 320;
  o.height = 240;
  return o;
}

std::string png(const TriMesh& m, const RenderOptions& o) {
  return bytes_of([&](const ByteSink& out) { render_mesh(m, o, out); });
}

TEST(Render, WritesAPngOfTheSizeAsked) {
  const std::string bytes = png(box_mesh({0, -60, 0}, {100, 0, 10}), small());
  ASSERT_GT(bytes.size(), 1000u);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\x01\x40\0\0\0\xf0", 8));
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Render, IsTheSameForAnyNumberOfThreads) {
  TriMesh m = tube_mesh(90, 10, 5, 0, 7);
  m.owners.assign(m.triangles.size(), 3);
  RenderOptions o = small();
  o.color = ColorBy::line;
  o.threads = 1;
  const std::string one = png(m, o);
  for (const int threads : {2, 3, 8}) {
    o.threads = threads;
    EXPECT_EQ(png(m, o), one);
  }
}

// A ray meets all bodies in one place: 20 000 of them took minutes.
TEST(Render, BodiesInOnePlaceAreDrawnOnce) {
  const TriMesh one = box_mesh({0, 0, 0}, {10, 10, 4});
  TriMesh many = one;
  many.triangles.clear(), many.vertices.clear();
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    many.vertices.insert(many.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const auto& t : one.triangles)
      many.triangles.push_back({t[0] + 8 * i, t[1] + 8 * i, t[2] + 8 * i});
  }
  RenderOptions o = small();
  o.edge_angle = 0;
  EXPECT_EQ(png(many, o), png(one, o));
}

TEST(Render, EveryOptionShows) {
  TriMesh m = box_mesh({0, 0, 0}, {10, 10, 4});
  m.owners = {-1, -1, 5, 5, 9, 9, -1, -1, -1, -1, -1, -1};
  const std::string plain = png(m, small());
  std::vector<std::string> all = {plain};
  for (int i = 0; i < 7; ++i) {
    RenderOptions o = small();
    if (i == 0) o.edge_angle = 0;
    if (i == 1) o.ambient_occlusion = false;
    if (i == 2) o.ground = false;
    if (i == 3) o.caption = "PRIMER_2F, 0.25 mm";
    if (i == 4) o.color = ColorBy::line;
    if (i == 5) o.azimuth = -40;
    if (i == 6) o.elevation = -20;
    for (const std::string& other : all) EXPECT_NE(png(m, o), other) << i;
    all.push_back(png(m, o));
  }
}

TEST(Render, DrawsTheLegendOfVertexColours) {
  TriMesh m = box_mesh({0, 0, 0}, {10, 10, 4});
  m.colors.assign(m.vertices.size(), {90, 160, 90});
  const std::string without = png(m, small());
  m.legend = {{{90, 160, 90}, "in tolerance"}};
  const std::string with = png(m, small());
  EXPECT_NE(with, without);
  m.legend[0].text = "+0.05 mm";
  EXPECT_NE(png(m, small()), with);
}

TEST(Render, RefusesWhatCannotBeDrawn) {
  const TriMesh box = box_mesh({0, 0, 0}, {10, 10, 4});
  RenderOptions o = small();
  o.width = 8;
  EXPECT_EQ(error_code([&] { png(box, o); }), "render-options");
  o = small();
  o.elevation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_code([&] { png(box, o); }), "render-options");
  EXPECT_EQ(error_code([&] { png({}, small()); }), "mesh-empty");
  TriMesh bad = box;
  bad.vertices[3][0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(error_code([&] { png(bad, small()); }), "mesh-invalid");
}

TEST(Render, DrawsOddMeshes) {
  TriMesh flat;  // open, seen from behind, without thickness
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 2, 1}};
  EXPECT_GT(png(flat, small()).size(), 1000u);
  TriMesh point = flat;
  point.vertices = {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
  EXPECT_GT(png(point, small()).size(), 1000u);
  EXPECT_GT(png(box_mesh({1e6, 1e6, 0}, {1e6 + 10, 1e6 + 10, 10}), small()).size(), 1000u);
  EXPECT_GT(
      png(weld(joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1}))), small())
          .size(),
      1000u);
}

TEST(Render, TurnedPartsLie) {
  const TriMesh ball = testing::sphere_mesh(16, 10);
  TriMesh bar = ball, beside = ball;
  for (auto& v : bar.vertices) v[2] *= 3;
  for (auto& v : beside.vertices) v[0] += 30;
  EXPECT_TRUE(is_turned(bar));
  EXPECT_FALSE(is_turned(beside));
  EXPECT_FALSE(is_turned(testing::box_mesh({-5, -5, -5}, {5, 5, 5})));
  const TriMesh laid = laid_down(bar);
  EXPECT_EQ(laid.vertices[7][0], bar.vertices[7][2]);
  EXPECT_EQ(laid.vertices[7][2], bar.vertices[7][0]);
  EXPECT_NEAR(check_mesh(laid).volume, check_mesh(bar).volume, 1e-6);  // not its mirror image
}

TEST(FitView, ShowsTheWholePartAndFillsTheFrame) {
  const TriMesh m = box_mesh({0, -60, 0}, {100, 0, 10});
  for (const double elevation : {-90.0, 0.0, 35.0, 90.0}) {
    RenderOptions o;
    o.elevation = elevation;
    const View view = fit_view(m, o, {50, 60, 1550, 1100});
    Vec2 lo{1e9, 1e9}, hi{-1e9, -1e9};
    for (const auto& v : m.vertices) {
      const Vec2 p = view.project(to_vec(v));
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
      const Vec3 ray = view.direction(p);
      EXPECT_NEAR(length(cross(ray, normalized(to_vec(v) - view.eye))), 0, 1e-9);
    }
    EXPECT_GE(lo.x, 50 - 1e-6);
    EXPECT_GE(lo.y, 60 - 1e-6);
    EXPECT_LE(hi.x, 1550 + 1e-6);
    EXPECT_LE(hi.y, 1100 + 1e-6);
    const bool fills = hi.x - lo.x > 1499 || hi.y - lo.y > 1039;
    EXPECT_TRUE(fills) << elevation;
  }
}

TEST(SurfaceShape, BoxHasTwelveEdgesAndFlatFaces) {
  const TriMesh m = box_mesh({0, 0, 0}, {10, 10, 4});
  const SurfaceShape s = find_surface_shape(m, 25);
  EXPECT_EQ(s.creases.size(), 12u);
  EXPECT_EQ(s.smooth_edges.size(), 6u);
  for (std::uint32_t h = 0; h < s.normals.size(); ++h)
    EXPECT_NEAR(dot(to_vec(s.normals[h]), s.face_normals[h / 3]), 1, 1e-6);
}

TEST(SurfaceShape, SliversAreNoEdges) {
  // The upper face of a box in four triangles, one of them a sliver that stands on end.
  TriMesh m = box_mesh({0, 0, 0}, {10, 10, 4});
  const std::size_t plain = find_surface_shape(m, 25).creases.size();
  m.vertices.push_back({5, 5, 4.0005f});
  m.triangles[2] = {4, 5, 8};
  m.triangles.push_back({8, 5, 7});
  m.triangles.push_back({4, 8, 7});
  ASSERT_TRUE(check_mesh(m).manifold);
  m.vertices[8] = {5.0001f, 5.0001f, 4.0005f};
  EXPECT_EQ(find_surface_shape(m, 25).creases.size(), plain);
}

TEST(SurfaceShape, RoundWallsAreShadedRound) {
  const TriMesh m = cylinder_mesh(90, 10, 0, 20);
  const SurfaceShape s = find_surface_shape(m, 25);
  EXPECT_EQ(s.creases.size(), 180u);
  for (std::uint32_t h = 0; h < s.normals.size(); ++h) {
    const Vec3 n = to_vec(s.normals[h]), p = to_vec(m.vertices[origin_of(m, h)]);
    if (std::fabs(s.face_normals[h / 3].z) < 0.5) {
      EXPECT_NEAR(n.x * p.x + n.y * p.y, 10, 0.01);
    } else {
      EXPECT_NEAR(std::fabs(n.z), 1, 1e-6);
    }
  }
}

TEST(Picture, StrokesAreAntiAliased) {
  Picture p(20, 20);
  p.stroke({2, 10}, {18, 10}, 2, {1, 1, 1});
  EXPECT_FLOAT_EQ(p.at(10, 9).r, 1);
  EXPECT_FLOAT_EQ(p.at(10, 10).r, 1);
  EXPECT_FLOAT_EQ(p.at(10, 8).r, 0);
  EXPECT_FLOAT_EQ(p.at(10, 13).r, 0);
  p.stroke({-50, -50}, {70, 70}, 3, {1, 1, 1});  // beyond the picture
  EXPECT_GT(p.at(19, 19).r, 0.9f);
}

TEST(Picture, TextHasTheWidthItSays) {
  Picture p(400, 40);
  const double width = draw_text(p, {5, 30}, 18, "PRIMER_2F.MPF:12 \xff", {1, 1, 1});
  EXPECT_NEAR(width, text_width("PRIMER_2F.MPF:12 \xff", 18), 1e-9);
  double ink = 0, beyond = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 400; ++x) (x < 5 + width + 2 ? ink : beyond) += p.at(x, y).r;
  EXPECT_GT(ink, 200);
  EXPECT_EQ(beyond, 0);
}

}  // namespace
}  // namespace mrsim
