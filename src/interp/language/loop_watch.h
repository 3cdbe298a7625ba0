// Finds loops that can never end, long before the limit of steps. While a part of the run is
// watched, it notes which variables decide which block comes next, what these are computed from,
// and which of them change. If the same loop comes back again and again and none of them has
// changed, all further passes are alike. Variables that only shape the tool's path may change.
// Guarantees: a loop that ends is never taken for an endless one, as long as its way depends on
// variables alone; whoever decides by anything else says forget(). Does not find loops whose
// counter runs away from its bound. Private to src/interp.
#pragma once

#include "interp/language/program_outline.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mrsim {

/// A variable, by number or by name.
struct VariableKey {
  std::size_t level = 0;  ///< 0: common to all levels; else the level of calls, from 1 on
  double number = -1;
  std::string name;  ///< of a variable without a number
  friend auto operator<=>(const VariableKey&, const VariableKey&) = default;
};

class LoopWatch {
 public:
  /// What a variable holds, as text. Nothing: too much to be compared.
  using State = std::function<std::optional<std::string>(const VariableKey&)>;

  /// A block begins, or has made `count` motions.
  void begin_block();
  void count_work(std::uint64_t count) { work_ += count; }

  bool is_on() const { return on_; }
  /// The block reads a variable, which decides about the program's way unless set_data(true) holds.
  void read(const VariableKey& variable);
  /// The block reads a state of the control, which may change without an assignment.
  void read_state();
  bool knows_change_of(const VariableKey& variable) const { return before_.contains(variable); }
  /// The block sets a variable. `before`: its value until then, of which the first one is kept.
  void write(const VariableKey& variable, const std::optional<std::string>& before);

  /// A variable is defined at this level of calls.
  void define(std::size_t level) {
    if (level <= level_) forget();
  }

  /// What the block has read so far decides about the way too, and not only as data.
  void decide();
  /// The next reads are the data of words or assignments until this returns to false.
  bool set_data(bool data);
  /// Something changes that may decide about the way and is not a variable.
  void forget() { on_ = false; }
  /// A program or subprogram ends or runs again. `depth`: how many calls it lies inside of.
  void leave(std::size_t depth);
  /// A counter that is no variable changes, in the loop from `begin` to `end`.
  void count_pass(std::size_t depth, const Place& begin, const Place& end);

  /// A loop comes back to its begin. True: it never ends. `level` is that of the variables.
  bool comes_back(std::size_t depth, std::size_t level, const Place& to, const State& state);
  /// The variables that decide about the way of the loop, by their keys.
  const std::set<VariableKey>& deciding() const { return deciding_; }

 private:
  void start(std::size_t depth, std::size_t level, const Place& to);
  bool is_unchanged(const State& state) const;
  bool followed(const std::set<VariableKey>& from, std::set<VariableKey>& out) const;

  std::uint64_t work_ = 0, next_ = 20'000, until_ = 0;
  bool on_ = false, data_ = false;
  std::size_t depth_ = 0, level_ = 0;
  Place place_;
  int returns_ = 0;              ///< times the loop came back with nothing changed
  std::set<VariableKey> block_;  ///< data that the block has read
  bool block_reads_state_ = false;
  std::set<VariableKey> deciding_;
  bool state_decides_ = false;
  std::map<VariableKey, std::set<VariableKey>> made_of_;
  std::set<VariableKey> made_of_state_;
  std::map<VariableKey, std::string> before_;
};

/// While it lives, the variables that are read count as data; with `data` false, as deciding.
class DataReads {
 public:
  explicit DataReads(LoopWatch& watch, bool data = true)
      : watch_(watch), was_(watch.set_data(data)) {}
  ~DataReads() { watch_.set_data(was_); }
  DataReads(const DataReads&) = delete;
  DataReads& operator=(const DataReads&) = delete;

 private:
  LoopWatch& watch_;
  bool was_;
};

}  // namespace mrsim
