// The baseline: it locks where soil hardly changes its volume. Its pressures oscillate: tests/whole/noise_test.
#include "mpm/points/surface.hpp"
#include "support/simulations.hpp"

namespace standard_mpm_test {

/// How far the front of a column has moved after 1 s [m].
Real path_of_front(const Case& c)
{
  Simulation s(c);
  while (s.state.time < 1.0) s.step();
  return extent_in_x(*s.model.mesh, s.state.points)[1] - 8.0;
}

/// The same of a nearly incompressible one without softening.
Real path_without_softening(const char* scheme)
{
  Case c = column_without_softening(scheme);
  c.materials = {clay({.poisson_ratio = 0.499, .su_residual = 8.0e3})};
  return path_of_front(c);
}

TEST(StandardMpm, LocksInNearlyIncompressibleSoilWhereTheOthersSlide)
{
  const Real standard = path_without_softening("standard_mpm");
  for (const char* scheme : {"mpm_gp", "mpm_mixed"})
    EXPECT_GT(path_without_softening(scheme), 4.0 * standard) << scheme;
  EXPECT_GT(path_without_softening("mpm_gp"), 0.8);
}

TEST(StandardMpm, ASofteningColumnStandsOnALockedMesh)
{
  EXPECT_LT(path_of_front(column("standard_mpm")), 0.1);
  EXPECT_GT(path_of_front(column("mpm_gp")), 1.0);
}

}  // namespace standard_mpm_test
