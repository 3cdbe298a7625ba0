// Findings as a person reads them: "file:line:column: error: text [code]", the line, a caret.
#pragma once

#include <mrsim/types.h>

#include <string>

namespace mrsim::cli {

/// The finding as text that ends with a line end. The line of the file and a caret follow errors
/// and warnings; tabs stay tabs, so that the caret stands right in any terminal.
std::string format_diagnostic(const Diagnostic& diagnostic, bool colours);

/// A fault that has no place in a file: "mrsim: error: text [code]".
std::string format_error(const std::string& text, const std::string& code, bool colours);

}  // namespace mrsim::cli
