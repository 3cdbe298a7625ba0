// Operators and functions of texts: comparisons, << and CONCAT, STRLEN, INDEX, SUBSTR ...
#pragma once

#include "interp/language/rules.h"
#include "interp/language/value.h"

#include <span>
#include <string>

namespace mrsim {

/// Sets `left` to `left` op `right`, where one of them is a text. False: `why` says what is wrong.
bool text_operator(Operator op, Value& left, const Value& right, std::string& why);

/// Sets `out` to the function of `arguments`, of which the first is a text. False: `why` says what
/// is wrong.
bool text_function(Function function, std::span<const Value> arguments, Value& out,
                   std::string& why);

}  // namespace mrsim
