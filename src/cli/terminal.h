// What the program may do to the terminal it is on: colours, and a bar for long work.
#pragma once

#include <mrsim/options.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

namespace mrsim::cli {

enum class Style { plain, bold, dim, red, yellow, cyan, green };

/// Whether `stream` is a terminal that wants colours: NO_COLOR (no-color.org) and TERM=dumb are
/// honoured.
bool has_colours(std::FILE* stream);

/// `text` in a style, or as it is where `colours` is false.
std::string styled(std::string_view text, Style style, bool colours);

/// `text` with control characters shown as '?': what comes from a file never reaches the terminal
/// as an escape sequence. Tabs stay.
std::string printable(std::string_view text);

/// A bar on stderr, drawn only on a terminal and only once the work has taken a second.
class ProgressBar {
 public:
  explicit ProgressBar(bool enabled);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Draws, and says whether to go on: false once the user has stopped the run.
  bool update(const char* stage, double fraction);
  void clear();
  Progress callback();

 private:
  std::mutex mutex_;
  bool enabled_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace mrsim::cli
