#include "cli/report/findings.h"

#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "core/text/counted.h"
#include "core/text/json_text.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace mrsim::cli {

void tell_stop_as_finding(const Arguments& arguments) {
  if (!arguments.json) return;
  set_last_words([arguments](int) {
    ::flockfile(stdout);  // the last line
    Findings(arguments).add(Error("cancelled", "the run was stopped"), arguments.input);
  });
}

Findings::Findings(const Arguments& arguments, std::string program)
    : program_(std::move(program)),
      quiet_(arguments.quiet),
      strict_(arguments.strict),
      json_(arguments.json),
      colours_(has_colours(stderr)) {}

void Findings::add(const Diagnostic& diagnostic) {
  ++count_[static_cast<std::size_t>(diagnostic.severity)];
  if (json_) {
    std::string line = diagnostic_json(diagnostic);
    if (!other_file_.empty()) line.insert(1, "\"file\":" + json_string(other_file_) + ",");
    if (!program_.empty()) line.insert(1, "\"program\":" + json_string(program_) + ",");
    return print(line + "\n");
  }
  if (quiet_ && !fails(diagnostic.severity)) return;
  say(format_diagnostic(diagnostic, colours_));
}

void Findings::add(const Error& error, const std::string& path) {
  Diagnostic diagnostic;
  if (const auto* placed = dynamic_cast<const PlacedError*>(&error))
    diagnostic = placed->diagnostic();
  else
    diagnostic.text = error.what();
  diagnostic.code = error.code();
  if (diagnostic.place.file.empty()) diagnostic.place.file = path;
  const bool elsewhere = json_ && diagnostic.place.file != path;
  if (elsewhere) other_file_ = diagnostic.place.file;
  add(diagnostic);
  other_file_.clear();
}

std::string Findings::summary() const {
  return fmt::format("{}, {}, {}", counted(errors(), "error"), counted(warnings(), "warning"),
                     counted(notes(), "note"));
}

namespace {

constexpr std::size_t kWidest = 120;  // characters of a line that are shown

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::vector<std::string_view> characters(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t n = 1;
    while (i + n < text.size() && continues(text[i + n])) ++n;
    out.push_back(text.substr(i, n));
    i += n;
  }
  return out;
}

std::string severity_word(Severity severity, bool colours) {
  if (severity == Severity::error) return styled("error:", Style::red, colours);
  if (severity == Severity::warning) return styled("warning:", Style::yellow, colours);
  return styled("note:", Style::cyan, colours);
}

std::string place_of(const SourcePlace& place) {
  std::string out = printable(place.file);
  if (place.line > 0) out += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) out += fmt::format(":{}", place.column);
  return out;
}

// The line and the caret under it, both cut to a window round the place.
std::string excerpt(const Diagnostic& diagnostic, bool colours) {
  const std::string line = printable(diagnostic.source_line);
  const std::size_t byte =
      std::min(line.size(), static_cast<std::size_t>(std::max(diagnostic.place.column - 1, 0)));
  const std::size_t end =
      std::min(line.size(), byte + static_cast<std::size_t>(std::max(diagnostic.length, 1)));
  const std::size_t at = characters(std::string_view(line).substr(0, byte)).size();
  const std::size_t length =
      std::max<std::size_t>(characters(std::string_view(line).substr(byte, end - byte)).size(), 1);
  const auto all = characters(line);
  const std::size_t first = at > kWidest * 3 / 4 ? at - kWidest / 2 : 0;
  const std::size_t last = std::min(all.size(), first + kWidest);
  std::string shown = first > 0 ? "..." : "";
  std::string under(shown.size(), ' ');
  for (std::size_t i = first; i < last; ++i) {
    shown += all[i];
    if (i < at) under += all[i] == "\t" ? '\t' : ' ';
  }
  if (last < all.size()) shown += "...";
  const std::size_t tildes = std::min(length, last > at ? last - at : 1) - 1;
  const std::string caret = styled("^" + std::string(tildes, '~'), Style::green, colours);
  return fmt::format("    {}\n    {}{}\n", shown, under, caret);
}

}  // namespace

std::string format_diagnostic(const Diagnostic& diagnostic, bool colours) {
  const std::string place = place_of(diagnostic.place);
  std::string out =
      fmt::format("{}{} {}", styled(place.empty() ? "" : place + ": ", Style::bold, colours),
                  severity_word(diagnostic.severity, colours), printable(diagnostic.text));
  if (!diagnostic.code.empty()) out += fmt::format(" [{}]", diagnostic.code);
  out += '\n';
  if (diagnostic.severity != Severity::note && !diagnostic.source_line.empty() &&
      diagnostic.place.column > 0)
    out += excerpt(diagnostic, colours);
  for (const SourcePlace& caller : diagnostic.called_from)
    out += fmt::format("    called from {}\n", place_of(caller));
  return out;
}

std::string format_error(const std::string& text, const std::string& code, bool colours) {
  return fmt::format("{}{} {} [{}]\n", styled("mrsim: ", Style::bold, colours),
                     severity_word(Severity::error, colours), printable(text), code);
}

}  // namespace mrsim::cli
