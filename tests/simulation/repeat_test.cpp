// The same bits on any number of threads.
#include "simulation/state_image.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"
#include "support/test.hpp"

namespace repeat_test {

StateImage state_after_300_steps(const char* scheme, int threads)
{
  Case c = column(scheme, 0.25);      // 256 cells: 16 chunks
  c.bodies[0].velocity = {2.0, 0.0};  // points change cell from the first steps on, and soften
  Simulation s(c, threads);
  EXPECT_EQ(s.work.threads.count(), threads);
  s.step(300);
  return make_image(s.state);
}

TEST(Repeat, OneTwoAndFourThreadsGiveTheSameBits)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"}) {
    const StateImage one = state_after_300_steps(scheme, 1);
    for (const int threads : {2, 4})
      EXPECT_EQ(first_difference(one, state_after_300_steps(scheme, threads)), "") << scheme << threads;
  }
}

TEST(Repeat, AChangeOfOneBitIsSeen)
{
  Simulation a(column("mpm_gp")), b(column("mpm_gp"));
  edit_points(b.state, [](const PointBlock<2>& block, Index lane) {
    if (block.row(PointRows<2>::id)[lane] == 700.0) block.row(PointRows<2>::v)[lane] = -0.0;
  });
  EXPECT_EQ(first_difference(make_image(a.state), make_image(b.state)), "points/velocity");
}

}  // namespace repeat_test
