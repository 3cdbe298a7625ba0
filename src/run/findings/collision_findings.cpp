#include "run/findings/collision_findings.h"

#include "core/numbers/motions.h"
#include "core/text/text_io.h"
#include "interp/text/source.h"
#include "removal/tool/assumed_shank.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace mrsim {
namespace {

struct PartWords {
  const char *code, *name;
};

PartWords words(ToolPart part) {
  if (part == ToolPart::shank) return {"shank-collision", "the shank"};
  if (part == ToolPart::holder) return {"holder-collision", "the holder"};
  return {"rapid-collision", "the cutter"};
}

using LineTexts = std::map<std::pair<int, int>, std::string>;  // by file and line

// The program's lines that collide, each file read once and not beyond the last of them. A program
// that came through a pipe is gone: its warnings show no text.
LineTexts read_lines(const Program& program, const std::vector<Collision>& collisions) {
  LineTexts texts;
  for (const Collision& c : collisions) {
    const Motion& m = program.motions[c.motion];
    texts[{m.file, m.line}];
  }
  for (auto at = texts.begin(); at != texts.end();) {
    const int file = at->first.first;
    try {
      LineSource source(program.files[static_cast<std::size_t>(file)]);
      std::string_view text;
      for (; at != texts.end() && at->first.first == file && source.next(text);)
        if (source.line_number() == at->first.second)
          (at++)->second = to_utf8(text.substr(0, kShownLine));
    } catch (const Error&) {
    }
    while (at != texts.end() && at->first.first == file) ++at;
  }
  return texts;
}

std::string describe(const Program& program, const Collision& c) {
  const Motion& m = program.motions[c.motion];
  const Tool& tool = program.tools[static_cast<std::size_t>(m.tool)];
  const double assumed = c.part == ToolPart::shank ? assumed_shank(tool) : 0;
  std::string text = fmt::format(
      "{} of T{}{} runs {:.3f} mm deep into material{}; deepest at ({:.3f}, {:.3f}, {:.3f})",
      words(c.part).name, tool.id,
      assumed > 0 ? fmt::format(", none given, taken as Ø{:.4g},", assumed) : "", c.depth,
      m.kind == MotionKind::rapid ? " in a rapid" : "", c.place.x, c.place.y, c.place.z);
  if (c.motions > 1)
    text += fmt::format("; {} motions of this line do, this is the deepest", c.motions);
  return text;
}

Diagnostic finding(const Program& program, const Collision& c, const LineTexts& texts) {
  const Motion& m = program.motions[c.motion];
  Diagnostic d;
  d.severity = Severity::warning;
  d.code = words(c.part).code;
  d.text = describe(program, c);
  d.place = source_place(program, m);
  d.source_line = texts.at({m.file, m.line});
  for (int i = m.call; i >= 0; i = program.calls[static_cast<std::size_t>(i)].outer) {
    const CallSite& site = program.calls[static_cast<std::size_t>(i)];
    d.called_from.push_back({program.files[static_cast<std::size_t>(site.file)], site.line, 0});
  }
  return d;
}

Diagnostic& add_general(Program& program, Severity severity, const char* code,
                        const std::string& text) {
  Diagnostic& d = program.diagnostics.emplace_back();
  d.severity = severity;
  d.code = code;
  d.text = text;
  d.place.file = program.files.empty() ? "" : program.files[0];
  return d;
}

void add_withdrawals(Program& program, const CollisionReport::Withdrawals& withdrawals) {
  if (withdrawals.lines == 0) return;
  const Motion& m = program.motions[withdrawals.motion];
  const std::string count =
      withdrawals.lines == 1
          ? "a line withdraws an insert by a rapid that scrapes"
          : fmt::format("{} lines withdraw an insert by rapids that scrape", withdrawals.lines);
  Diagnostic& d = add_general(
      program, Severity::note, "withdrawal-scrapes",
      fmt::format("{} up to {:.3f} mm of what its edge has left beside the cut, here the deepest",
                  count, withdrawals.depth));
  d.place = source_place(program, m);
}

// Tools that cut with a head on a neck of unknown size.
void add_unknown_necks(Program& program) {
  for (std::size_t i = 0; i < program.tools.size(); ++i) {
    const Tool& tool = program.tools[i];
    const bool cuts =
        std::any_of(program.motions.begin(), program.motions.end(),
                    [&](const Motion& m) { return m.tool == static_cast<int>(i) && is_cut(m); });
    if (cuts && has_unknown_neck(tool))
      add_general(program, Severity::note, "neck-unchecked",
                  fmt::format("tool {}: nothing tells how wide it is above its head, so whether it "
                              "runs into material there was not checked: give neck_diameter or "
                              "shank",
                              tool.id));
  }
}

}  // namespace

void add_collisions(Program& program, const CutList& cuts, CollisionReport& report) {
  for (Collision& c : report.lines) c.motion -= cuts.inherited();
  report.withdrawals.motion -= report.withdrawals.lines > 0 ? cuts.inherited() : 0;
  const int inherited = static_cast<int>(cuts.tools().size() - program.tools.size());
  for (int& tool : report.shapeless) tool -= inherited;
  const LineTexts texts = read_lines(program, report.lines);
  for (const Collision& c : report.lines) program.diagnostics.push_back(finding(program, c, texts));
  if (report.more > 0)
    add_general(program, Severity::warning, "more-collisions",
                fmt::format("{} more lines run a part of the tool into material", report.more));
  add_withdrawals(program, report.withdrawals);
  add_unknown_necks(program);
  for (const int tool : report.shapeless)
    add_general(program, Severity::note, "collision-unchecked",
                fmt::format("tool {} has no valid shape: its rapids were not checked",
                            program.tools[static_cast<std::size_t>(tool)].id));
}

}  // namespace mrsim
