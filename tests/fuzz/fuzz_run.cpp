// A whole run: program, stock and tools, parted by lines of "=====", with tight limits on time and
// memory. A part whose mesh keeps its promises, diagnostics, or an Error.
#include "fuzz_files.h"
#include <mrsim/mrsim.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace {

using namespace mrsim;
using fuzz::require;
using fuzz::write;

std::string take_part(std::string& text) {
  const std::string mark = "=====\n";
  const std::size_t end = text.find(mark);
  const std::string part = text.substr(0, end);
  text = end == text.npos ? "" : text.substr(end + mark.size());
  return part;
}

// A stock of one line is a word ("box:0,0,0,1,1,1"), else an OBJ.
Job job_of(std::string text) {
  Job job;
  job.program = write("program", take_part(text));
  const std::string stock = take_part(text);
  const bool word = stock.find('\n') >= stock.size() - 1;
  job.stock = word ? stock.substr(0, stock.find('\n')) : write("stock.obj", stock);
  if (!text.empty()) job.interp.table = load_tools(write("tools.toml", text));
  job.interp.max_blocks = 2000;
  job.carve.voxel = 2;
  job.carve.threads = job.mesh.threads = job.collisions.threads = 1;
  job.carve.max_memory = std::size_t(500) << 20;
  // 3 s, far above what a run of this size takes; one that does not ask is found by -timeout.
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  job.carve.progress = job.mesh.progress = job.collisions.progress = job.stock_options.progress =
      [end](const char*, double) { return std::chrono::steady_clock::now() < end; };
  return job;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const JobResult result = simulate(job_of({reinterpret_cast<const char*>(data), size}));
    if (!result.ok) {
      require(!result.program.diagnostics.empty());
      return 0;
    }
    require(result.summary.closed && result.summary.manifold && result.summary.degenerate == 0);
    require(std::isfinite(result.volume) && result.volume <= result.stock_volume * 1.001 + 1e-3);
  } catch (const Error&) {
  }
  return 0;
}
