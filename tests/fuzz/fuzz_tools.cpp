// Tool libraries of other programs, and comments about tools: any bytes give data or an Error.
#include "core/process/error.h"
#include "interp/comments/tool_comment.h"
#include "interp/comments/tool_hint.h"
#include "setup/tool_library.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    mrsim::parse_library(text, "fuzz.tools");
  } catch (const mrsim::Error&) {
  }
  mrsim::ToolHint hint = mrsim::read_tool_comment(text.substr(0, text.find('\n')));
  mrsim::merge_hint(hint, mrsim::read_tool_comment(text));
  mrsim::Tool tool;
  std::string why;
  mrsim::fill_tool(hint, 25.4, false, tool, why);
  mrsim::fill_tool(hint, 1, true, tool, why);
  return 0;
}
