#include "cli/report/findings.h"

#include "cli/console/standard_streams.h"
#include "cli/console/stop.h"
#include "cli/console/terminal.h"
#include "cli/report/diagnostics.h"
#include "core/text/json_text.h"
#include <mrsim/mrsim.h>

#include <cstdio>

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
  const auto part = [](std::size_t n, const char* word) {
    return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
  };
  return fmt::format("{}, {}, {}", part(errors(), "error"), part(warnings(), "warning"),
                     part(notes(), "note"));
}

}  // namespace mrsim::cli
