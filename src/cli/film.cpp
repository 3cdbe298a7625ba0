#include "cli/film.h"

#include "core/child_process.h"
#include "core/error.h"

#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

// Its exit code, or -1.
int run_ffmpeg(const std::vector<std::string>& words) {
  const pid_t child = start_program(words, ProgramLife::ours);
  int status = 0;
  while (child < 0 || ::waitpid(child, &status, 0) < 0)
    if (child < 0 || errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

bool is_film(const std::string& path) { return path.ends_with(".webm"); }

void require_ffmpeg() {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return;
  throw Error("ffmpeg-missing",
              "films are made by ffmpeg, which is not installed: install it, or write pictures, "
              "-o f%04d.png");
}

std::string make_film(const std::string& folder) {
  std::string film = folder + "/film.webm";
  const int code = run_ffmpeg({"ffmpeg", "-nostdin", "-v", "error", "-y", "-framerate", "12", "-i",
                               folder + "/%04d.png", "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p",
                               "-crf", "32", "-b:v", "0", film});
  if (code != 0) throw Error("film", "ffmpeg failed: there is no film");
  return film;
}

}  // namespace mrsim::cli
