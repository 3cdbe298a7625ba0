#include "compare/report/packed.h"

#include "core/text/base64.h"
#include "core/text/zip.h"

namespace mrsim {

nlohmann::ordered_json packed_bytes(std::string_view bytes) {
  return {{"z", base64(detail::deflated(bytes))}};
}

}  // namespace mrsim
