// The built viewer, compiled in from web/dist/report.html by cmake/embed_text.cmake.
#pragma once

#include <string_view>

namespace mrsim {

/// The page of a report as HTML, with marks where the data go.
std::string_view report_template();

}  // namespace mrsim
