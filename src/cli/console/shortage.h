// Errors for runs to which the system gives too little memory or too few threads.
#pragma once

#include <exception>

namespace mrsim::cli {

/// An error of the user's machine or limits, exit 1.
struct Shortage {
  const char* code;
  const char* text;
};

/// The shortage that `error` stands for; null where it is another fault.
const Shortage* find_shortage(const std::exception& error);

/// From now on a shortage that no caller can catch ends the process with exit 1 and an error:
/// libraries start threads while they are loaded (log4cplus of OpenVDB) or on threads of their own
/// (TBB). Other calls of std::terminate end as before.
void catch_shortages();

/// Throws Error "memory" where the stack may not grow to a megabyte (ulimit -s): once it is used
/// up no error can be printed.
void require_stack();

}  // namespace mrsim::cli
