// Applies one operator or one function to values. Angles are in degrees.
// Guarantees the same bits on every machine (core/trig, core/exponential).
#pragma once

#include "interp/language/rules.h"
#include "interp/language/value.h"

#include <span>
#include <string>
#include <utility>

namespace mrsim {

/// `left` op `right` into `left`. False: `why` says what is wrong (a sentence without place).
/// Vacant operands have been dealt with by the caller.
bool apply_operator(const ExpressionRules& rules, Operator op, Value& left, const Value& right,
                    std::string& why);

/// The function of `arguments` into `out`. `round_step`: what ROUND rounds to.
/// Not for the functions of frames and EXISTS, whose arguments are no values.
bool apply_function(const ExpressionRules& rules, Function function,
                    std::span<const Value> arguments, double round_step, Value& out,
                    std::string& why);

/// Says why, and returns false.
inline bool fail(std::string& why, std::string text) {
  why = std::move(text);
  return false;
}

/// Nearest whole number, halves away from 0.
double nearest_whole(double x);

/// A value for the user.
std::string value_shown(const Value& value);

/// A number as text, as SINUMERIK's << and messages write it.
std::string value_text(double value);

}  // namespace mrsim
