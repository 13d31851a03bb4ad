// Stands in for openturns.cpp in a build without OpenTURNS.

#include "input/case_file.hpp"
#include "study/reliability.hpp"

namespace terp {

bool has_openturns() { return false; }

ReliabilityResult find_probability(const ReliabilityRule& rule, const LimitState&)
{
  throw CaseError("error: `" + std::string(info_of(rule.kind).name) +
                  "` needs OpenTURNS, which this terp was built without\n  Install it with `tools/install-dependencies "
                  "--study`, or libopenturns-dev of Debian, and build again.\n");
}

}  // namespace terp
