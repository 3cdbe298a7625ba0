// `mrsim check`: programs, folders and the standard input, in one process.
#include "cli/commands/commands.h"
#include "cli/console/figures.h"
#include "cli/console/standard_streams.h"
#include "cli/console/terminal.h"
#include "cli/report/findings.h"
#include "cli/report/report.h"
#include "core/text/ascii.h"
#include "core/text/json_text.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// In folders: main programs by the extensions that controls and posts use.
constexpr std::array<std::string_view, 20> kExtensions = {
    ".nc",  ".ngc", ".mpf", ".tap", ".cnc", ".gcode", ".gc",  ".g",   ".min", ".eia",
    ".iso", ".din", ".fan", ".ptp", ".nci", ".fnc",   ".prg", ".anc", ".h",   ".txt"};

bool is_program(const std::string& path) {
  return std::find(kExtensions.begin(), kExtensions.end(), extension_of(path)) != kExtensions.end();
}

// The programs of the arguments; those of a folder by name, so that two runs print the same.
std::vector<std::string> programs_of(const std::vector<std::string>& inputs) {
  std::vector<std::string> out;
  for (const std::string& input : inputs) {
    std::error_code failed;
    if (!std::filesystem::is_directory(input, failed)) {
      out.push_back(input);
      continue;
    }
    std::vector<std::string> found;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(input, options))
      if (entry.is_regular_file(failed) && is_program(entry.path().string()))
        found.push_back(entry.path().string());
    if (found.empty())
      throw Error("folder-empty",
                  fmt::format("{} holds no program (.nc .mpf .ngc .tap ...)", input));
    std::sort(found.begin(), found.end());
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

std::string dialect_word(Dialect dialect) {
  constexpr const char* kNames[] = {"unknown", "sinumerik", "iso", "fanuc", "codesys", "ngc"};
  return kNames[static_cast<std::size_t>(dialect)];
}

/// Checks one program after the other and adds up.
class Checker {
 public:
  Checker(const Arguments& arguments, bool many) : arguments_(arguments), many_(many) {}

  void check(const std::string& path) {
    Findings findings(arguments_, many_ ? path : "");
    CheckReport report;
    try {
      report = check_program(path, arguments_.interp,
                             [&](const Diagnostic& diagnostic) { findings.add(diagnostic); });
    } catch (const Error& error) {
      if (!many_ && !arguments_.json) throw;
      if (!many_) failure_ = exit_code_of(error);  // as without --json
      findings.add(error, path);
    }
    ++programs_;
    if (findings.failed()) ++failed_;
    errors_ += findings.errors();
    warnings_ += findings.warnings();
    tell(path, report, findings);
  }

  int finish() const {
    if (many_ && arguments_.json)
      print(
          fmt::format("{{\"kind\":\"total\",\"programs\":{},\"failed\":{},\"errors\":{},"
                      "\"warnings\":{}}}\n",
                      programs_, failed_, errors_, warnings_));
    else if (many_ && !arguments_.quiet)
      print(fmt::format("{} programs, {} failed\n", programs_, failed_));
    return finish_output(failed_ > 0 ? failure_ : kDone);
  }

 private:
  void tell(const std::string& path, const CheckReport& report, const Findings& findings) const {
    const Program& program = report.program;
    if (arguments_.json) {
      print(
          fmt::format("{{\"kind\":\"summary\",\"program\":{},\"dialect\":\"{}\",\"machine\":\"{}\","
                      "\"motions\":{},\"cuts\":{},\"errors\":{},\"warnings\":{},\"notes\":{},"
                      "\"ok\":{}}}\n",
                      json_string(path), dialect_word(program.dialect),
                      machine_name(program.machine), report.motions, report.cuts, findings.errors(),
                      findings.warnings(), findings.notes(), !findings.failed()));
    } else if (many_ && !arguments_.quiet) {
      print(fmt::format("{}: {}, {}, {} motions: {}\n", printable(path),
                        dialect_word(program.dialect), machine_name(program.machine),
                        report.motions, findings.summary()));
    } else if (!arguments_.quiet) {
      print(format_program(program, arguments_.verbose, has_colours(stdout)));
      print(
          fmt::format("  {:<11}{}\n", "motions", grouped(static_cast<double>(report.motions), 0)));
      print(fmt::format("  {:<11}{}\n", "result", findings.summary()));
    }
  }

  const Arguments& arguments_;
  bool many_;
  int failure_ = kFailed;
  std::size_t programs_ = 0, failed_ = 0, errors_ = 0, warnings_ = 0;
};

}  // namespace

int run_check(const Arguments& arguments) {
  tell_stop_as_finding(arguments);
  const std::vector<std::string> programs = programs_of(arguments.inputs);
  Checker checker(arguments, programs.size() > 1);
  for (const std::string& program : programs) checker.check(program);
  return checker.finish();
}

}  // namespace mrsim::cli
