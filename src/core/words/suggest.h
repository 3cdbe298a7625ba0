// "Did you mean": the known word nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mrsim {

/// The word of `known` that is nearest to `word`, counting inserted, dropped, changed and swapped
/// letters and ignoring capitals; empty when no word is near enough (at most one change in three
/// letters). Of equally near words the first. Cost: #known times the product of the lengths.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean \"x\"?", or the empty string.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace mrsim
