#include "mpm/features/feature.hpp"
#include "mpm/features/mean_force.hpp"
#include "mpm/features/search.hpp"
#include "mpm/step/state_arrays.hpp"
#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

#include <set>

namespace feature_test {

struct Unknown;

TEST(Slot, OfATypeThatIsNotKnownIsEmptyAndSoIsItsCopy)
{
  const Slot<Unknown> slot, copy = slot;
  EXPECT_FALSE(slot);
  EXPECT_EQ(copy.get(), nullptr);
}

TEST(Slot, ACopyHasAValueOfItsOwn)
{
  Slot<std::vector<int>> slot;
  slot.set({1, 2});
  Slot<std::vector<int>> copy = slot;
  copy->push_back(3);
  EXPECT_THAT(*slot, ElementsAre(1, 2));
  EXPECT_THAT(*copy, ElementsAre(1, 2, 3));
  slot = copy;
  copy.clear();
  EXPECT_THAT(slot.made(), ElementsAre(1, 2, 3));
  EXPECT_THAT(copy.made(), ElementsAre());
}

TEST(Features, HaveNamesOfTheirOwn)
{
  std::set<std::string_view> names;
  for (const Feature* feature : all_features()) names.insert(feature->name);
  EXPECT_EQ(names.size(), all_features().size());
  EXPECT_TRUE(names.contains("mean_force"));
}

Simulation damped_by_the_mean()
{
  Case c = column("mpm_gp");
  c.forces.averaging_time = 0.1;
  return Simulation(c);
}

TEST(Features, SaveWhatTheyLoadUnderTheirNames)
{
  Simulation s = damped_by_the_mean();
  make_steps(s, 3);
  std::vector<NamedArray> saved;
  {
    std::vector<ArraySource> sources;
    ArrayWriter arrays(sources);
    for (const Feature* feature : all_features())
      if (feature->save != nullptr) feature->save(s.state, arrays);
    for (const ArraySource& of : sources) saved.push_back({of.name, of.shape, of.read(0, of.n_rows()), 0});
  }
  ASSERT_EQ(saved.size(), 1u);
  EXPECT_EQ(saved[0].name, "mean_force");
  StepState state;
  for (const Feature* feature : all_features())
    if (feature->load != nullptr) feature->load(s.model, ArrayReader(saved), state);
  ASSERT_TRUE(state.with.mean_force);
  EXPECT_EQ(state.with.mean_force->force, s.state.with.mean_force->force);
  EXPECT_TRUE(std::ranges::any_of(state.with.mean_force->force, [](Vec<2> f) { return f[1] < 0.0; }));
}

TEST(Features, ThatAModelDoesWithoutHaveNoRoom)
{
  Case c = column("mpm_gp");
  c.method.shares = Shares::point;
  c.method.pressure = Pressure::constant;
  const Simulation s(c);
  const ScratchSlots& with = s.work.with;
  EXPECT_FALSE(with.footings || with.loads || with.bodies || with.water || with.excess || with.search || with.overlap ||
               with.slip || with.softening || with.relaxation || with.rest || with.balance);
  EXPECT_FALSE(s.state.with.mean_force);
}

TEST(Search, DampsWithACoefficientOfItsOwn)
{
  const auto largest_damping = [](Real of_search) {
    Simulation s(column("mpm_gp"));
    begin_search(of_search, s.work).share = 1.0;
    make_steps(s, 2);
    Real most = 0.0;
    for (const Index i : s.work.active_nodes) most = std::max(most, std::abs(s.work.node[i].damping[1]));
    return most;
  };
  EXPECT_EQ(largest_damping(0.0), 0.0);
  EXPECT_GT(largest_damping(0.7), 1.0);
}

}  // namespace feature_test
