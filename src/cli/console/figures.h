// Numbers as text for people.
#pragma once

#include <string>

namespace mrsim::cli {

/// "58 782.63": a blank between thousands.
std::string grouped(double value, int decimals);
/// "58 783", below 100 mm^3 "58.78"
std::string small_volume(double volume);
/// "1 h 02 min", "3 min 07 s", "12.4 s"
std::string duration(double seconds);

}  // namespace mrsim::cli
