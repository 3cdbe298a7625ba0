// The three streams that a program is started with, as its caller may leave them: closed, full,
// cut.
#pragma once

#include <string>

namespace mrsim::cli {

/// Opens those of the descriptors 0 to 2 that are closed. Else a file of the run would get such a
/// number, and what is printed would go into it. Reading and writing them fail as before.
void keep_standard_streams();

/// Text to the standard output. Where its reader has gone, the program ends by SIGPIPE, without its
/// temporary files; so do the next two.
void print(const std::string& text);
/// Flushes it: a full disk or a closed stream is an Error, not a short answer. Returns `code`.
int finish_output(int code);

/// Writes text to the standard error. If nobody can read it there, the run goes on.
void say(const std::string& text);

}  // namespace mrsim::cli
