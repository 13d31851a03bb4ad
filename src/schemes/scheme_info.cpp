#include "schemes/scheme_info.hpp"

namespace terp {

std::span<const SchemeInfo> all_schemes()
{
  static constexpr SchemeInfo schemes[] = {
#define TERP_SCHEME(name, Type, summary) {#name, summary},
#include "schemes/schemes.def"
#undef TERP_SCHEME
  };
  return schemes;
}

}  // namespace terp
