// The baseline: it locks where soil hardly changes its volume, and its pressures oscillate. Controls that can fail.
#include "events/surface.hpp"
#include "support/simulations.hpp"

namespace standard_mpm_test {

/// How far the front of a nearly incompressible column without softening has moved after 1 s [m].
Real path_of_front(const char* scheme)
{
  Case c = column_without_softening(scheme);
  c.materials = {clay({.poisson_ratio = 0.499, .su_residual = 8.0e3})};
  Simulation s(c);
  while (s.state.time < 1.0) s.step();
  return extent_in_x(*s.model.mesh, s.state.points)[1] - 8.0;
}

TEST(StandardMpm, LocksInNearlyIncompressibleSoilWhereTheOthersSlide)
{
  const Real standard = path_of_front("standard_mpm");
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) EXPECT_GT(path_of_front(scheme), 4.0 * standard) << scheme;
  EXPECT_GT(path_of_front("mpm_gp"), 0.8);
}

/// Root mean square of the pressure of points less the mean of their cell, after 0.5 s of the softening column [Pa].
Real pressure_noise(const char* scheme)
{
  Simulation s(column(scheme));
  while (s.state.time < 0.5) s.step();
  std::vector<Real> sum(s.model.mesh->cells.size()), count(s.model.mesh->cells.size());
  const auto points = points_by_id(s.state);
  const auto pressure = [](const Point& p) { return (p.sigma[0] + p.sigma[1] + p.sigma[2]) / 3.0; };
  for (const Point& p : points) {
    sum[p.cell] += pressure(p);
    count[p.cell] += 1.0;
  }
  Real square = 0.0;
  for (const Point& p : points) square += std::pow(pressure(p) - sum[p.cell] / count[p.cell], 2);
  return std::sqrt(square / static_cast<Real>(points.size()));
}

TEST(StandardMpm, ItsPressuresOscillateWithinCellsWhereThoseOfTheOthersDoNot)
{
  EXPECT_GT(pressure_noise("standard_mpm"), 1e4);  // of 40 kPa at most under this column
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) EXPECT_LT(pressure_noise(scheme), 1e3) << scheme;
}

TEST(StandardMpm, ASofteningColumnStandsOnALockedMesh)
{
  const auto path = [](const char* scheme) {
    Simulation s(column(scheme));
    while (s.state.time < 1.0) s.step();
    return extent_in_x(*s.model.mesh, s.state.points)[1] - 8.0;
  };
  EXPECT_LT(path("standard_mpm"), 0.1);
  EXPECT_GT(path("mpm_gp"), 1.0);
}

}  // namespace standard_mpm_test
