// A whole run: program, stock and tools, parted by lines of "=====", with tight limits on time and
// memory. A part whose mesh keeps its promises, diagnostics, or an Error.
#include "fuzz_runs.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

using namespace mrsim;
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
  fuzz::limit(job, 500);
  return job;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const JobResult result = fuzz::checked_run(job_of({reinterpret_cast<const char*>(data), size}));
    if (result.ok) fuzz::require(result.volume <= result.stock_volume * 1.001 + 1e-3);
  } catch (const Error&) {
  }
  return 0;
}
