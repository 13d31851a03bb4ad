#include "mpm/features/search.hpp"

#include "mpm/features/feature.hpp"

namespace terp {

SearchScratch& begin_search(Real damping_local, Workspace& work)
{
  const std::vector<Vec<2>> none(work.node.size(), Vec<2>{0.0, 0.0});
  return work.with.search.set({.held = none, .last = none, .damping_local = damping_local});
}

TERP_FEATURE_DEFINITION(search)

}  // namespace terp
