// The number, index and size types that all layers use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace terp {

using Real = double;
using Index = std::int32_t;

/// Independent components of a symmetric tensor: xx yy zz xy (yz zx). Plane strain keeps zz.
template <int Dim>
inline constexpr int n_sym = Dim == 2 ? 4 : 6;

template <int Dim>
using Vec = std::array<Real, Dim>;

}  // namespace terp
