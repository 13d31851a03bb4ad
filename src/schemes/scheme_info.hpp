// The schemes of this build by name, for input, help and listings.
// Not for: what a scheme computes (one file each beside this one).
#pragma once

#include <span>
#include <string_view>

namespace terp {

struct SchemeInfo {
  std::string_view name;            ///< as in the case file: "mpm_gp"
  std::string_view summary;         ///< one line
  std::string_view unused_options;  ///< names in MethodOptions, separated by blanks
};

/// Every scheme in this build.
std::span<const SchemeInfo> all_schemes();

/// Whether an option of [method] changes anything with this scheme.
bool looks_at(const SchemeInfo& scheme, std::string_view option);

}  // namespace terp
