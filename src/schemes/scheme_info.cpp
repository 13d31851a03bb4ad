#include "schemes/scheme_info.hpp"

#include <algorithm>

namespace terp {

std::span<const SchemeInfo> all_schemes()
{
  static constexpr SchemeInfo schemes[] = {
#define TERP_SCHEME(name, Type, summary, unused_options) {#name, summary, unused_options},
#include "schemes/schemes.def"
#undef TERP_SCHEME
  };
  return schemes;
}

bool looks_at(const SchemeInfo& scheme, std::string_view option)
{
  std::string_view rest = scheme.unused_options;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == option) return false;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return true;
}

}  // namespace terp
