// Simulates the program and the stock it is given and prints the part's volume.
#include <mrsim/mrsim.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    mrsim::Job job;
    job.program = argv[1];
    job.stock = argv[2];
    const mrsim::JobResult result = mrsim::simulate(job);
    std::printf("mrsim %s: %.3f mm3 left, %.3f mm3 removed, %zu triangles\n", mrsim::version(),
                result.volume, result.removed_volume, result.mesh.triangles.size());
    return result.ok && result.removed_volume > 0 ? 0 : 1;
  } catch (const mrsim::Error& error) {
    std::fprintf(stderr, "%s [%s]\n", error.what(), error.code().c_str());
    return 1;
  }
}
