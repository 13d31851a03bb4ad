#include "os/build_id.hpp"

namespace terp {

std::string build_id() { return "unknown"; }

}  // namespace terp
