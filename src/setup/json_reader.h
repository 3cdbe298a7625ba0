// JSON files of other programs: a bounded parse, and values with errors that name the place.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace mrsim {

using Json = nlohmann::json;

/// Parses `text`; nothing nests deeper than 40. Throws Error "tools-syntax" naming `name`.
Json parse_json(std::string_view text, const std::string& name);

/// Member `key` of an object, or null.
const Json& json_at(const Json& value, const char* key);
/// Member `key` as a finite number or text; nothing where it is missing or of another kind.
std::optional<double> json_number(const Json& value, const char* key);
std::string json_text(const Json& value, const char* key);

/// A tool's number or name as an id: 4, "4".
std::string json_id(const Json& value);

[[noreturn]] void fail_library(const std::string& name, const std::string& what);

}  // namespace mrsim
