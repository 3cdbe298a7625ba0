// Applies one operator or one function to values. Angles are in degrees.
// Guarantees the same bits on every machine (core/numbers/trig.h, core/numbers/exponential.h).
#pragma once

#include "interp/language/rules.h"
#include "interp/language/value.h"

#include <span>
#include <string>
#include <utility>

namespace mrsim {

/// Sets `left` to `left` op `right`. False: `why` says what is wrong (a sentence without a place).
/// Requires: no operand is vacant.
bool apply_operator(const ExpressionRules& rules, Operator op, Value& left, const Value& right,
                    std::string& why);

/// Sets `out` to the function of `arguments`. `round_step`: what ROUND rounds to. Functions of
/// frames and EXISTS are not for this, because their arguments are no values.
bool apply_function(const ExpressionRules& rules, Function function,
                    std::span<const Value> arguments, double round_step, Value& out,
                    std::string& why);

/// Sets `why` and returns false.
inline bool fail(std::string& why, std::string text) {
  why = std::move(text);
  return false;
}

/// Nearest whole number, halves away from 0.
double nearest_whole(double x);

/// The value as the user is shown it.
std::string value_shown(const Value& value);

/// A number as text, as SINUMERIK's << and messages write it.
std::string value_text(double value);

}  // namespace mrsim
