// Simulates the program and the stock it is given, prints the part's volume, and stops a second
// run while its voxels are sampled.
#include <mrsim/mrsim.h>

#include <cstdio>

namespace {

// Voxels are sampled in a module: the Error thrown there is to arrive as one.
bool stops_on_voxels(mrsim::Job job) {
  job.carve.voxel = 0.1;
  job.outputs = {"cancelled.vdb"};
  job.carve.progress = [](const char*, double) { return false; };
  try {
    mrsim::simulate(job);
    return false;
  } catch (const mrsim::Error& error) {
    return error.code() == "cancelled";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    mrsim::Job job;
    job.program = argv[1];
    job.stock = argv[2];
    const mrsim::JobResult result = mrsim::simulate(job);
    std::printf("mrsim %s: %.3f mm3 left, %.3f mm3 removed, %zu triangles\n", mrsim::version(),
                result.volume, result.removed_volume, result.mesh.triangles.size());
    return result.ok && result.removed_volume > 0 && stops_on_voxels(job) ? 0 : 1;
  } catch (const mrsim::Error& error) {
    std::fprintf(stderr, "%s [%s]\n", error.what(), error.code().c_str());
    return 1;
  }
}
