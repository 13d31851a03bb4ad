#include "model/soils/softening_scales.hpp"

#include "support/simulations.hpp"

namespace softening_scales_test {

TEST(SofteningScales, SoilSoftensPointByPointWithoutALengthOrAReferenceWidth)
{
  Case c = column("mpm_gp", 0.5);
  EXPECT_TRUE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.length = 0.6;
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.length = 0.0;
  c.materials[0].softening.reference_width = 0.5;
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
  c.materials[0].softening.reference_width = 0.0;
  const MaterialType& law = *find_material("tresca_softening");
  const auto of = [&](std::string_view name) -> Real& {
    const auto found = std::ranges::find(law.parameters, name, &ParameterInfo::name);
    return c.materials[0].parameters[static_cast<std::size_t>(found - law.parameters.begin())];
  };
  of("su_residual") = of("su_peak");  // its strength stays
  EXPECT_FALSE(softens_point_by_point(build_model(c, 1)));
}

}  // namespace softening_scales_test
