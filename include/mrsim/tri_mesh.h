/// mrsim: triangle meshes, and what their faces know of the program that cut them.
#pragma once

#include <mrsim/geometry.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mrsim {

/// Where the faces of one owner come from. A mesh carries the owners that its faces name, so that a
/// file can say which line of which program, with which tool, cut a face.
struct FaceOrigin {
  std::int32_t owner = -1;  ///< as in TriMesh::owners; -1 is the stock and needs no entry
  std::int32_t file = -1;   ///< index into OwnerTable::files, -1 = unknown
  std::int32_t line = 0;    ///< 1-based, 0 = unknown
  std::int32_t tool = -1;   ///< index into OwnerTable::tools, -1 = unknown
  friend bool operator==(const FaceOrigin&, const FaceOrigin&) = default;
};
struct OwnerTable {
  std::vector<std::string> files;   ///< programs, main program first
  std::vector<std::string> tools;   ///< ids of the tools, "4"
  std::vector<FaceOrigin> origins;  ///< ascending by owner, each owner once
  friend bool operator==(const OwnerTable&, const OwnerTable&) = default;
};

/// A colour (sRGB) with what a legend says of it.
struct ColorLabel {
  std::array<std::uint8_t, 3> color{};
  std::string text;
  friend bool operator==(const ColorLabel&, const ColorLabel&) = default;
};

/// An indexed triangle mesh. Vertices are float because files are: what was checked is what is
/// written.
struct TriMesh {
  std::vector<std::array<float, 3>> vertices;  ///< #V by 3, mm
  std::vector<std::array<std::uint32_t, 3>>
      triangles;  ///< #F by 3, counter-clockwise seen from outside
  std::vector<std::int32_t>
      owners;  ///< #F or empty: index of the motion that cut the face, -1 = stock
  std::vector<std::array<std::uint8_t, 3>>
      colors;  ///< #V or empty: sRGB of each vertex, for pictures and files (deviation)
  std::vector<ColorLabel> legend;  ///< what `colors` stand for, from high to low; may be empty
  OwnerTable origin;               ///< what `owners` stand for; may be empty
};

/// What a mesh is, and whether it keeps mrsim's promises.
struct MeshSummary {
  bool closed = false;    ///< every edge has two triangles
  bool oriented = false;  ///< ... that run through it in opposite directions, and the volume is
                          ///< positive
  bool manifold = false;  ///< ... and every vertex has one fan
  bool inverted = false;  ///< closed, but inside out: the volume is negative
  std::size_t degenerate = 0;  ///< triangles without area
  double volume = 0;           ///< mm^3, signed
  double area = 0;             ///< mm^2
  long euler = 0;              ///< V - E + F
  std::size_t components = 0;  ///< pieces of surface (a cavity is one of its own)
  Box3 bounds;                 ///< mm
  std::string first_fault;     ///< empty, or a sentence with the place
};

}  // namespace mrsim
