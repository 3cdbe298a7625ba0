#include "interp/text/reporter.h"

#include "core/text/text_io.h"
#include "interp/text/source.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::size_t kMostRemembered = 65536;
constexpr std::size_t kMostOfAKind = 100;
// The text of a line that was read long ago is looked up in the file, for a few findings only.
constexpr int kMostLookups = 50;
constexpr int kDeepestLookup = 200000;

}  // namespace

bool Reporter::seen(const std::string& key) {
  if (seen_.size() >= kMostRemembered)
    seen_.clear();  // keeps memory small; a finding twice does no harm
  return !seen_.insert(key).second;
}

// Counts a finding. False: it, or enough of its kind, has been reported before.
bool Reporter::is_told(Severity severity, const char* code, const SourcePlace& place, int call) {
  // A subprogram that runs fifty times says everything once. A finding before the first jump
  // is remembered too: the jump may lead back to its block.
  const std::string key = fmt::format("{}:{}:{}:{}", code, place.file, place.line, place.column);
  const bool again = call >= 0 || repeating_;
  if (again && seen(key)) return false;
  if (!again && seen_.size() < kMostRemembered / 2) seen_.insert(key);
  if (severity == Severity::error) ++errors_;
  auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                           [&](const Kind& k) { return k.severity == severity && k.code == code; });
  if (kind == kinds_.end()) kind = kinds_.insert(kinds_.end(), {severity, code});
  return ++kind->count <= kMostOfAKind;
}

void Reporter::finish() {
  for (const auto& [text, count] : again_)
    add_general(Severity::note, "told-once", fmt::format("{} more of these: {}", count, text));
  for (const Kind& kind : kinds_) {
    if (kind.count <= kMostOfAKind) continue;
    Diagnostic d;
    d.severity = kind.severity;
    d.code = kind.code;
    d.text = fmt::format("... and {} more of these", kind.count - kMostOfAKind);
    d.place.file = program_.files.front();
    sink_.diagnostic(d);
  }
}

void Reporter::emit(Diagnostic diagnostic, int call) {
  for (int i = call; i >= 0; i = program_.calls[static_cast<std::size_t>(i)].outer) {
    const CallSite& site = program_.calls[static_cast<std::size_t>(i)];
    diagnostic.called_from.push_back(
        {program_.files[static_cast<std::size_t>(site.file)], site.line, 0});
  }
  sink_.diagnostic(diagnostic);
}

void Reporter::assignment(std::string_view name, const std::string& value) {
  sink_.assignment({program_.files[static_cast<std::size_t>(file_)], line_, 1}, to_utf8(name),
                   value);
}

void Reporter::add(Severity severity, const char* code, const std::string& text, int column,
                   int length) {
  if (muted_) return;
  Diagnostic d;
  d.place = {program_.files[static_cast<std::size_t>(file_)], line_, column + 1};
  if (!is_told(severity, code, d.place, call_)) return;
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.length = std::max(1, length);
  d.source_line = to_utf8(text_.substr(0, kShownLine));
  emit(std::move(d), call_);
}

std::string Reporter::line_text(int file, int line) {
  if (line == line_ && file == file_ && !text_.empty()) return to_utf8(text_.substr(0, kShownLine));
  if (line > kDeepestLookup || ++lookups_ > kMostLookups) return {};
  LineSource source(program_.files[static_cast<std::size_t>(file)], std::size_t(1) << 16);
  std::string_view text;
  while (source.next(text))
    if (source.line_number() == line) return to_utf8(text.substr(0, kShownLine));
  return {};
}

void Reporter::add_at(Severity severity, const char* code, const std::string& text,
                      const Motion& motion) {
  Diagnostic d;
  d.place = {program_.files[static_cast<std::size_t>(motion.file)], motion.line, motion.column};
  if (!is_told(severity, code, d.place, motion.call)) return;
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.source_line = line_text(motion.file, motion.line);
  emit(std::move(d), motion.call);
}

void Reporter::once(Severity severity, const char* code, const std::string& text, const Word& word,
                    const std::string& key) {
  if (!seen(std::string(code) + ' ' + key)) return add(severity, code, text, word);
  if (severity == Severity::error) ++again_[text];
}

void Reporter::once_at(Severity severity, const char* code, const std::string& text,
                       const Motion& motion, const std::string& key) {
  if (!seen(std::string(code) + ' ' + key)) add_at(severity, code, text, motion);
}

void Reporter::add_general(Severity severity, const char* code, const std::string& text) {
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.place.file = program_.files.empty() ? std::string() : program_.files.front();
  if (!is_told(severity, code, d.place, -1)) return;
  emit(std::move(d), -1);
}

}  // namespace mrsim
