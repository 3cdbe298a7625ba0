// The three streams that a program is started with, as its caller may leave them: closed, full,
// cut.
#pragma once

#include <string>

namespace mrsim::cli {

/// Opens those of the descriptors 0 to 2 that are closed, so that no file of a run gets their
/// numbers and with them what is printed. Reading and writing them fail as before.
void keep_standard_streams();

/// Text to the standard output. Where its reader has gone, the program ends by SIGPIPE, without its
/// temporary files; so do the next two.
void print(const std::string& text);
/// Flushes it: a full disk or a closed stream is an Error, not a short answer. Returns `code`.
int finish_output(int code);

/// Text to the standard error, beside the work: that nobody hears it is no fault of the run.
void say(const std::string& text);

}  // namespace mrsim::cli
