#include "setup/stock_spec.h"

#include "core/text/text_io.h"
#include "setup/spec_text.h"
#include "setup/tool_keys.h"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

struct Form {
  std::string_view word;
  std::string_view arguments;
  std::size_t count;
};
constexpr Form kForms[] = {{"box", "x0,y0,z0,x1,y1,z1", 6},
                           {"cylinder", "diameter,z0,z1", 3},
                           {"tube", "diameter,bore,z0,z1", 4}};

[[noreturn]] void fail(const std::string& spec, const Form& form, const std::string& what) {
  throw Error(
      "stock-spec",
      fmt::format("stock \"{}\": {}; write {}:{} in mm", spec, what, form.word, form.arguments),
      Error::Kind::usage);
}

std::vector<double> numbers_of(const std::string& spec, const Form& form) {
  std::vector<double> numbers;
  std::string_view rest = std::string_view(spec).substr(form.word.size() + 1);
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != rest.npos;
    const std::string_view word = trimmed(rest.substr(0, comma));
    if (more) rest.remove_prefix(comma + 1);
    const std::optional<double> value = parse_length(word);
    if (!value) fail(spec, form, fmt::format("\"{}\" is not a number", word));
    if (std::fabs(*value) > kLargestLength)
      fail(spec, form, fmt::format("{} is beyond {} mm", word, kLargestLength));
    numbers.push_back(*value);
  }
  if (numbers.size() != form.count)
    fail(spec, form,
         fmt::format("{} numbers are needed, there are {}", form.count, numbers.size()));
  return numbers;
}

void require_less(const std::string& spec, const Form& form, const char* low_name, double low,
                  const char* high_name, double high) {
  if (!(low < high))
    fail(spec, form,
         fmt::format("{} = {:g} must be less than {} = {:g}", low_name, low, high_name, high));
}

StockShape make_box(const std::string& spec, const Form& form) {
  const std::vector<double> n = numbers_of(spec, form);
  require_less(spec, form, "x0", n[0], "x1", n[3]);
  require_less(spec, form, "y0", n[1], "y1", n[4]);
  require_less(spec, form, "z0", n[2], "z1", n[5]);
  StockShape shape;
  shape.kind = StockShape::Kind::box;
  shape.box = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  shape.description =
      fmt::format("box {:.6g} x {:.6g} x {:.6g} mm", n[3] - n[0], n[4] - n[1], n[5] - n[2]);
  return shape;
}

StockShape make_round(const std::string& spec, const Form& form) {
  std::vector<double> n = numbers_of(spec, form);
  const bool tube = n.size() == 4;
  if (!tube) n.insert(n.begin() + 1, 0.0);
  if (!(n[0] > 0)) fail(spec, form, fmt::format("the diameter {:g} must be above 0", n[0]));
  if (tube && !(n[1] > 0))
    fail(spec, form, fmt::format("the bore {:g} must be above 0 (a solid bar is cylinder:)", n[1]));
  if (tube) require_less(spec, form, "bore", n[1], "diameter", n[0]);
  require_less(spec, form, "z0", n[2], "z1", n[3]);
  StockShape shape;
  shape.kind = tube ? StockShape::Kind::tube : StockShape::Kind::cylinder;
  shape.outer_radius = n[0] / 2;
  shape.inner_radius = n[1] / 2;
  shape.box = {{-n[0] / 2, -n[0] / 2, n[2]}, {n[0] / 2, n[0] / 2, n[3]}};
  const std::string bore = tube ? fmt::format(" / {:.6g}", n[1]) : "";
  shape.description = fmt::format("{} d {:.6g}{} x {:.6g} mm", form.word, n[0], bore, n[3] - n[2]);
  return shape;
}

// "block" of "block:0,0,-10,100,60,0"; empty: it is the name of a file.
std::string unknown_form(const std::string& spec) {
  const std::size_t colon = spec.find(':');
  if (colon == std::string::npos || colon < 2) return "";  // "C:/stock.stl"
  std::string_view rest = std::string_view(spec).substr(colon + 1);
  const std::size_t comma = rest.find(',');
  return comma != rest.npos && parse_length(trimmed(rest.substr(0, comma))) ? spec.substr(0, colon)
                                                                            : std::string();
}

}  // namespace

std::optional<StockShape> parse_stock_spec(const std::string& spec) {
  for (const Form& form : kForms) {
    if (!spec.starts_with(fmt::format("{}:", form.word))) continue;
    return form.word == "box" ? make_box(spec, form) : make_round(spec, form);
  }
  if (const std::string word = unknown_form(spec); !word.empty())
    throw Error("stock-spec",
                fmt::format("stock \"{}\": {} is no form of stock: write box:x0,y0,z0,x1,y1,z1, "
                            "cylinder:diameter,z0,z1 or tube:diameter,bore,z0,z1 in mm",
                            spec, word),
                Error::Kind::usage);
  return {};
}

}  // namespace mrsim
