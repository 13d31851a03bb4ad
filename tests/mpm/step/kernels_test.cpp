#include "mpm/step/kernels.hpp"
#include "soil/laws/material_list.hpp"
#include "os/instructions.hpp"
#include "mpm/schemes/scheme.hpp"
#include "support/test.hpp"

namespace kernels_test {

TEST(Kernels, EveryCopyHasItsOwnNameAndEveryLawAndScheme)
{
  for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
    EXPECT_EQ(kernels_of_set(set).instructions, instruction_sets()[set].name);
    ASSERT_EQ(materials_of_set(set).size(), all_materials().size());
    for (std::size_t k = 0; k < all_materials().size(); ++k)
      EXPECT_EQ(materials_of_set(set)[k]->name, all_materials()[k]->name);
    ASSERT_EQ(schemes_of_set(set).size(), all_schemes().size());
    for (std::size_t k = 0; k < all_schemes().size(); ++k)
      EXPECT_EQ(schemes_of_set(set)[k]->name, all_schemes()[k]->name);
  }
}

TEST(Kernels, NoTwoCopiesShareALawASchemeOrAStep)
{
  for (std::size_t a = 0; a < instruction_sets().size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NE(materials_of_set(a)[0], materials_of_set(b)[0]);
      EXPECT_NE(materials_of_set(a)[0]->maker, materials_of_set(b)[0]->maker);
      EXPECT_NE(schemes_of_set(a)[0]->own_shares[0].run, schemes_of_set(b)[0]->own_shares[0].run);
      EXPECT_NE(kernels_of_set(a).step, kernels_of_set(b).step);
    }
}

TEST(Kernels, LawsSchemesAndStepsOfThisProcessAreOfOneCopy)
{
  EXPECT_EQ(kernels().instructions, instructions());
  EXPECT_EQ(all_materials()[0], materials_of_set(chosen_set())[0]);
  EXPECT_EQ(all_schemes()[0], schemes_of_set(chosen_set())[0]);
}

}  // namespace kernels_test
