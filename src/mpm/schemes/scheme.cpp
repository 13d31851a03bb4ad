#include "mpm/schemes/scheme.hpp"

#include "os/instructions.hpp"

#include <algorithm>

#define TERP_KERNEL_SET(set) extern "C" const terp::SchemeList* terp_schemes_##set();
TERP_KERNEL_SETS
#undef TERP_KERNEL_SET

namespace terp {

SchemeList schemes_of_set(std::size_t set)
{
  const SchemeList* const copies[] = {
#define TERP_KERNEL_SET(set) terp_schemes_##set(),
      TERP_KERNEL_SETS
#undef TERP_KERNEL_SET
  };
  return *copies[set];
}

SchemeList all_schemes() { return schemes_of_set(chosen_set()); }

const Scheme* find_scheme(std::string_view name)
{
  for (const Scheme* scheme : all_schemes())
    if (scheme->name == name) return scheme;
  return nullptr;
}

bool looks_at(const Scheme& scheme, std::string_view option)
{
  std::string_view left = scheme.unused_options;
  while (!left.empty()) {
    const std::size_t end = std::min(left.find(' '), left.size());
    if (left.substr(0, end) == option) return false;
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return true;
}

}  // namespace terp
