#include "system/build_id.hpp"

namespace terp {

/// A study then tries one of its realisations again, instead of trusting an equal build.
std::string build_id() { return "unknown"; }

}  // namespace terp
