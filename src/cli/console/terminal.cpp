#include "cli/console/terminal.h"

#include "cli/console/figures.h"
#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace mrsim::cli {
namespace {

const char* escape_of(Style style) {
  switch (style) {
    case Style::bold:
      return "\x1b[1m";
    case Style::dim:
      return "\x1b[2m";
    case Style::red:
      return "\x1b[1;31m";
    case Style::yellow:
      return "\x1b[1;33m";
    case Style::cyan:
      return "\x1b[1;36m";
    case Style::green:
      return "\x1b[1;32m";
    case Style::plain:
      break;
  }
  return "";
}

// s of a stage: from then on its share done shows how long it will take; from the second on where
// that share is still little.
constexpr double kFirstLook = 1, kSecondLook = 5;
constexpr double kLittle = 0.002;  // share done
constexpr double kLong = 10;       // s: work that is announced
constexpr double kLonger = 2;      // times what was announced: told as well

int terminal_width() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

}  // namespace

bool has_colours(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color != nullptr && *no_color != '\0') return false;
  const char* term = std::getenv("TERM");
  if (term == nullptr || std::string_view(term) == "dumb") return false;
  return ::isatty(::fileno(stream)) != 0;
}

std::string styled(std::string_view text, Style style, bool colours) {
  if (!colours || style == Style::plain) return std::string(text);
  return fmt::format("{}{}\x1b[0m", escape_of(style), text);
}

ProgressBar::ProgressBar(bool enabled)
    : enabled_(enabled),
      is_terminal_(::isatty(STDERR_FILENO) != 0),
      begin_(Clock::now()),
      stage_begin_(begin_),
      last_(begin_) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

bool ProgressBar::update(const char* stage, double fraction) {
  using namespace std::chrono_literals;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!enabled_) return stop_code() == 0;
  const auto now = Clock::now();
  const double share = std::clamp(fraction, 0.0, 1.0);
  const bool begins_anew = share == 0 && share_ > 0;
  if (stage_ != stage || begins_anew) stage_ = stage, stage_begin_ = now;
  share_ = share;
  const double taken = std::chrono::duration<double>(now - stage_begin_).count();
  const bool is_known = share > 0 && taken > (share > kLittle ? kFirstLook : kSecondLook);
  const double left = is_known ? taken * (1 - share) / share : -1;
  if (told_ == 0 && taken + left > kLong && left > 0) tell_long(stage, taken + left);
  if (told_ > 0 && taken > kLonger * told_) tell_longer(stage, taken);
  if (is_terminal_ && now - begin_ > 1s && now - last_ > 100ms) {
    draw(stage, share, left);
    last_ = now;
  }
  return stop_code() == 0;
}

void ProgressBar::tell_long(const char* stage, double seconds) {
  say(fmt::format("{}note: {} will take about {}; Ctrl-C stops the run\n", drawn_ ? "\r\x1b[K" : "",
                  stage, duration(seconds)));
  drawn_ = false, told_ = seconds;
}

void ProgressBar::tell_longer(const char* stage, double seconds) {
  say(fmt::format("{}note: {} takes longer than expected, {} so far; Ctrl-C stops the run\n",
                  drawn_ ? "\r\x1b[K" : "", stage, duration(seconds)));
  drawn_ = false, told_ = seconds;
}

void ProgressBar::draw(const char* stage, double share, double left) {
  const int width = std::clamp(terminal_width() - 45, 10, 50);
  const int filled = static_cast<int>(share * width);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(width - filled), '.');
  say(fmt::format("\r\x1b[K{:<12.12} [{}] {:3.0f} %{}", stage, bar, 100 * share,
                  left < 1 ? "" : fmt::format("  {} left", duration(left))));
  drawn_ = true;
}

Progress ProgressBar::callback() {
  return [this](const char* stage, double fraction) { return update(stage, fraction); };
}

}  // namespace mrsim::cli
