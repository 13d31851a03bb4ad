// Isotropic linear elasticity: d_sigma = K tr(d_eps) I + 2 G dev(d_eps).

#include "soil/laws/elastic_constants.hpp"
#include "soil/laws/law.hpp"

namespace terp {
namespace {

template <class P>
struct LinearElastic {
  static constexpr std::string_view equations =
      "d_sigma = K tr(d_eps) I + 2 G dev(d_eps),  K = 2 G (1 + nu) / (3 (1 - 2 nu))\n";
  static constexpr std::array parameters{shear_modulus_info, poisson_ratio_info};
  static constexpr std::array<StateInfo, 0> state{};
  static constexpr std::array<DerivedInfo, 0> derived{};

  explicit LinearElastic(std::span<const P> v) : shear(v[0]), bulk(bulk_from_poisson(v[0], v[1])) {}

  template <class R, int Dim>
  R update(SymTensor<R, Dim>& sigma, std::array<R, 0>&, const SymTensor<R, Dim>& d_eps, Real) const
  {
    add_elastic_stress(sigma, d_eps, bulk, shear);
    return R(0.0);
  }

  P bulk_modulus() const { return bulk; }
  P shear_modulus() const { return shear; }

  P shear;  // G [Pa]
  P bulk;   // K [Pa]
};

}  // namespace

TERP_MATERIAL_DEFINITION(linear_elastic, LinearElastic, "isotropic linear elasticity")

}  // namespace terp
