// The table of each copy of the kernels: its own name, every law and every scheme.
#include "parallel/kernels.hpp"

#include "materials/material.hpp"
#include "schemes/scheme_info.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(Kernels, EveryCopyHasItsOwnNameAndEveryLawAndScheme)
{
  for (const InstructionSet& set : instruction_sets()) {
    EXPECT_EQ(set.kernels->instructions, set.name);
    ASSERT_EQ(set.kernels->materials.size(), all_materials().size());
    for (std::size_t k = 0; k < all_materials().size(); ++k)
      EXPECT_EQ(set.kernels->materials[k]->name, all_materials()[k]->name);
    for (const SchemeInfo& scheme : all_schemes())
      EXPECT_NE(set.kernels->find_step(scheme.name), nullptr) << set.name << scheme.name;
    EXPECT_EQ(set.kernels->find_step("mpm"), nullptr);
  }
}

TEST(Kernels, NoTwoCopiesShareALawOrAStep)
{
  const auto sets = instruction_sets();
  for (std::size_t a = 0; a < sets.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NE(sets[a].kernels->materials[0], sets[b].kernels->materials[0]);
      EXPECT_NE(sets[a].kernels->materials[0]->make, sets[b].kernels->materials[0]->make);
      EXPECT_NE(sets[a].kernels->find_step("mpm_gp"), sets[b].kernels->find_step("mpm_gp"));
    }
}

}  // namespace
}  // namespace terp
