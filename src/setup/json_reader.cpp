#include "setup/json_reader.h"

#include "core/process/error.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace mrsim {
namespace {

constexpr int kDeepest = 40;

}  // namespace

void fail_library(const std::string& name, const std::string& what) {
  throw Error("tools-value", fmt::format("{}: {}", name, what));
}

Json parse_json(std::string_view text, const std::string& name) {
  const auto bounded = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest)
      throw Error("tools-syntax", fmt::format("{}: nests deeper than {}", name, kDeepest));
    return true;
  };
  try {
    return Json::parse(text, bounded);
  } catch (const Json::exception& error) {
    throw Error("tools-syntax", fmt::format("{} is no JSON: {}", name, error.what()));
  }
}

const Json& json_at(const Json& value, const char* key) {
  static const Json kNothing;
  if (!value.is_object()) return kNothing;
  const auto at = value.find(key);
  return at == value.end() ? kNothing : *at;
}

std::optional<double> json_number(const Json& value, const char* key) {
  const Json& member = json_at(value, key);
  if (!member.is_number()) return std::nullopt;
  const double number = member.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string json_text(const Json& value, const char* key) {
  const Json& member = json_at(value, key);
  return member.is_string() ? member.get<std::string>() : std::string();
}

std::string json_id(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer() && value.get<long>() >= 0) return std::to_string(value.get<long>());
  return "";
}

}  // namespace mrsim
