#include "interp/show/words_page.h"

#include "interp/text/code_names.h"
#include "interp/text/code_table.h"
#include "interp/text/m_codes.h"

#include <array>
#include <iterator>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr const char* kHead = R"(# The words of the controls

Made from the tables of `src/interp/text`; a test compares them with this page
(`MRSIM_WRITE_WORDS=1 build/tests/interp_test --gtest_filter=Words.*` writes it again).

**Done**: read as docs/interp.md says. **No effect on the part**: known, nothing moves by it. **Refused**: an error by
name, and no part is written. A G word that stands in no list is the error `g-unknown`; an unknown M word is a note.
)";

enum class Reading : std::uint8_t { unknown, done, no_effect, refused };

Reading reading(Code code) {
  switch (code) {
    case Code::unknown:
      return Reading::unknown;
    case Code::ignored:
    case Code::ignored_words:
    case Code::path_continuous:
    case Code::path_exact:
    case Code::path_stops:
    case Code::path_stops_once:
    case Code::high_speed:
    case Code::header:
    case Code::diameter_cycles_off:
      return Reading::no_effect;
    case Code::unsupported:
      return Reading::refused;
    default:
      return Reading::done;
  }
}

// Words separated by blanks, in lines of at most 120 characters.
class WordList {
 public:
  void add(const std::string& word) {
    if (text_.size() - line_ + word.size() + 2 > 118) {
      text_ += "\n";
      line_ = text_.size();
    } else if (!text_.empty()) {
      text_ += ", ";
    }
    text_ += word;
    if (text_.empty()) line_ = 0;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t line_ = 0;
};

using Lists = std::array<WordList, 4>;

std::string titled(const Lists& lists) {
  static constexpr const char* kTitles[] = {"", "Done", "No effect on the part", "Refused"};
  std::string out;
  for (std::size_t i = 1; i < lists.size(); ++i)
    if (!lists[i].text().empty()) out += fmt::format("\n**{}**\n{}\n", kTitles[i], lists[i].text());
  return out;
}

std::string g_words(Dialect dialect, MachineKind machine) {
  Lists lists;
  for (int number = 0; number < 10000; ++number) {
    const CodeEntry entry = find_g_code(dialect, machine, number);
    const bool macro = entry.code == Code::statement && dialect == Dialect::iso && number >= 650;
    const Reading r = macro ? Reading::refused : reading(entry.code);
    std::string word = fmt::format("G{:g}", number / 10.0);
    const std::string_view what = r == Reading::refused ? unsupported_code(dialect, number) : "";
    if (!what.empty()) word += fmt::format(" ({})", what);
    // Among the drilling cycles, G87 bores upwards, and G88 of LinuxCNC waits for the operator.
    const bool back = entry.code == Code::drill_cycle &&
                      (number == 870 || (number == 880 && dialect == Dialect::ngc));
    lists[static_cast<std::size_t>(back ? Reading::refused : r)].add(word);
  }
  return titled(lists);
}

std::string names() {
  Lists lists;
  for (const auto& [name, entry] : function_names())
    lists[static_cast<std::size_t>(reading(entry.code))].add(std::string(name));
  return titled(lists);
}

struct Controls {
  const char* name;
  Dialect dialect;
  MachineKind machine;
};
constexpr Controls kControls[] = {{"SINUMERIK", Dialect::sinumerik, MachineKind::mill},
                                  {"SINUMERIK, lathe", Dialect::sinumerik, MachineKind::lathe},
                                  {"FANUC", Dialect::fanuc, MachineKind::mill},
                                  {"FANUC, lathe", Dialect::fanuc, MachineKind::lathe},
                                  {"ISO", Dialect::iso, MachineKind::mill},
                                  {"CODESYS", Dialect::codesys, MachineKind::mill},
                                  {"LinuxCNC", Dialect::ngc, MachineKind::mill}};

// Each word with its effect, and its controls if it is not one of all controls.
std::string m_words() {
  std::string out = "\n| word | event | controls |\n|---|---|---|\n";
  for (int number = 0; number < 100; ++number) {
    std::string_view what;
    std::string who;
    std::size_t count = 0;
    for (const Controls& control : kControls) {
      const std::string_view text =
          m_code_text(find_m_code(control.dialect, control.machine, number));
      if (text.empty()) continue;
      what = text;
      who += fmt::format("{}{}", who.empty() ? "" : "; ", control.name);
      ++count;
    }
    if (count > 0)
      out += fmt::format("| M{} | {} | {} |\n", number, what,
                         count == std::size(kControls) ? "all" : who);
  }
  return out;
}

}  // namespace

std::string words_page() {
  constexpr auto mill = MachineKind::mill, lathe = MachineKind::lathe;
  std::string page = kHead;
  page += "\n## SINUMERIK\n" + g_words(Dialect::sinumerik, mill) + "\n### Names\n" + names();
  page += "\n## FANUC, mill\n" + g_words(Dialect::fanuc, mill);
  page += "\n## FANUC, lathe\n" + g_words(Dialect::fanuc, lathe);
  page += "\n## ISO\n" + g_words(Dialect::iso, mill);
  page += "\n## CODESYS\n" + g_words(Dialect::codesys, mill);
  page += "\n## LinuxCNC\n" + g_words(Dialect::ngc, mill);
  page += "\n## M words that are events\n" + m_words();
  return page;
}

}  // namespace mrsim
