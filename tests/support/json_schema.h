// Checks JSON against a schema of docs/schema. Knows the words that these schemas use: type, enum,
// const, anyOf, properties, required, additionalProperties, items, minItems, maxItems, minimum.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mrsim::testing {

class JsonSchema {
 public:
  explicit JsonSchema(nlohmann::json schema) : schema_(std::move(schema)) {}

  /// What of the value does not fit, each fault with its place.
  std::vector<std::string> faults(const nlohmann::json& value) const {
    std::vector<std::string> found;
    check(value, schema_, "", found);
    return found;
  }

 private:
  using Json = nlohmann::json;
  using Faults = std::vector<std::string>;

  static bool is_type(const Json& value, const std::string& name) {
    if (name == "number") return value.is_number();
    if (name == "integer") return value.is_number_integer();
    if (name == "string") return value.is_string();
    if (name == "boolean") return value.is_boolean();
    if (name == "object") return value.is_object();
    if (name == "array") return value.is_array();
    return name == "null" && value.is_null();
  }

  static bool has_type(const Json& value, const Json& types) {
    if (types.is_string()) return is_type(value, types);
    return std::any_of(types.begin(), types.end(),
                       [&](const Json& type) { return is_type(value, type); });
  }

  static void check(const Json& value, const Json& schema, const std::string& place,
                    Faults& found) {
    const std::string shown = place + ": " + value.dump().substr(0, 200);
    for (const auto& [word, given] : schema.items()) {
      if (word == "type") {
        if (!has_type(value, given)) found.push_back(shown + " is not of type " + given.dump());
      } else if (word == "enum") {
        if (std::find(given.begin(), given.end(), value) == given.end())
          found.push_back(shown + " is none of " + given.dump());
      } else if (word == "const") {
        if (value != given) found.push_back(shown + " is not " + given.dump());
      } else if (word == "anyOf") {
        check_choices(value, given, shown, found);
      } else if (word == "minimum") {
        if (value.is_number() && value < given) found.push_back(shown + " is too small");
      } else if (word == "properties" || word == "required" || word == "additionalProperties") {
        if (value.is_object()) check_keys(value, schema, word, place, found);
      } else if (word == "items" || word == "minItems" || word == "maxItems") {
        if (value.is_array()) check_items(value, word, given, place, found);
      } else if (word != "$schema" && word != "title") {
        found.push_back(place + ": the schema's word " + word + " is unknown here");
      }
    }
  }

  static void check_choices(const Json& value, const Json& choices, const std::string& shown,
                            Faults& found) {
    const bool fits = std::any_of(choices.begin(), choices.end(), [&](const Json& choice) {
      Faults of_choice;
      check(value, choice, "", of_choice);
      return of_choice.empty();
    });
    if (!fits) found.push_back(shown + " fits no choice");
  }

  static void check_keys(const Json& value, const Json& schema, const std::string& word,
                         const std::string& place, Faults& found) {
    if (word == "required") {
      for (const Json& key : schema["required"])
        if (!value.contains(key.get<std::string>()))
          found.push_back(place + ": " + key.get<std::string>() + " is missing");
      return;
    }
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, item] : value.items()) {
      const bool is_named = properties.contains(key);
      if (is_named && word == "properties")
        check(item, properties[key], place + "/" + key, found);
      else if (!is_named && word == "additionalProperties" && schema[word] == false)
        found.push_back(place + ": " + key + " is not expected");
      else if (!is_named && word == "additionalProperties" && schema[word].is_object())
        check(item, schema[word], place + "/" + key, found);
    }
  }

  static void check_items(const Json& value, const std::string& word, const Json& given,
                          const std::string& place, Faults& found) {
    if (word == "items") {
      for (std::size_t i = 0; i < value.size(); ++i)
        check(value[i], given, place + "/" + std::to_string(i), found);
    } else if (word == "minItems" ? value.size() < given : value.size() > given) {
      found.push_back(place + ": " + std::to_string(value.size()) + " items");
    }
  }

  Json schema_;
};

}  // namespace mrsim::testing
