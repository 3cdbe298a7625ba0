// Ctrl-C and SIGTERM: the run ends in order where it can, and within a second in any case.
#pragma once

#include <functional>

namespace mrsim::cli {

/// Takes SIGINT and SIGTERM from now on. Once one has come, stop_code() returns it; a run that has
/// not ended within 0.2 s, or a second signal, ends the process with that code. Nothing is lost by
/// that: drafts have no names, and what is just being published is settled by the next run. SIGPIPE
/// is blocked: writing to a pipe without a reader fails. Call it before the process has other
/// threads.
void watch_signals();

/// 130 (SIGINT), 143 (SIGTERM) or 129 (SIGHUP) once the user has asked for the end, else 0.
int stop_code();

/// `say` prints what is left of the run where the process is ended before its time; it is
/// called from another thread, once. Empty: nothing is printed.
void set_last_words(std::function<void(int code)> say);

/// To be called once all outputs are written: they stay, and a stop after this says no more than
/// that.
void all_is_written();

}  // namespace mrsim::cli
