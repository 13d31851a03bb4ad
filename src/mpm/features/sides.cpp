#include "mpm/features/sides.hpp"

#include "mpm/features/feature.hpp"

namespace terp {

TERP_FEATURE_DEFINITION(sides)

}  // namespace terp
