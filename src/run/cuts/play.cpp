#include "run/cuts/play.h"

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "removal/history/cut_faces.h"
#include "removal/history/cut_volume.h"
#include "removal/history/removed_volumes.h"
#include "removal/part/memory_plan.h"
#include "removal/part/stock_grid.h"
#include "run/cuts/cut_pieces.h"
#include "run/tools/tool_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrsim {
namespace {

constexpr double kVoxels = 200;  // along the longest side

// Pieces that look like a steady motion: an eighth of the tool, three voxels at least.
constexpr PieceRule kSteady{{0.125, 3}, 1000, 150000, true, {0.125, 3}};

void add_volume(const PartField& field, const CutPieces& pieces, std::size_t inherited, int threads,
                const Progress& progress, Play& play) {
  const std::size_t count = pieces.first.back();
  const auto before = std::int32_t(pieces.first[inherited]);
  CutVolume volume =
      make_cut_volume(field, history_lattice(field, play.voxel), count, threads, progress);
  CutFaces faces = make_cut_faces(field, volume, before, threads);
  play.half_plane = volume.lattice.half_plane;
  play.origin = volume.center(0, 0, 0);
  play.size = volume.size;
  play.faces = std::move(faces.faces);
  play.late = std::move(faces.late);
  play.gone = std::move(volume.cut);
  for (std::int32_t& cut : play.gone) cut = moment_of(cut, before);
  for (std::size_t i = inherited; i + 1 < pieces.first.size(); ++i) {
    play.first.push_back(std::int32_t(pieces.first[i]) - before);
    double sum = 0;
    for (std::size_t k = pieces.first[i]; k < pieces.first[i + 1]; ++k) sum += volume.removed[k];
    play.removed.push_back(sum);
  }
  play.first.push_back(std::int32_t(count) - before);
}

}  // namespace

Play make_play(const Job& job, const JobResult& result, const Stock& stock, const CutList& cuts) {
  Play play;
  const int threads = job.carve.threads;
  const Vec3 size = result.stock.box.hi - result.stock.box.lo;
  play.voxel = std::max({size.x, size.y, size.z}) / kVoxels;
  const double piece = piece_voxel(cuts, play.voxel, kSteady);
  const CutPieces pieces = divide_cuts(cuts, piece, kSteady);
  const PartField& field = *stock.grid().field;
  if (std::isfinite(piece)) {
    require_table(pieces.motions, cuts.tools(), {});
    add_volume(
        PartField(field.solid(), SweepTable(pieces.motions, cuts.tools(), {}, threads), threads),
        pieces, cuts.inherited(), threads, job.carve.progress, play);
  } else {
    add_volume(field, pieces, cuts.inherited(), threads, job.carve.progress, play);
  }
  for (const Tool& tool : result.program.tools) play.tools.push_back(tool_outlines(tool));
  return play;
}

Play path_play(const Program& program) {
  Play play;
  play.first.assign(program.motions.size() + 1, 0);
  play.removed.assign(program.motions.size(), 0);
  for (const Tool& tool : program.tools) {
    play.tools.emplace_back();
    try {
      play.tools.back() = tool_outlines(tool);
    } catch (const Error&) {  // not shown
    }
  }
  return play;
}

}  // namespace mrsim
