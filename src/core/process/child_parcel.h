// What work in a process of its own hands back: numbers, texts and a mesh.
#pragma once

#include "core/process/child_process.h"
#include <mrsim/types.h>

#include <functional>
#include <string>
#include <vector>

namespace mrsim {

struct ChildParcel {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  TriMesh mesh;  ///< its vertices and triangles
};

struct ChildDelivery {
  ChildOutcome::End end = ChildOutcome::End::done;
  ChildParcel parcel;  ///< where `end` is done
};

/// As run_in_child(). An Error that `work` throws is thrown here.
ChildDelivery deliver_from_child(const ChildLimits& limits,
                                 const std::function<ChildParcel()>& work);

}  // namespace mrsim
