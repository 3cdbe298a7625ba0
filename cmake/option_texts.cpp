// Fills the manual and the completion of bash from the table of options, when mrsim is built:
//   option_texts manual|completion TEMPLATE FILE VERSION
#include "core/words/option_table.h"

#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace {

using mrsim::OptionGroup;
using mrsim::OptionRow;
using mrsim::OptionValue;

struct Command {
  std::string_view word;
  unsigned uses;
};
// `view` takes the options of a run; the last one stands for a run itself.
constexpr Command kCommands[] = {{"trace", mrsim::kUseTrace},
                                 {"check", mrsim::kUseCheck},
                                 {"compare", mrsim::kUseCompare},
                                 {"render", mrsim::kUseRender | mrsim::kUseFilm},
                                 {"rest", mrsim::kUseRest},
                                 {"tools", mrsim::kUseTools},
                                 {"view", mrsim::kUseRun | mrsim::kUseView},
                                 {"*", mrsim::kUseRun}};

// Dashes as they are typed, not as hyphens.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '-' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return text.starts_with('.') || text.starts_with('\'') ? "\\&" + out : out;
}

void write_entry(std::ostream& out, const OptionRow& row) {
  const bool valued = !row.type.empty();
  out << ".TP\n" << (valued ? ".BI " : row.letter.empty() ? ".B " : ".BR ");
  if (!row.letter.empty()) out << roff(row.letter) << (valued ? " \"\\fR, \\fP\" " : " \", \" ");
  out << roff(row.name);
  if (valued) out << " \" " << row.type << '"';
  out << '\n' << roff(row.manual.empty() ? row.help : row.manual) << '\n';
}

// Each name once, where it stands first.
void write_manual(std::ostream& out) {
  std::set<std::string_view> told;
  for (const OptionGroup group :
       {OptionGroup::stock, OptionGroup::cutting, OptionGroup::comparison, OptionGroup::program,
        OptionGroup::picture, OptionGroup::output}) {
    out << ".SS " << mrsim::group_title(group) << '\n';
    for (const OptionRow& row : mrsim::option_table())
      if (row.group == group && mrsim::find_option(row.name) == &row &&
          told.insert(row.name).second)
        write_entry(out, row);
  }
}

// What may follow an option; files follow where nothing is said.
void write_values(std::ostream& out) {
  std::set<std::string_view> told;
  for (const OptionRow& row : mrsim::option_table()) {
    const bool folders = row.value == OptionValue::folders;
    if ((row.words.empty() && !folders) || !told.insert(row.name).second) continue;
    const bool files = row.value == OptionValue::stock || row.value == OptionValue::path_or_off;
    out << "    " << row.name << ") mapfile -t COMPREPLY < <(compgen ";
    if (folders)
      out << "-d";
    else
      out << "-W \"" << row.words << '"' << (files ? " -f" : "");
    out << " -- \"$current\"); return ;;\n";
  }
}

void write_options(std::ostream& out) {
  for (const Command& command : kCommands) {
    out << "      " << command.word << ") options=\"";
    std::set<std::string_view> told;
    for (const OptionRow& row : mrsim::option_table())
      if ((row.uses & command.uses) != 0 && told.insert(row.name).second)
        out << (told.size() > 1 ? " " : "") << row.name;
    out << "\" ;;\n";
  }
}

std::string command_words() {
  std::string out;
  for (const Command& command : kCommands)
    if (command.word != "*") out += (out.empty() ? "" : " ") + std::string(command.word);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const bool manual = std::string_view(argv[1]) == "manual";
  std::ifstream in(argv[2]);
  std::ofstream out(argv[3]);
  const std::pair<std::string_view, std::string> fields[] = {{"@COMMANDS@", command_words()},
                                                             {"@VERSION@", argv[4]}};
  for (std::string line; std::getline(in, line);) {
    if (line == "@OPTIONS@") {
      manual ? write_manual(out) : write_options(out);
    } else if (line == "@VALUES@") {
      write_values(out);
    } else {
      for (const auto& [field, text] : fields)
        if (const auto at = line.find(field); at != line.npos) line.replace(at, field.size(), text);
      out << line << '\n';
    }
  }
  return in.eof() && out.flush() ? 0 : 1;
}
