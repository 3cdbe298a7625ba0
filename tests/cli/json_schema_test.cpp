// The check of JSON against schemas finds what does not fit: else the tests that use it say
// nothing.
#include "run_program.h"

namespace mrsim {
namespace {

using namespace mrsim::testing;

TEST(JsonSchema, EachWordFindsWhatDoesNotFit) {
  for (const auto& [schema, good, bad] : {
           std::tuple(R"({"type": "integer"})", "3", "3.5"),
           std::tuple(R"({"type": ["number", "null"]})", "null", "true"),
           std::tuple(R"({"enum": ["a", "b"]})", R"("b")", R"("c")"),
           std::tuple(R"({"const": 1})", "1", "2"),
           std::tuple(R"({"type": "number", "minimum": 0})", "0", "-0.5"),
           std::tuple(R"({"anyOf": [{"type": "null"}, {"minimum": 3}]})", "4", "2"),
           std::tuple(R"({"required": ["x"]})", R"({"x": 1})", R"({"y": 1})"),
           std::tuple(R"({"properties": {"x": {"type": "null"}}})", R"({"y": 1})", R"({"x": 1})"),
           std::tuple(R"({"properties": {"x": {}}, "additionalProperties": false})", R"({"x": 1})",
                      R"({"x": 1, "y": 2})"),
           std::tuple(R"({"additionalProperties": {"type": "null"}})", R"({"x": null})",
                      R"({"x": 1})"),
           std::tuple(R"({"items": {"type": "string"}})", R"(["a"])", R"(["a", 1])"),
           std::tuple(R"({"minItems": 1})", "[1]", "[]"),
           std::tuple(R"({"maxItems": 1})", "[1]", "[1, 2]"),
       }) {
    const JsonSchema checked(Json::parse(schema));
    EXPECT_TRUE(checked.faults(Json::parse(good)).empty()) << schema;
    EXPECT_EQ(checked.faults(Json::parse(bad)).size(), 1U) << schema;
  }
  EXPECT_FALSE(JsonSchema(Json::parse(R"({"pattern": "x"})")).faults("x").empty());
}

}  // namespace
}  // namespace mrsim
