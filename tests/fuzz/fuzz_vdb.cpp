// A .vdb as stock of a whole run. First byte even: the rest is the file, whose level set is read in
// a process of its own. Odd: the rest is the recipe of a file of ours, in a frame with the check
// sums that it needs, or nearly all mutants would be refused for them.
#include "core/numbers/hash.h"
#include "core/text/base64.h"
#include "core/text/bytes.h"
#include "fuzz_runs.h"

#include <cstddef>
#include <cstdint>

namespace {

using namespace mrsim;

ContentHash hash_of(std::string_view bytes) {
  ContentHash hash;
  hash.update(bytes.data(), bytes.size());
  return hash;
}

void append_sized(std::string& bytes, std::string_view text) {
  detail::store(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

// The head of a .vdb of no grids, as stock_file.h describes it.
std::string file_of_recipe(std::string_view recipe) {
  std::string inner;
  detail::store(inner, std::uint64_t(2));
  detail::store(inner, hash_of(recipe).digest());
  inner += recipe;
  std::string bytes;
  detail::store(bytes, std::int64_t(0x56444220));
  for (const std::uint32_t number : {224u, 10u, 0u}) detail::store(bytes, number);
  bytes += '\0';
  bytes += hash_of(recipe).uuid();
  detail::store(bytes, std::uint32_t(1));
  append_sized(bytes, "mrsim:recipe");
  append_sized(bytes, "string");
  append_sized(bytes, base64(inner));
  const std::uint64_t seal = hash_of(bytes).digest();
  bytes += "MRSIMVDB";
  detail::store(bytes, seal);
  return bytes;
}

Job job_on(const std::string& stock) {
  static const std::string program =
      fuzz::write("program", "G90 G21 G17\nG0 X-10 Y20 Z-4\nG1 X50 F100\nG0 Z20\nM30\n");
  Job job;
  job.program = program;
  job.stock = stock;
  Tool tool;
  tool.id = "1";
  tool.diameter = 6;
  job.interp.table.tools = {tool};
  job.interp.machine = MachineKind::mill;
  fuzz::limit(job, 1000);
  return job;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string stock =
      fuzz::write("stock.vdb", data[0] % 2 == 0 ? std::string(rest) : file_of_recipe(rest));
  try {
    fuzz::checked_run(job_on(stock));
  } catch (const Error&) {
  }
  return 0;
}
