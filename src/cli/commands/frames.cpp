// `--frames N`: the part, or a picture of it, at N moments at equal shares of the machine's time
// or of the volume that is removed.
#include "cli/commands/commands.h"
#include "cli/console/standard_streams.h"
#include "cli/console/temporary_place.h"
#include "cli/console/terminal.h"
#include "cli/options/option_values.h"
#include "cli/report/findings.h"
#include "core/numbers/motions.h"
#include "core/output/publish.h"
#include "core/process/child_process.h"
#include "core/process/error.h"
#include "core/text/text_io.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

// Runs ffmpeg. Returns its exit code, or -1 if it did not exit.
int run_ffmpeg(const std::vector<std::string>& words) {
  const pid_t child = start_program(words, ProgramLife::ours);
  int status = 0;
  while (child < 0 || ::waitpid(child, &status, 0) < 0)
    if (child < 0 || errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Whether the path is that of a film, by its ending.
bool is_film(const std::string& path) { return path.ends_with(".webm"); }

// Throws Error "ffmpeg-missing" where no folder of PATH holds ffmpeg.
void require_ffmpeg() {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return;
  throw Error("ffmpeg-missing",
              "films are made by ffmpeg, which is not installed: install it, or write pictures, "
              "-o f%04d.png");
}

// Makes a .webm of the pictures `folder`/0001.png and on, twelve a second. Its name, in that
// folder. Throws Error "film" where ffmpeg fails; its own words go to the standard error.
std::string make_film(const std::string& folder) {
  std::string film = folder + "/film.webm";
  const int code = run_ffmpeg({"ffmpeg", "-nostdin", "-v", "error", "-y", "-framerate", "12", "-i",
                               folder + "/%04d.png", "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p",
                               "-crf", "32", "-b:v", "0", film});
  if (code != 0) throw Error("film", "ffmpeg failed: there is no film");
  return film;
}

// How many motions run until each moment, the last one excepted: at least those up to the end of
// the first cut.
std::vector<std::size_t> frame_ends(const JobResult& whole, const Arguments& arguments) {
  const Program& program = whole.program;
  const std::vector<double>& shares =
      arguments.frames_by_volume ? whole.history.removed : whole.cycle.seconds;
  const double total = arguments.frames_by_volume ? whole.history.total.removed
                                                  : whole.cycle.cutting + whole.cycle.rapid;
  const int frames = arguments.frames;
  const auto first_cut = std::find_if(program.motions.begin(), program.motions.end(), is_cut);
  const auto first = static_cast<std::size_t>(first_cut - program.motions.begin()) + 1;
  std::vector<std::size_t> ends;
  double passed = 0;
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    passed += shares[i];
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

// "f%04d.png" with the frame's number, else as frame_path() has it.
std::string picture_path(const std::string& path, int frame, int frames) {
  const std::size_t percent = path.find('%');
  if (percent == path.npos) return frame_path(path, frame, frames);
  std::size_t end = percent + 1;
  while (end < path.size() && path[end] >= '0' && path[end] <= '9') ++end;
  const std::string width = path.substr(percent + 1, end - percent - 1);
  if (end == path.size() || path[end] != 'd' || width.size() > 2)
    fail_usage(fmt::format("-o {}: the number of a frame is written %d, or %04d", path));
  const std::string number = fmt::format(fmt::runtime("{:" + width + "}"), frame);
  return path.substr(0, percent) + number + path.substr(end + 1);
}

Arguments frame_arguments(const Arguments& arguments, int frame) {
  Arguments out = arguments;
  out.frames = 0;
  for (std::string& path : out.outputs) path = frame_path(path, frame, arguments.frames);
  return out;
}

// The runs of all moments but the last.
std::vector<Arguments> earlier_frames(const Arguments& arguments, const JobResult& whole) {
  std::vector<Arguments> out;
  for (const std::size_t end : frame_ends(whole, arguments)) {
    Arguments& one = out.emplace_back(frame_arguments(arguments, static_cast<int>(out.size()) + 1));
    one.until = fmt::format("#{}", end);
    one.quiet = true;
    one.history = "off";
    one.compare = {};
    one.rest.clear();
  }
  return out;
}

// Checks the files of all moments before any work, and returns them.
std::vector<NamedPath> checked(const Arguments& arguments, const std::vector<std::string>& paths) {
  std::vector<NamedPath> outputs, inputs = arguments.named_inputs;
  for (const std::string& path : paths) outputs.push_back({path, "-o"});
  const CompareRequest& more = arguments.compare;
  for (const NamedPath& side : {NamedPath{more.report, "--report"},
                                {more.json, "--json"},
                                {more.junit, "--junit"},
                                {more.deviation, "--deviation"},
                                {arguments.history == "off" ? "" : arguments.history, "--history"},
                                {arguments.rest, "--rest"}})
    if (!side.path.empty()) outputs.push_back(side);
  inputs.push_back({arguments.input, "the program"});
  inputs.push_back({arguments.stock, "the stock"});
  prepare_outputs(outputs, inputs);
  return outputs;
}

OutputFile copy_of(const std::string& made, const std::string& path) {
  return {path, [made](const ByteSink& sink) {
            const std::string bytes = read_file(made);
            sink(bytes.data(), bytes.size());
          }};
}

// Each file that waits for its place is open: 256 frames may be more than a process may have.
void allow_open_files(std::size_t count) {
  constexpr std::size_t kOthers = 200;
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= count + kOthers) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, count + kOthers);
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

// Runs the whole program first: it prints the findings, and if it makes no part, no earlier frame
// is made either.
int run_frames(const Arguments& arguments) {
  std::vector<std::string> paths;
  for (int frame = 1; frame <= arguments.frames; ++frame)
    for (const std::string& path : arguments.outputs)
      paths.push_back(frame_path(path, frame, arguments.frames));
  try {
    checked(arguments, paths);
  } catch (const Error& error) {
    tell_refused(arguments, error);
    throw;
  }
  allow_open_files(paths.size());
  JobResult whole;
  return run_simulate(frame_arguments(arguments, arguments.frames), whole,
                      [&](const JobResult& result) { return earlier_frames(arguments, result); });
}

int run_picture_frames(const Arguments& arguments) {
  const std::string& output = arguments.outputs[0];
  const bool film = is_film(output);
  if (film)
    require_ffmpeg();
  else
    require_png(output);
  std::vector<std::string> paths;
  for (int frame = 1; frame <= (film ? 1 : arguments.frames); ++frame)
    paths.push_back(film ? output : picture_path(output, frame, arguments.frames));
  const std::vector<NamedPath> outputs = checked(arguments, paths);
  const TemporaryPlace workshop(TemporaryPlace::Kind::folder);
  Arguments one = arguments;
  one.outputs = {workshop.path() + "/part.ply"};
  const auto picture = [&](int frame) {
    return fmt::format("{}/{:04}.png", workshop.path(), frame);
  };
  const auto draw = [&](int frame) {
    render(read_mesh(one.outputs[0]), picture(frame), one.render);
  };
  JobResult whole;
  if (const int failed = run_simulate(one, whole); failed != kDone) return failed;
  protect_program(whole.program.files, outputs);
  if (whole.program.machine == MachineKind::lathe && one.render.up == UpAxis::automatic)
    one.render.up = UpAxis::x;
  draw(arguments.frames);
  whole.mesh = {};
  one.history = "off";
  one.quiet = true;
  int frame = 0;
  for (const std::size_t end : frame_ends(whole, arguments)) {
    one.until = fmt::format("#{}", end);
    if (const int failed = run_simulate(one); failed != kDone) return failed;
    draw(++frame);
  }
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i)
    files.push_back(
        copy_of(film ? make_film(workshop.path()) : picture(static_cast<int>(i) + 1), paths[i]));
  write_files_atomically(files);
  return finish_output(kDone);
}

}  // namespace mrsim::cli
