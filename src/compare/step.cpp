// STEP files through the module that reads them, opened when the first one is asked for.
#include "compare/step/module.h"
#include "core/module.h"
#include "core/text_io.h"
#include "mesh/check.h"
#include "mesh/weld.h"
#include <mrsim/solid_files.h>

#include <cmath>
#include <memory>
#include <new>
#include <string>

namespace mrsim {
namespace {

#ifdef MRSIM_HAS_STEP

struct StepModule {
  Module module{{"step", "step-module", "reads STEP files",
                 "install mrsim with all its files and Open CASCADE's libraries, build it again "
                 "where they have changed, or export the model as STL or 3MF"}};
  ReadStepFacets* read = module.function<ReadStepFacets>(kReadStepFacets);
  FreeStepFacets* free = module.function<FreeStepFacets>(kFreeStepFacets);
};

TriMesh weld_facets(const StepFacets& facets) {
  Welder welder;
  std::vector<std::uint32_t> index(facets.point_count);
  for (std::size_t i = 0; i < facets.point_count; ++i) {
    const float* p = facets.points + 3 * i;
    index[i] = welder.add({p[0], p[1], p[2]});
  }
  TriMesh mesh;
  for (std::size_t i = 0; i < facets.triangle_count; ++i) {
    const std::uint32_t* corners = facets.triangles + 3 * i;
    const std::array<std::uint32_t, 3> t{index[corners[0]], index[corners[1]], index[corners[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  mesh.vertices = welder.take();
  return mesh;
}

// A file that is no STEP never reaches the module, whose messages for such files say little.
void require_step_header(const std::string& path) {
  const std::string head = read_file(path).substr(0, 4096);
  if (head.find("ISO-10303-21") == std::string::npos)
    throw Error("step-unreadable", path + " is not a STEP file: it has no ISO-10303-21 header");
}

TriMesh read_solids(const std::string& path, double deflection) {
  require_step_header(path);
  static const StepModule module;
  const std::unique_ptr<const StepFacets, FreeStepFacets*> facets(
      module.read(path.c_str(), deflection), module.free);
  if (!facets) throw std::bad_alloc();
  if (facets->code) throw Error(facets->code, path + facets->text);
  return weld_facets(*facets);
}

#else

TriMesh read_solids(const std::string& path, double) {
  throw Error("step-unsupported",
              path +
                  ": this mrsim was built without Open CASCADE (MRSIM_STEP) and reads no STEP; "
                  "export the model as STL or 3MF");
}

#endif

}  // namespace

TriMesh read_step(const std::string& path, double deflection) {
  if (!(deflection > 0) || !std::isfinite(deflection))
    throw Error("deflection-invalid", "the deflection of a STEP file is a length above 0 mm",
                Error::Kind::usage);
  TriMesh mesh = read_solids(path, deflection);
  const MeshSummary summary = check_mesh(mesh);
  if (!summary.closed || !summary.oriented)
    throw Error("step-open", path + ": the solids' faces do not join: " + summary.first_fault);
  return mesh;
}

}  // namespace mrsim
