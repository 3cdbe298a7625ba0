// The built viewer, compiled in from web/dist/report.html by cmake/embed_text.cmake.
#pragma once

#include <string_view>

namespace mrsim {

std::string_view report_template();

}  // namespace mrsim
