#include "interp/reporter.h"

#include "core/text_io.h"
#include "interp/source.h"

#include <algorithm>

#include <fmt/format.h>

namespace mrsim {
namespace {

// A line of a megabyte is no help on a terminal.
constexpr std::size_t kLongestLine = 1000;
constexpr std::size_t kMostRemembered = 65536;
// Lines that were read long ago are looked up in the file, a few of them.
constexpr int kMostLookups = 50;
constexpr int kDeepestLookup = 200000;

}  // namespace

bool Reporter::seen(const std::string& key) {
  if (seen_.size() >= kMostRemembered) seen_.clear();  // memory stays flat; a repeat is harmless
  return !seen_.insert(key).second;
}

void Reporter::emit(Diagnostic diagnostic, int call) {
  // A subprogram that runs fifty times says everything once.
  if (call >= 0 && seen(fmt::format("{}:{}:{}:{}", diagnostic.code, diagnostic.place.file,
                                    diagnostic.place.line, diagnostic.place.column)))
    return;
  for (int i = call; i >= 0; i = program_.calls[static_cast<std::size_t>(i)].outer) {
    const CallSite& site = program_.calls[static_cast<std::size_t>(i)];
    diagnostic.called_from.push_back(
        {program_.files[static_cast<std::size_t>(site.file)], site.line, 0});
  }
  if (diagnostic.severity == Severity::error) ++errors_;
  sink_.diagnostic(diagnostic);
}

void Reporter::add(Severity severity, const char* code, const std::string& text, int column,
                   int length) {
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.place = {program_.files[static_cast<std::size_t>(file_)], line_, column + 1};
  d.length = std::max(1, length);
  d.source_line = to_utf8(text_.substr(0, kLongestLine));
  emit(std::move(d), call_);
}

std::string Reporter::line_text(int file, int line) {
  if (line == line_ && file == file_ && !text_.empty())
    return to_utf8(text_.substr(0, kLongestLine));
  if (line > kDeepestLookup || ++lookups_ > kMostLookups) return {};
  LineSource source(program_.files[static_cast<std::size_t>(file)], std::size_t(1) << 16);
  std::string_view text;
  while (source.next(text))
    if (source.line_number() == line) return to_utf8(text.substr(0, kLongestLine));
  return {};
}

void Reporter::add_at(Severity severity, const char* code, const std::string& text,
                      const Motion& motion) {
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.place = {program_.files[static_cast<std::size_t>(motion.file)], motion.line, motion.column};
  d.source_line = line_text(motion.file, motion.line);
  emit(std::move(d), motion.call);
}

void Reporter::once(Severity severity, const char* code, const std::string& text, const Word& word,
                    const std::string& key) {
  if (!seen(std::string(code) + ' ' + key)) add(severity, code, text, word);
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
  emit(std::move(d), -1);
}

}  // namespace mrsim
