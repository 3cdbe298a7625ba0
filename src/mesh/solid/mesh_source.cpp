#include "mesh/solid/mesh_source.h"

namespace mrsim {

const std::vector<ColorLabel>& MeshSource::legend() const {
  static const std::vector<ColorLabel> none;
  return none;
}

}  // namespace mrsim
