// `mrsim PROGRAM --frames N`: the part at N moments at equal shares of the machine's time.
#include "cli/commands.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// Number of motions until each moment but the last, none before the first cut is done.
std::vector<std::size_t> frame_ends(const Program& program, const CycleTime& time, int frames) {
  const auto first_cut =
      std::find_if(program.motions.begin(), program.motions.end(),
                   [](const Motion& m) { return m.kind != MotionKind::rapid && !m.assumed_start; });
  const auto first = static_cast<std::size_t>(first_cut - program.motions.begin()) + 1;
  const double total = time.cutting + time.rapid;
  std::vector<std::size_t> ends;
  double passed = 0;
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    passed += time.seconds[i];
    while (ends.size() + 1 < static_cast<std::size_t>(frames) &&
           passed * frames >= total * static_cast<double>(ends.size() + 1))
      ends.push_back(std::max(i + 1, first));
  }
  return ends;
}

// "part.stl" -> "part-03.stl", as many digits as the last one has.
std::string frame_path(const std::string& path, int frame, int frames) {
  const std::filesystem::path whole = path;
  const std::string number = fmt::format("-{:0{}}", frame, std::to_string(frames).size());
  return (whole.parent_path() / (whole.stem().string() + number + whole.extension().string()))
      .string();
}

Arguments frame_arguments(const Arguments& arguments, int frame) {
  Arguments out = arguments;
  out.frames = 0;
  for (std::string& path : out.outputs) path = frame_path(path, frame, arguments.frames);
  return out;
}

}  // namespace

// The whole program comes first: it says what is to be said, and without its part there are no
// others.
int run_frames(const Arguments& arguments) {
  const int code = run_simulate(frame_arguments(arguments, arguments.frames));
  if (code != kDone && code != kRejected) return code;
  const Program program = interpret(arguments.input, arguments.interp);
  const CycleTime time = cycle_time(program, arguments.machine);
  int frame = 0;
  for (const std::size_t end : frame_ends(program, time, arguments.frames)) {
    Arguments one = frame_arguments(arguments, ++frame);
    one.until = fmt::format("#{}", end);
    one.quiet = true;
    one.history = "off";
    one.compare = {};
    if (const int failed = run_simulate(one); failed != kDone) return failed;
  }
  return code;
}

}  // namespace mrsim::cli
