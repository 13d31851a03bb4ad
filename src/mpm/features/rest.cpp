#include "mpm/features/rest.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {

void watch_speed(bool watches, Workspace& work)
{
  if (watches)
    work.with.rest.made();
  else
    work.with.rest.clear();
}

Real fastest_node(const Workspace& work) { return (work.with.rest ? *work.with.rest : RestScratch{}).fastest_node; }

TERP_FEATURE_DEFINITION(rest)

}  // namespace terp
