/// mrsim: parts, nominals and the programs beside them, read from files.
#pragma once

#include <mrsim/compare.h>

#include <optional>
#include <string>
#include <vector>

namespace mrsim {

/// Part or nominal in mm from any file: a mesh, STEP (within `deflection` mm of its faces), or a
/// .vdb, which is carved again and meshed with its owners. `note` gets a sentence where something
/// was decided, and where bodies cross each other; a mesh that is nearly a solid is then made one.
/// Throws what read_mesh() and read_step() throw; codes of a damaged .vdb begin with "vdb-". Cost:
/// that of carving, for a .vdb.
MRSIM_API TriMesh read_solid(const std::string& path, double deflection = 0.001, int threads = 0,
                             std::string* note = nullptr);

/// The lines of the programs that `origin` names, one list for each of OwnerTable::files, as
/// compare() takes them: UTF-8, without line ends. A program is looked for beside the file `part`,
/// in `folders`, and by its name as it is. The list of one that is not found is empty.
MRSIM_API std::vector<std::vector<std::string>> read_program_lines(
    const OwnerTable& origin, const std::string& part,
    const std::vector<std::string>& folders = {});

/// Where read_program_lines() looks for them: each place of each program, found or not.
MRSIM_API std::vector<std::string> program_places(const OwnerTable& origin, const std::string& part,
                                                  const std::vector<std::string>& folders = {});

/// The deflection that suits a tolerance: a twentieth, in [0.0002, 0.005] mm; 0.001 without one.
MRSIM_API double step_deflection(const std::optional<Acceptance>& accept);

/// The solids of a STEP file as one closed mesh in mm; `deflection` in mm is the largest distance
/// from the exact faces. `note` gets a sentence with that distance, or with a larger one that was
/// found where Open CASCADE does not come nearer, and with what bounds no solid and is left out.
/// Throws Error "step-unreadable", "step-incomplete" (a solid of the file cannot be read),
/// "step-no-solid", "step-open", "step-too-far", "step-unsupported" (built without Open CASCADE),
/// "step-module" (the module that reads STEP files, mrsim/step.so beside the library, is missing or
/// does not fit), and "deflection-invalid" (usage) where `deflection` is not above 0. Cost: the
/// number of triangles grows as 1 / deflection on doubly curved faces, as its root on cylinders.
MRSIM_API TriMesh read_step(const std::string& path, double deflection = 0.001,
                            std::string* note = nullptr);

}  // namespace mrsim
