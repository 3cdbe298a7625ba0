#include "run/cuts/until.h"

#include "core/process/error.h"
#include "interp/text/source.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace mrsim {
namespace {

[[noreturn]] void fail_invalid(const std::string& until) {
  throw Error("until-invalid",
              fmt::format("--until {}: a line of the program (12), of another file (O100:7), or a "
                          "motion (#5000) is wanted",
                          until),
              Error::Kind::usage);
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

[[noreturn]] void fail_beyond(const std::string& until, const std::string& there_are) {
  throw Error("until-beyond", fmt::format("--until {}: there are {}", until, there_are),
              Error::Kind::usage);
}

// A line after the last motion ends the program normally. A line beyond the end of the file is an
// error.
void require_line(const Program& program, const std::string& until, int file, std::size_t line) {
  const std::string& path = program.files[static_cast<std::size_t>(file)];
  LineSource source(path);
  std::string_view text;
  while (source.next(text))
    if (static_cast<std::size_t>(source.line_number()) == line) return;
  fail_beyond(until, fmt::format("{} lines in {}", source.line_number(),
                                 std::filesystem::path(path).filename().string()));
}

// 100 of "O100", "O0100" and "0100".
std::optional<std::size_t> program_number(std::string_view name) {
  if (name.starts_with('O') || name.starts_with('o')) name.remove_prefix(1);
  return whole_number(name);
}

int file_named(const Program& program, const std::string& name) {
  const std::optional<std::size_t> number = program_number(name);
  std::string known;
  for (std::size_t i = 0; i < program.files.size(); ++i) {
    const std::filesystem::path path = program.files[i];
    if (name == path.filename() || name == path.stem() ||
        (number && number == program_number(path.stem().string())))
      return static_cast<int>(i);
    known += (known.empty() ? "" : ", ") + path.filename().string();
  }
  throw Error(
      "until-file",
      fmt::format("--until: no motion comes from a file \"{}\" (there are: {})", name, known),
      Error::Kind::usage);
}

bool is_called_from(const Program& program, int call, int file, std::size_t line) {
  while (call >= 0) {
    const CallSite& site = program.calls[static_cast<std::size_t>(call)];
    if (site.file == file && static_cast<std::size_t>(site.line) == line) return true;
    call = site.outer;
  }
  return false;
}

// Whether a motion or event stands at a line, or was called from it. A subprogram may stand in the
// file of its call, and a hole of a cycle stands at the cycle's line, called from that of its
// place.
template <class Step>
bool is_of_line(const Program& program, const Step& step, int file, std::size_t line) {
  return (step.file == file && static_cast<std::size_t>(step.line) == line) ||
         is_called_from(program, step.call, file, line);
}

// Behind so many motions, with the events behind the last of them that are of a line.
Moment behind_motions(const Program& program, std::size_t motions, int file, std::size_t line) {
  const std::vector<Event>& events = program.events;
  std::size_t count = 0;
  while (count < events.size() &&
         (events[count].before < motions ||
          (events[count].before == motions && is_of_line(program, events[count], file, line))))
    ++count;
  return {motions, count};
}

// Finds when the control has done a line that moves nothing. Only the control knows: a loop may
// have brought it back before it came there.
class LineWatch : public MotionSink {
 public:
  LineWatch(int file, std::size_t line) : file_(file), line_(line) {}

  void begin(const Program& program) override { program_ = &program; }
  void motion(const Motion&) override { ++now_.motions, now_.dwell = 0, last_.reset(); }
  void event(const Event& event) override {
    if (!last_ || !joins(event, *last_)) last_ = event, ++now_.events;
    now_.dwell = last_->seconds;
  }
  int mark_before(int file, int line, int call) override {
    if (is_there_ && is_called_from(*program_, call, file_, line_)) return 0;
    const bool was_there = std::exchange(is_there_, false);
    if (was_there && std::exchange(wants_behind_, false)) return kBehind;
    const auto at = static_cast<std::size_t>(line);
    is_there_ = file == file_ && at == line_;
    if (file == file_ && at <= line_ && at >= nearest_) nearest_ = at, call_ = call;
    const bool is_beyond = file == file_ && at > line_ && call == call_;
    return is_beyond && std::exchange(wants_beyond_, false) ? kBeyond : 0;
  }
  void mark(int number) override { (number == kBehind ? behind_ : beyond_) = now_; }
  void diagnostic(const Diagnostic&) override {}

  /// At the end of the program, too, where it comes to no other block.
  Moment moment() const { return behind_ ? *behind_ : !is_there_ && beyond_ ? *beyond_ : now_; }

 private:
  // Behind the block of the line and all that it calls; where it has none, before the first one
  // further down in the same subprogram, that of the nearest block above.
  static constexpr int kBehind = 1, kBeyond = 2;
  int file_;
  std::size_t line_;
  const Program* program_ = nullptr;
  std::size_t nearest_ = 0;
  int call_ = -1;  // of the nearest block
  bool is_there_ = false, wants_behind_ = true, wants_beyond_ = true;
  Moment now_;
  std::optional<Event> last_;
  std::optional<Moment> behind_, beyond_;
};

}  // namespace

Moment moment_until(const Program& program, const std::string& until,
                    const std::function<void(MotionSink&)>& read_again) {
  if (until.starts_with('#')) {
    const std::optional<std::size_t> motion = whole_number(std::string_view(until).substr(1));
    if (!motion) fail_invalid(until);
    if (*motion > program.motions.size())
      fail_beyond(until, fmt::format("{} motions", program.motions.size()));
    const Motion& last = program.motions[*motion - 1];
    return behind_motions(program, *motion, last.file, static_cast<std::size_t>(last.line));
  }
  const std::size_t colon = until.rfind(':');
  const std::optional<std::size_t> line =
      whole_number(std::string_view(until).substr(colon == until.npos ? 0 : colon + 1));
  if (!line || colon == 0) fail_invalid(until);
  const int file = colon == until.npos ? 0 : file_named(program, until.substr(0, colon));
  require_line(program, until, file, *line);
  const auto is_there = [&](const Motion& motion) {
    return is_of_line(program, motion, file, *line);
  };
  const auto first = std::find_if(program.motions.begin(), program.motions.end(), is_there);
  if (first != program.motions.end()) {
    const auto end = std::find_if_not(first, program.motions.end(), is_there);
    return behind_motions(program, static_cast<std::size_t>(end - program.motions.begin()), file,
                          *line);
  }
  LineWatch watch(file, *line);
  read_again(watch);
  return watch.moment();
}

}  // namespace mrsim
