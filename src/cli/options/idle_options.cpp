#include "cli/options/idle_options.h"

#include "cli/console/standard_streams.h"
#include "cli/options/command_lines.h"
#include "cli/options/typed_options.h"
#include "core/text/ascii.h"
#include "core/words/option_table.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>

namespace mrsim::cli {
namespace {

// Whether a name ends like one of these, in any case.
bool ends_like(const std::string& path, std::initializer_list<std::string_view> endings) {
  return std::find(endings.begin(), endings.end(), extension_of(path)) != endings.end();
}

bool any_ends_like(const std::vector<std::string>& paths,
                   std::initializer_list<std::string_view> endings) {
  return std::any_of(paths.begin(), paths.end(),
                     [&](const std::string& path) { return ends_like(path, endings); });
}

// A stock that is given by its measures, or not at all.
bool is_measured(const std::string& stock) {
  const std::vector<std::string_view> forms = option_words(*find_option("--stock"));
  return stock.empty() || std::any_of(forms.begin(), forms.end(), [&](std::string_view form) {
           return stock.starts_with(form);
         });
}

bool reads_step(const TypedOptions& typed) {
  return any_ends_like(typed.inputs(), {".step", ".stp"}) ||
         ends_like(typed.text("--nominal"), {".step", ".stp"});
}

}  // namespace

std::vector<std::string> idle_options(const CommandLine& line, const TypedOptions& typed) {
  std::vector<std::string> out;
  const std::string& color = typed.text("--color");
  const bool colored = !color.empty() && color != "none";
  if (line.uses == kUseRun && colored &&
      !any_ends_like(typed.texts("--output"), {".ply", ".3mf", ".glb"}))
    out.emplace_back("--color does nothing: no output keeps colours, .ply, .3mf and .glb do");
  if (line.uses == kUseRender && colored && typed.has("--nominal"))
    out.emplace_back("--color does nothing: with --nominal the picture shows deviations");
  const std::string& coloured =
      line.uses == kUseCompare ? typed.text("--output") : typed.text("--deviation");
  if (line.uses != kUseRender && typed.has("--colors") && coloured.empty())
    out.push_back(fmt::format("--colors does nothing: it is for the part coloured by deviation, {}",
                              line.uses == kUseCompare ? "-o part.ply" : "--deviation part.ply"));
  if (typed.has("--deflection") && !reads_step(typed))
    out.emplace_back("--deflection does nothing: no file that is compared is STEP");
  for (const char* option : {"--stock-repair", "--stock-exact"})
    if (typed.has(option) && is_measured(typed.text("--stock")))
      out.push_back(fmt::format("{} does nothing: it is for a stock that is a mesh", option));
  return out;
}

void tell_idle_options(const CommandLine& line, const TypedOptions& typed) {
  if (typed.flag("--quiet")) return;
  for (const std::string& note : idle_options(line, typed)) say("note: " + note + "\n");
}

}  // namespace mrsim::cli
