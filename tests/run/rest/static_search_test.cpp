#include "run/rest/static_search.hpp"
#include "model/parts/reduce.hpp"
#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

namespace static_search_test {

/// The column on a fixed base, of which the strength is so many times what it needs.
Case standing_column(const char* scheme, Real strength)
{
  Case c = column_without_softening(scheme, 0.25);
  c.sides[2].kind = SideKind::fixed;
  c.materials = {clay({.su_peak = strength * 8.0e3, .su_residual = strength * 8.0e3})};
  c.initial.stress = InitialStress::equilibrium;
  return c;
}

struct Found {
  StaticEnd end;
  std::int64_t n_iterations = 0;
};

Found search(Simulation& s)
{
  Found found{};
  found.end = search_statically(s.model, s.state, s.work, std::atomic<bool>{false}, {}, found.n_iterations);
  return found;
}

/// Root mean square of the difference of the shear stress, over that of the first.
Real difference_in_shear(const State& a, const State& b)
{
  const auto points = points_by_id(a), others = points_by_id(b);
  Real square = 0.0, of_a = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k)
    square += std::pow(points[k].sigma[3] - others[k].sigma[3], 2), of_a += std::pow(points[k].sigma[3], 2);
  return std::sqrt(square / of_a);
}

TEST(StaticSearch, ElasticSoilTakesOneIterationForEachPart)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Case c = confined_box(InitialStress::equilibrium);
    c.scheme = scheme;
    Simulation s(c);
    const Found found = search(s);
    EXPECT_EQ(found.end, StaticEnd::rests);
    EXPECT_LT(found.n_iterations, 60) << scheme;
    s.step();
    EXPECT_LE(s.work.unbalanced_ratio, 2e-4) << scheme;
  }
}

TEST(StaticSearch, ThePointsStayWhereTheyAre)
{
  Simulation drawn(standing_column("mpm_gp", 1.5)), s(standing_column("mpm_gp", 1.5));
  ASSERT_EQ(search(s).end, StaticEnd::rests);
  const auto before = points_by_id(drawn.state), after = points_by_id(s.state);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(after[k].x, before[k].x);
    EXPECT_EQ(after[k].v, before[k].v);
  }
}

/// Soil that yields depends on its path (decision 0082); means of MPM-Mixed over many steps do a little.
TEST(StaticSearch, FindsTheStressOfElasticSoilThatMotionFinds)
{
  for (const auto& [scheme, most] : {std::pair{"mpm_gp", 1e-3}, std::pair{"mpm_mixed", 0.02}}) {
    Case c = stiffen(standing_column(scheme, 20.0), 1000.0);  // it keeps its shape in motion
    c.method.shares = Shares::overlap;  // else points on the border of a sub-cell move into another one
    Simulation s(c), t(c);
    ASSERT_EQ(search(s).end, StaticEnd::rests) << scheme;
    ASSERT_TRUE(settle_in_motion(t.model, t.state, t.work, 1000.0, std::atomic<bool>{false}).reached) << scheme;
    EXPECT_LT(difference_in_shear(t.state, s.state), most) << scheme;
  }
}

/// A layer on an incline, of which the base carries so many times what rest needs.
Case layer_on_an_incline(SideKind contact, Real strength)
{
  Case c = confined_box(InitialStress::equilibrium);
  const Real along = 3.0, needed = 2000.0 * along * 1.5;
  c.forces.gravity[0] = along;
  c.sides[2].kind = contact;
  c.sides[2].adhesion = strength * needed;
  return c;
}

TEST(StaticSearch, ABaseThatAdheresCarriesTheSoilAlongItself)
{
  for (const SideKind contact : {SideKind::contact_bilateral, SideKind::contact_separating}) {
    Simulation fixed(layer_on_an_incline(SideKind::fixed, 0.0)), s(layer_on_an_incline(contact, 10.0));
    ASSERT_EQ(search(fixed).end, StaticEnd::rests);
    ASSERT_EQ(search(s).end, StaticEnd::rests);
    EXPECT_LT(difference_in_shear(fixed.state, s.state), 1e-3);
  }
  Simulation fixed(layer_on_an_incline(SideKind::fixed, 0.0)),
      weak(layer_on_an_incline(SideKind::contact_bilateral, 0.1));
  ASSERT_EQ(search(fixed).end, StaticEnd::rests);
  ASSERT_EQ(search(weak).end, StaticEnd::rests) << "the wall takes what the base does not carry";
  EXPECT_GT(difference_in_shear(fixed.state, weak.state), 0.1);
}

TEST(StaticSearch, GivesUpWhereTheSoilFailsAndLeavesItAsItWas)
{
  Simulation drawn(standing_column("mpm_gp", 0.7)), s(standing_column("mpm_gp", 0.7));
  const Found found = search(s);
  EXPECT_EQ(found.end, StaticEnd::unknown);
  EXPECT_LT(found.n_iterations, 400);
  const auto before = points_by_id(drawn.state), after = points_by_id(s.state);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(after[k].sigma, before[k].sigma);
}

TEST(StaticSearch, GivesUpWhereAForceIsNoNumber)
{
  Simulation s(standing_column("mpm_gp", 1.5));
  for_each_block(s.state.points, [&](const PointBlock<2>& block) { block.row(Rows::sigma)[0] = NAN; });
  EXPECT_EQ(search(s).end, StaticEnd::unknown);
}

TEST(StaticSearch, HasTheSameBitsOnAnyNumberOfThreads)
{
  const Case c = standing_column("mpm_gp", 1.2);
  Simulation one(c, 1), three(c, 3);
  ASSERT_EQ(search(one).end, StaticEnd::rests);
  ASSERT_EQ(search(three).end, StaticEnd::rests);
  const auto a = points_by_id(one.state), b = points_by_id(three.state);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].sigma, b[k].sigma);
}

TEST(StaticSearch, EndsWhereItIsStopped)
{
  Simulation s(standing_column("mpm_gp", 1.2));
  std::int64_t n = 0;
  EXPECT_EQ(search_statically(s.model, s.state, s.work, std::atomic<bool>{true}, {}, n), StaticEnd::stopped);
}

}  // namespace static_search_test
