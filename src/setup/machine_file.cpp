#include "setup/machine_file.h"

#include "core/numbers/vec.h"
#include "core/process/error.h"
#include "core/text/text_io.h"
#include "core/words/suggest.h"
#include "setup/toml_text.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

namespace mrsim {
namespace {

constexpr std::size_t kMachineFileLimit = std::size_t(1) << 20;
// Speeds and accelerations, in the units of MachineData: what is above 0, and no slip of the
// keyboard.
constexpr double kLeastRate = 1e-3, kLargestRate = 1e7;

// A key with one number, and the least that it may be.
struct NumberKey {
  std::string_view name;
  double MachineData::*value;
  double least;
};
constexpr std::array kNumbers = {
    NumberKey{"tool_change", &MachineData::tool_change, 0},
    NumberKey{"spindle_acceleration", &MachineData::spindle_acceleration, kLeastRate},
    NumberKey{"max_spindle", &MachineData::max_spindle, kLeastRate},
    NumberKey{"corner_tolerance", &MachineData::corner_tolerance, 0},
};
// A key with a number for each axis, above 0.
struct AxesKey {
  std::string_view name;
  Vec3 MachineData::*value;
};
constexpr std::array kAxes = {
    AxesKey{"rapid", &MachineData::rapid},
    AxesKey{"acceleration", &MachineData::acceleration},
};
// Places of the machine.
constexpr std::string_view kZero = "zero", kReference = "reference", kSecond = "second";
constexpr std::string_view kLimits = "limits", kKind = "kind";

class MachineReader {
 public:
  MachineReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  MachineData read() {
    toml::table root;
    try {
      root = parse_toml(text_);
    } catch (const toml::parse_error& error) {
      fail(error.source().begin, "machine-syntax", std::string(error.description()));
    }
    const toml::table* table = root["machine"].as_table();
    if (table == nullptr)
      fail({1, 1}, "machine-missing", "there is no table [machine] in this file");
    MachineData machine;
    machine.origin = name_;
    for (const auto& [key, node] : *table) read_key(machine, key, node);
    return machine;
  }

 private:
  [[noreturn]] void fail(const toml::source_position& at, const char* code,
                         const std::string& what) const {
    fail_at(at, text_, name_, code, what);
  }
  double number(std::string_view key, const toml::node& node, double least) const {
    const std::optional<double> value = node.value<double>();
    if (!node.is_number() || !value || !(*value >= least && *value <= kLargestRate))
      fail(node.source().begin, "machine-value",
           fmt::format("{} must be a number from {:g} to {:g}", key, least, kLargestRate));
    return *value;
  }
  Vec3 axes(std::string_view key, const toml::node& node) const {
    const toml::array* row = node.as_array();
    if (row == nullptr) {
      const double all = number(key, node, kLeastRate);
      return {all, all, all};
    }
    if (row->size() != 3)
      fail(node.source().begin, "machine-value",
           fmt::format("{} must be one number, or three: X, Y, Z", key));
    return {number(key, (*row)[0], kLeastRate), number(key, (*row)[1], kLeastRate),
            number(key, (*row)[2], kLeastRate)};
  }
  Vec3 place(std::string_view key, const toml::node& node) const {
    const toml::array* row = node.as_array();
    if (row == nullptr || row->size() != 3)
      fail(node.source().begin, "machine-value", fmt::format("{} must be three numbers", key));
    return {number(key, (*row)[0], -kLargestRate), number(key, (*row)[1], -kLargestRate),
            number(key, (*row)[2], -kLargestRate)};
  }
  // limits = { x = [-600, 0], z = [-500, 0] }; an axis without limits ends nowhere.
  Box3 limits(const toml::node& node) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const toml::table* table = node.as_table();
    if (table == nullptr)
      fail(node.source().begin, "machine-value",
           "limits must name axes: limits = { x = [-600, 0], z = [-500, 0] }");
    Box3 box{{-kNone, -kNone, -kNone}, {kNone, kNone, kNone}};
    for (const auto& [name, value] : *table) {
      const std::size_t axis = std::string_view("xyz").find(name.str());
      if (name.str().size() != 1 || axis == std::string_view::npos)
        fail(name.source().begin, "machine-key",
             fmt::format("unknown axis \"{}\" in limits: x, y and z are known", name.str()));
      const toml::array* range = value.as_array();
      if (range == nullptr || range->size() != 2)
        fail(value.source().begin, "machine-value",
             fmt::format("limits.{} must be two numbers: the least and the largest", name.str()));
      double& lo = component(box.lo, int(axis));
      double& hi = component(box.hi, int(axis));
      lo = number(name.str(), (*range)[0], -kLargestRate);
      hi = number(name.str(), (*range)[1], -kLargestRate);
      if (!(lo < hi))
        fail(value.source().begin, "machine-value",
             fmt::format("limits.{}: {:g} is not below {:g}", name.str(), lo, hi));
    }
    return box;
  }
  MachineKind kind(const toml::node& node) const {
    const std::string word = node.value_or(std::string());
    if (word == "mill") return MachineKind::mill;
    if (word == "lathe") return MachineKind::lathe;
    if (word == "auto") return MachineKind::automatic;
    fail(node.source().begin, "machine-value", "kind must be \"mill\", \"lathe\" or \"auto\"");
  }
  // zero.G54 = [x, y, z]
  void read_zeros(MachineData& machine, const toml::node& node) const {
    const toml::table* zeros = node.as_table();
    if (zeros == nullptr)
      fail(node.source().begin, "machine-value",
           "zero must name a work offset: zero.G54 = [x, y, z]");
    for (const auto& [name, value] : *zeros) {
      if (!is_work_offset(name.str()))
        fail(name.source().begin, "machine-key", no_offset(name.str()));
      machine.places.zero.push_back({std::string(name.str()), place(name.str(), value)});
    }
  }
  bool read_word(MachineData& machine, const toml::key& key, const toml::node& node) const {
    if (key.str() == kZero)
      read_zeros(machine, node);
    else if (key.str() == kKind)
      machine.kind = kind(node);
    else if (key.str() == kLimits)
      machine.places.limits = limits(node);
    else if (key.str() == kReference)
      machine.places.reference = place(kReference, node);
    else if (key.str() == kSecond)
      machine.places.second = place(kSecond, node);
    else
      return false;
    return true;
  }
  void read_key(MachineData& machine, const toml::key& key, const toml::node& node) const {
    for (const NumberKey& known : kNumbers)
      if (key.str() == known.name) {
        machine.*known.value = number(key.str(), node, known.least);
        return;
      }
    for (const AxesKey& known : kAxes)
      if (key.str() == known.name) {
        machine.*known.value = axes(key.str(), node);
        return;
      }
    if (!read_word(machine, key, node)) fail_unknown(key);
  }
  [[noreturn]] void fail_unknown(const toml::key& key) const {
    std::vector<std::string_view> known = {kKind, kZero, kReference, kSecond, kLimits};
    for (const NumberKey& k : kNumbers) known.push_back(k.name);
    for (const AxesKey& k : kAxes) known.push_back(k.name);
    std::string hint = suggestion(key.str(), known);
    if (hint.empty()) hint = fmt::format("; known here: {}", fmt::join(known, " "));
    fail(key.source().begin, "machine-key",
         fmt::format("unknown key \"{}\" in [machine]{}", key.str(), hint));
  }

  std::string_view text_;
  const std::string& name_;
};

}  // namespace

MachineData parse_machine(std::string_view text, const std::string& name) {
  return MachineReader(text, name).read();
}

MachineData load_machine_file(const std::string& path) {
  return parse_machine(read_file(path, kMachineFileLimit), path);
}

}  // namespace mrsim
