#include "math/errors.hpp"

#include <cstdio>
#include <cstdlib>

namespace terp {

void fail_assert(const char* condition, const char* file, int line)
{
  std::fprintf(stderr, "terp: internal error at %s:%d: %s does not hold. Please report it.\n", file, line, condition);
  std::abort();
}

}  // namespace terp
