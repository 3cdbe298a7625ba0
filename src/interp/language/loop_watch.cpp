#include "interp/language/loop_watch.h"

#include <algorithm>
#include <utility>

namespace mrsim {
namespace {

constexpr std::size_t kMostVariables = 2000;
// Modes that a pass leaves to the next one are settled after some passes.
constexpr int kReturns = 3;

}  // namespace

void LoopWatch::begin_block() {
  ++work_;
  block_.clear();
  block_reads_state_ = false;
  if (on_ && work_ > until_) forget();
}

bool LoopWatch::set_data(bool data) { return std::exchange(data_, data); }

void LoopWatch::read(const VariableKey& variable) { (data_ ? block_ : deciding_).insert(variable); }

void LoopWatch::read_state() { (data_ ? block_reads_state_ : state_decides_) = true; }

void LoopWatch::decide() {
  deciding_.insert(block_.begin(), block_.end());
  state_decides_ = state_decides_ || block_reads_state_;
}

void LoopWatch::write(const VariableKey& variable, const std::optional<std::string>& before) {
  if (!before || before_.size() > kMostVariables) return forget();
  before_.try_emplace(variable, *before);
  made_of_[variable].insert(block_.begin(), block_.end());
  if (block_reads_state_) made_of_state_.insert(variable);
}

void LoopWatch::leave(std::size_t depth) {
  if (depth <= depth_) forget();
}

void LoopWatch::count_pass(std::size_t depth, const Place& begin, const Place& end) {
  if (depth < depth_ || (depth == depth_ && begin <= place_ && place_ <= end)) forget();
}

void LoopWatch::start(std::size_t depth, std::size_t level, const Place& to) {
  if (work_ >= next_) {
    until_ = 2 * work_;  // as long as all before, which may be few passes of a long loop
    next_ = 4 * work_;   // watching takes time
  }
  on_ = work_ <= until_;
  depth_ = depth;
  level_ = level;
  place_ = to;
  returns_ = 0;
  deciding_.clear();
  state_decides_ = false;
  made_of_.clear();
  made_of_state_.clear();
  before_.clear();
}

bool LoopWatch::comes_back(std::size_t depth, std::size_t level, const Place& to,
                           const State& state) {
  if (!on_) {
    if (work_ >= next_ || work_ <= until_) start(depth, level, to);
    return false;
  }
  if (depth != depth_ || level != level_ || to != place_) return false;
  if (is_unchanged(state)) ++returns_;
  return returns_ >= kReturns;
}

// Adds to `out` all that the variables of `from` were computed from. False: a state of the control
// is among it.
bool LoopWatch::followed(const std::set<VariableKey>& from, std::set<VariableKey>& out) const {
  std::vector<VariableKey> open(from.begin(), from.end());
  while (!open.empty()) {
    const VariableKey variable = std::move(open.back());
    open.pop_back();
    if (!out.insert(variable).second) continue;
    if (made_of_state_.contains(variable)) return false;
    if (const auto made = made_of_.find(variable); made != made_of_.end())
      open.insert(open.end(), made->second.begin(), made->second.end());
  }
  return true;
}

// The variables of deeper calls begin anew with each call.
bool LoopWatch::is_unchanged(const State& state) const {
  std::set<VariableKey> all;
  if (state_decides_ || !followed(deciding_, all)) return false;
  return std::all_of(all.begin(), all.end(), [&](const VariableKey& variable) {
    const auto before = before_.find(variable);
    return variable.level > level_ || before == before_.end() || state(variable) == before->second;
  });
}

}  // namespace mrsim
