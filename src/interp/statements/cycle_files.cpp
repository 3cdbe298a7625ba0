#include "interp/statements/cycle_files.h"

#include "interp/statements/proc_line.h"
#include "interp/statements/sinumerik_text.h"
#include "interp/text/code_names.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mrsim {

SubprogramName called_program(std::string name) {
  SubprogramName out;
  out.not_main = is_built_in_call(name) || !unsupported_name(name).empty();
  out.text = std::move(name);
  return out;
}

bool CycleFiles::calls_program(const std::string& name, std::string_view line, std::size_t p) {
  if (!is_built_in_call(name)) return reader_.find(called_program(name)).has_value();
  if (const auto known = replaced_.find(name); known != replaced_.end()) return known->second;
  const auto place = reader_.find(called_program(name));
  if (!place) return replaced_[name] = false;
  const auto proc = find_proc_line(*place);
  std::size_t at = proc ? proc->behind : 0;
  const bool replaces = proc && word_at(proc->line, at) == name;
  Word word;
  word.column = static_cast<int>(p);
  word.length = static_cast<int>(std::min(name.size(), line.size() - p));
  const std::string file = shown_place(*place);
  reporter_.add(Severity::note, "cycle-file",
                replaces ? fmt::format("{0} is run from {1}, which begins with PROC {0}, in place "
                                       "of the control's own {0}",
                                       name, file)
                         : fmt::format("the control's own {0} is run, not {1}: only a file that "
                                       "begins with PROC {0} replaces it",
                                       name, file),
                word);
  return replaced_[name] = replaces;
}

}  // namespace mrsim
