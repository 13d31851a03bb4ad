#include "mpm/step/totals.hpp"
#include "mpm/step/workspace.hpp"
#include "os/instructions.hpp"
#include "mpm/step/kernels.hpp"
#include "support/simulations.hpp"

namespace totals_test {

/// A column that flows, five steps after the audit has looked.
struct Flowing : Simulation {
  explicit Flowing(const char* scheme = "mpm_gp", int threads = 1) : Simulation(column(scheme, 0.25), threads)
  {
    make_steps(*this, 400);
    memory = remember_strain(model, state);
    make_steps(*this, 5);
  }
  StrainMemory memory;
  TotalsRequest ask(const std::vector<Columns>& shear) { return {0.1, {}, shear, &memory}; }
};

const std::vector<Columns> halves{{.left = 0.0, .width = 0.5, .n = 15}, {.left = 7.5, .width = 0.5, .n = 17}};

TEST(Totals, AreSumsOverThePoints)
{
  Flowing s;
  const Totals totals = kernels().add_up(s.model, s.state, s.work.threads, s.ask(halves));
  Real mass = 0.0, kinetic = 0.0;
  std::array<Real, 2> growth{}, momentum{};
  for (const Point& p : points_by_id(s.state)) {
    mass += p.mass;
    kinetic += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]);
    for (int d = 0; d < 2; ++d) momentum[d] += p.mass * p.v[d];
    growth[p.x[0] < 7.5 ? 0 : 1] += p.volume * (p.eps_eq_p() - s.memory.last_eps_eq_p[static_cast<std::size_t>(p.id)]);
  }
  EXPECT_NEAR(totals.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(totals.kinetic, kinetic, 1e-12 * kinetic);
  EXPECT_NEAR(totals.momentum[0], momentum[0], 1e-12 * momentum_scale(s.state));
  EXPECT_NEAR(totals.momentum[1], momentum[1], 1e-12 * momentum_scale(s.state));
  for (int k = 0; k < 2; ++k) {
    EXPECT_GT(growth[k], 0.0);
    EXPECT_NEAR(totals.growth[k], growth[k], 1e-12 * growth[k]);
  }
  const MovedSoil moved = find_moved(s.state.points, s.state.x_initial, 0.1);
  EXPECT_GT(moved.volume, 0.1);
  EXPECT_NEAR(totals.moved.volume, moved.volume, 1e-12);
  EXPECT_EQ(totals.moved.reach_right, moved.reach_right);
}

TEST(Totals, HaveTheSameBitsOnAnyNumberOfThreads)
{
  Flowing one("mpm_mixed", 1), three("mpm_mixed", 3);
  const Totals a = kernels().add_up(one.model, one.state, one.work.threads, one.ask(halves)),
               b = kernels().add_up(three.model, three.state, three.work.threads, three.ask(halves));
  EXPECT_EQ(a.kinetic, b.kinetic);
  EXPECT_EQ(a.elastic, b.elastic);
  EXPECT_EQ(a.momentum, b.momentum);
  EXPECT_EQ(a.moved.volume, b.moved.volume);
  EXPECT_EQ(a.growth, b.growth);
  EXPECT_EQ(a.v_999, b.v_999);
  EXPECT_FALSE(a.fell.empty());
  EXPECT_EQ(a.fell, b.fell);
  EXPECT_EQ(a.strained, b.strained);
}

TEST(Totals, OfEachCopyOfTheKernelsAgree)
{
  Flowing s;
  const Totals first = kernels().add_up(s.model, s.state, s.work.threads, s.ask(halves));
  for (std::size_t k = 0; k < instruction_sets().size(); ++k) {
    const InstructionSet& set = instruction_sets()[k];
    if (!set.offered) continue;
    const Totals other = kernels_of_set(k).add_up(s.model, s.state, s.work.threads, s.ask(halves));
    EXPECT_NEAR(other.kinetic, first.kinetic, 1e-13 * first.kinetic) << set.name;
    EXPECT_NEAR(other.elastic, first.elastic, 1e-13 * first.elastic) << set.name;
    EXPECT_EQ(other.moved.reach_right, first.moved.reach_right) << set.name;
    EXPECT_NEAR(other.growth[0], first.growth[0], 1e-13 * first.growth[0]) << set.name;
    EXPECT_EQ(other.strained, first.strained) << set.name;
  }
}

TEST(Totals, NameThePointsWhoseHistoryWentBack)
{
  Simulation s(column("mpm_gp", 0.5));
  const auto strain_to = [&](std::int64_t id, Real eps) { set_value(s.state, id, Rows::state, eps); };
  strain_to(7, 0.02);
  strain_to(9, 0.02);
  StrainMemory memory = remember_strain(s.model, s.state);
  strain_to(7, 0.01);
  strain_to(9, 0.03);
  const Totals totals = kernels().add_up(s.model, s.state, s.work.threads, {0.1, {}, {}, &memory});
  EXPECT_THAT(totals.fell, ElementsAre(7));
  EXPECT_THAT(totals.rose, ElementsAre(7));  // its strength rose with it
  EXPECT_EQ(std::count(totals.strained.begin(), totals.strained.end(), 1), 1);
  EXPECT_EQ(memory.last_eps_eq_p[7], 0.02);  // the walk remembers nothing
}

}  // namespace totals_test
