// The list of schemes in one copy of the kernels: schemes, and the laws that they call, are of one copy.

#include "os/kernel_table.hpp"
#include "mpm/schemes/scheme.hpp"

namespace terp {

#define TERP_SCHEME(name) extern const Scheme scheme_##name;
#include "mpm/schemes/schemes.def"
#undef TERP_SCHEME

namespace {

constexpr const Scheme* schemes[] = {
#define TERP_SCHEME(name) &scheme_##name,
#include "mpm/schemes/schemes.def"
#undef TERP_SCHEME
};

constexpr SchemeList list{schemes};

}  // namespace
}  // namespace terp

TERP_KERNEL_TABLE(schemes, SchemeList, list)
