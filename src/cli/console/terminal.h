// What the program may do to the terminal it is on: colours, and a bar for long work.
#pragma once

#include "core/text/printable.h"
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

/// What stderr shows of long work: a note, once, as soon as a stage's first seconds show that it
/// will take more than ten, and others where it takes twice as long as was told, or more; and on a
/// terminal a bar after one second.
class ProgressBar {
 public:
  explicit ProgressBar(bool enabled);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Draws or notes what is due. False once the user has stopped the run.
  bool update(const char* stage, double fraction);
  void clear();
  Progress callback();

 private:
  using Clock = std::chrono::steady_clock;
  void tell_long(const char* stage, double seconds);
  void tell_longer(const char* stage, double seconds);
  void draw(const char* stage, double share, double left);

  std::mutex mutex_;
  bool enabled_;
  bool is_terminal_;
  bool drawn_ = false;
  double told_ = 0;  // s: what was told of the time that work takes, 0 = nothing yet
  std::string stage_;
  double share_ = 0;  ///< of the stage, when it was last heard of
  Clock::time_point begin_, stage_begin_, last_;
};

}  // namespace mrsim::cli
