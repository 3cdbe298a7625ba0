#include <mrsim/mrsim.h>
namespace mrsim {
const char* version() { return "0.1.0"; }
}
