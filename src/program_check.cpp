// Whether a run would take a program: its findings, and the sweeps that can not be made.
#include "core/numbers/motions.h"
#include "core/numbers/rounding.h"
#include "core/process/error.h"
#include "interp/interpreter.h"
#include "removal/sweep/sweep_table.h"
#include "run/findings/assumed_sizes.h"
#include "run/findings/thread_passes.h"
#include <mrsim/mrsim.h>

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

namespace mrsim {
namespace {

class CheckSink : public MotionSink {
 public:
  explicit CheckSink(const std::function<void(const Diagnostic&)>& found) : found_(found) {}
  void begin(const Program& program) override { program_ = &program; }
  void motion(const Motion& motion) override;
  void diagnostic(const Diagnostic& diagnostic) override { found_(diagnostic); }

  /// Reports what only the whole program shows.
  void end(const Program& program) const {
    for (const Diagnostic& d : threads_.warnings(program)) found_(d);
  }

  std::size_t motions = 0, cuts = 0;

 private:
  void try_sweep(const Motion& motion);

  // What decides whether a sweep can be made: one motion of each kind is tried.
  using Kind = std::tuple<int, int, MotionKind, bool>;
  const std::function<void(const Diagnostic&)>& found_;
  const Program* program_ = nullptr;
  ThreadPasses threads_;
  std::set<Kind> tried_;
  std::set<std::pair<int, std::string>> told_;  ///< tools and codes
};

void CheckSink::motion(const Motion& m) {
  ++motions;
  if (!is_cut(m) || m.tool < 0) return;
  ++cuts;
  threads_.add(*program_, m);
  const bool leaves_plane = std::abs(m.start.y) > kRounding || std::abs(m.end.y) > kRounding;
  if (tried_.insert({m.file, m.tool, m.kind, leaves_plane}).second) try_sweep(m);
}

void CheckSink::try_sweep(const Motion& m) {
  const Tool& tool = program_->tools[static_cast<std::size_t>(m.tool)];
  if (tool.origin == "no data") return;  // its error has been reported
  try {
    if (is_open_cone(tool)) {
      std::vector<Tool> tools = program_->tools;
      close_cone(tools[static_cast<std::size_t>(m.tool)], 0);
      SweepTable({&m, 1}, tools);
    } else {
      SweepTable({&m, 1}, program_->tools);
    }
  } catch (const Error& error) {
    if (!told_.insert({m.tool, error.code()}).second) return;
    Diagnostic diagnostic;
    diagnostic.code = error.code();
    diagnostic.text = error.what();
    diagnostic.place = {program_->files[static_cast<std::size_t>(m.file)], m.line, m.column};
    found_(diagnostic);
  }
}

}  // namespace

CheckReport check_program(const std::string& path, const InterpOptions& options,
                          const std::function<void(const Diagnostic&)>& found) {
  CheckSink sink(found);
  CheckReport report;
  report.program = interpret(path, options, sink);
  sink.end(report.program);
  report.motions = sink.motions;
  report.cuts = sink.cuts;
  return report;
}

}  // namespace mrsim
