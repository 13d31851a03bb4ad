#include "batch/store.hpp"

#include "support/test.hpp"

namespace store_test {

TEST(Store, ALineKeepsEveryBit)
{
  Realisation r{.number = 17, .inputs = {1.0 / 3.0, -2.5e-300}, .slid = true, .judges_flood = true};
  r.wall_s = 1.5, r.processor_s = 0.25;
  for (std::size_t k = 0; k < study_outcomes().size(); ++k) r.outcomes.push_back(1.0 / (3.0 + static_cast<Real>(k)));
  r.outcomes[1] = std::numeric_limits<Real>::quiet_NaN();
  const auto back = realisation_of(line_of(r), 2);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->same_as(r));
  EXPECT_EQ(back->wall_s, 1.5);
  EXPECT_EQ(back->processor_s, 0.25);
  EXPECT_TRUE(back->slid && !back->flooded && back->judges_flood);
  EXPECT_FALSE(realisation_of(line_of(r), 3)) << "of another number of inputs";
  const Realisation failed{.number = 2, .inputs = {1.0}, .fault = "stopped itself: no equilibrium"};
  EXPECT_TRUE(realisation_of(line_of(failed), 1)->same_as(failed));
}

TEST(Store, PartsShareOutTheRealisations)
{
  const StudyPart part{2, 3};
  EXPECT_EQ(part.file(), "part_2_of_3.rows");
  EXPECT_FALSE(part.has(0));
  EXPECT_TRUE(part.has(1));
  EXPECT_TRUE(part.has(4));
}

}  // namespace store_test
