#include "mesh/solid/pieces.h"

#include "mesh/solid/nesting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace mrsim {
namespace {

Piece piece_of(const SurfaceComponent& surface, std::uint32_t index) {
  Piece piece;
  piece.bounds = surface.bounds;
  piece.triangles = surface.triangles;
  piece.components = {index};
  return piece;
}

// The solid that each cavity lies in; a cavity of a faulty mesh may have none.
std::map<std::uint32_t, std::uint32_t> solids_of_cavities(const MeshAudit& audit,
                                                          const MeshSource& mesh) {
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  std::vector<std::uint32_t> cavities;
  for (std::uint32_t c = 0; c < surfaces.size(); ++c)
    if (!(surfaces[c].volume() > 0)) cavities.push_back(c);
  return find_surfaces_around(audit, mesh, cavities, [&](std::uint32_t outer, std::uint32_t) {
    return surfaces[outer].volume() > 0;
  });
}

void set_volume(Piece& piece, const MeshAudit& audit) {
  OrderlessSum volume6, moment24[3];
  for (const std::uint32_t c : piece.components) {
    const SurfaceComponent& surface = audit.components()[c];
    volume6.add(surface.volume6);
    for (int a = 0; a < 3; ++a) moment24[a].add(surface.moment24[a]);
  }
  piece.volume = volume6.value() / 6;
  for (int a = 0; a < 3; ++a)
    component(piece.center, a) =
        component(audit.center(), a) + moment24[a].value() / 24 / piece.volume;
}

}  // namespace

std::vector<Piece> find_pieces(const MeshAudit& audit, const MeshSource& mesh) {
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  std::vector<Piece> pieces;
  std::map<std::uint32_t, std::size_t> piece_of_solid;
  for (std::uint32_t c = 0; c < surfaces.size(); ++c) {
    if (!(surfaces[c].volume() > 0)) continue;
    piece_of_solid.emplace(c, pieces.size());
    pieces.push_back(piece_of(surfaces[c], c));
  }
  for (const auto& [cavity, solid] : solids_of_cavities(audit, mesh)) {
    Piece& piece = pieces[piece_of_solid.at(solid)];
    piece.triangles += surfaces[cavity].triangles;
    piece.components.push_back(cavity);
  }
  for (Piece& piece : pieces) set_volume(piece, audit);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.volume > b.volume; });
  return pieces;
}

std::vector<Piece> find_pieces(const TriMesh& mesh) {
  MeshAudit audit;
  audit.take(whole_block(mesh));
  return find_pieces(audit, MemoryMesh(mesh));
}

namespace {

double size_of(const SurfaceComponent& surface) { return std::fabs(surface.volume()); }

// How many surfaces lie around each one. Surfaces do not cross, so that each one around lies around
// the smallest one around, too.
std::vector<std::size_t> depths_of_surfaces(const MeshAudit& audit, const MeshSource& mesh) {
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  std::vector<std::uint32_t> all(surfaces.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto around =
      find_surfaces_around(audit, mesh, all, [&](std::uint32_t outer, std::uint32_t inner) {
        return size_of(surfaces[outer]) > size_of(surfaces[inner]);
      });
  std::stable_sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
    return size_of(surfaces[a]) > size_of(surfaces[b]);
  });
  std::vector<std::size_t> out(surfaces.size(), 0);
  for (const std::uint32_t c : all)
    if (const auto at = around.find(c); at != around.end()) out[c] = out[at->second] + 1;
  return out;
}

// Makes the blocks of a piece from those of the mesh. Vertices keep their order and are numbered
// anew; numbers of former blocks are known as long as their vertices are unfinished.
class PieceBlocks {
 public:
  explicit PieceBlocks(const std::vector<bool>& wanted) : wanted_(wanted) {}

  // `components`: those of the block's triangles. The result is valid until the next call.
  MeshBlock take(const MeshBlock& block, const std::vector<std::uint32_t>& components) {
    keep(block, components);
    rename_unfinished(block);
    const MeshBlock out{kept_.vertices, borrowed_,    first_new_, kept_.triangles,
                        kept_.owners,   kept_.colors, unfinished_};
    first_new_ += static_cast<std::uint32_t>(out.fresh().size());
    return out;
  }

 private:
  static constexpr std::uint32_t kDropped = ~0u;

  void keep(const MeshBlock& block, const std::vector<std::uint32_t>& components) {
    kept_ = {};
    borrowed_.clear();
    place_.assign(block.points.size(), kDropped);
    for (std::size_t f = 0; f < components.size(); ++f)
      if (wanted_[components[f]])
        for (const std::uint32_t v : block.triangles[f]) place_[v] = 0;
    for (std::size_t v = 0; v < place_.size(); ++v) {
      if (place_[v] == kDropped) continue;
      place_[v] = static_cast<std::uint32_t>(kept_.vertices.size());
      kept_.vertices.push_back(block.points[v]);
      if (v < block.borrowed.size())
        borrowed_.push_back(number_.at(block.borrowed[v]));
      else if (!block.colors.empty())
        kept_.colors.push_back(block.colors[v - block.borrowed.size()]);
    }
    for (std::size_t f = 0; f < components.size(); ++f) {
      if (!wanted_[components[f]]) continue;
      const auto& t = block.triangles[f];
      kept_.triangles.push_back({place_[t[0]], place_[t[1]], place_[t[2]]});
      if (!block.owners.empty()) kept_.owners.push_back(block.owners[f]);
    }
  }

  void rename_unfinished(const MeshBlock& block) {
    std::map<std::uint32_t, std::uint32_t> still;
    unfinished_.clear();
    for (const std::uint32_t number : block.unfinished) {
      const auto known = number_.find(number);
      std::uint32_t renamed = kDropped;
      if (known != number_.end())
        renamed = known->second;
      else if (number >= block.first_new)
        renamed = place_[number - block.first_new + block.borrowed.size()];
      if (renamed == kDropped) continue;
      if (known == number_.end())
        renamed += first_new_ - static_cast<std::uint32_t>(borrowed_.size());
      still.emplace_hint(still.end(), number, renamed);
      unfinished_.push_back(renamed);
    }
    number_ = std::move(still);
  }

  const std::vector<bool>& wanted_;                // by component
  std::map<std::uint32_t, std::uint32_t> number_;  // in the piece, of unfinished vertices
  std::uint32_t first_new_ = 0;
  // The block being made:
  TriMesh kept_;
  std::vector<std::uint32_t> place_;  // in the piece's block, by point of the mesh's
  std::vector<std::uint32_t> borrowed_, unfinished_;
};

}  // namespace

std::optional<MisplacedBody> find_misplaced_body(const TriMesh& mesh) {
  MeshAudit audit;
  audit.take(whole_block(mesh));
  const std::vector<SurfaceComponent>& surfaces = audit.components();
  const std::vector<std::size_t> depths = depths_of_surfaces(audit, MemoryMesh(mesh));
  for (std::uint32_t c = 0; c < surfaces.size(); ++c) {
    const bool within = depths[c] % 2 == 1;
    if (within != (surfaces[c].volume() > 0)) continue;
    return MisplacedBody{first_places(audit, MemoryMesh(mesh))[c], within};
  }
  return std::nullopt;
}

std::string describe_piece(const Piece& piece) {
  const Vec3 side = piece.bounds.hi - piece.bounds.lo;
  return fmt::format(
      "detached piece of {:.4g} mm3 at ({:.4g}, {:.4g}, {:.4g}) mm, {:.4g} x {:.4g} "
      "x {:.4g} mm",
      piece.volume, piece.center.x + 0.0, piece.center.y + 0.0, piece.center.z + 0.0, side.x,
      side.y, side.z);
}

PieceOfMesh::PieceOfMesh(const MeshAudit& audit, const MeshSource& mesh, const Piece& piece)
    : audit_(audit), mesh_(mesh), wanted_(audit.components().size(), false) {
  for (const std::uint32_t c : piece.components) {
    wanted_[c] = true;
    vertices_ += audit.components()[c].vertices;
    triangles_ += audit.components()[c].triangles;
  }
}

void PieceOfMesh::for_each_block(const Body& body) const {
  PieceBlocks blocks(wanted_);
  std::size_t index = 0;
  mesh_.for_each_block([&](const MeshBlock& block) {
    body(blocks.take(block, audit_.components_of(index++, block)));
  });
}

TriMesh collected(const MeshSource& mesh) {
  MeshCollector collector;
  mesh.for_each_block([&](const MeshBlock& block) { collector.take(block); });
  collector.mesh().origin = mesh.origin();
  return std::move(collector.mesh());
}

}  // namespace mrsim
