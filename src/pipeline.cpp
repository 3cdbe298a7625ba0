// The facade: calls the stages in order.

#include "core/error.h"
#include "core/text_io.h"
#include "cuts.h"
#include "interp/interpreter.h"
#include "mesh/check.h"
#include "mesh/extract.h"
#include "mesh/stl.h"
#include "removal/default_stock.h"
#include "removal/stock.h"
#include "removal/stock_file.h"
#include "removal/stock_shape.h"
#include "removal/sweep.h"
#include "setup/stock_spec.h"
#include "setup/tool_spec.h"
#include "setup/tools_file.h"
#include <mrsim/mrsim.h>

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <sys/resource.h>

namespace mrsim {
namespace {

class Collector : public MotionSink {
 public:
  void motion(const Motion& motion) override { motions.push_back(motion); }
  void diagnostic(const Diagnostic& diagnostic) override { diagnostics.push_back(diagnostic); }
  std::vector<Motion> motions;
  std::vector<Diagnostic> diagnostics;
};

class StageClock {
 public:
  explicit StageClock(JobResult& result) : result_(result) {}
  void done(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    result_.stage_seconds.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  JobResult& result_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

const char* version() { return MRSIM_VERSION; }

}  // namespace mrsim
