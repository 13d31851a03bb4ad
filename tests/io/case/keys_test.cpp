#include "io/case/keys.hpp"
#include "io/case/key_text.hpp"
#include "support/test.hpp"

namespace keys_test {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

TEST(Keys, AreDeclaredOnceEach)
{
  std::set<std::string> paths;
  for (const KeyInfo& key : all_keys()) EXPECT_TRUE(paths.insert(key.path).second) << key.path;
}

Case case_with_one_of_each()
{
  Case values;
  values.bodies.resize(1), values.materials.resize(1), values.sides.resize(1), values.mesh.refine.resize(1),
      values.footings.resize(1), values.loads.resize(1), values.stages.resize(1), values.water.situations.resize(1);
  return values;
}

TEST(Keys, EachKeyHasItsOwnPlaceInTheCase)
{
  Case values = case_with_one_of_each();
  std::set<const Real*> places;
  for (const KeyInfo& key : all_keys()) {
    const Field field = key.field(values, 0);
    if (const auto* place = std::get_if<Real*>(&field)) {
      EXPECT_TRUE(places.insert(*place).second) << key.path;
    }
  }
}

TEST(Keys, EachBelongsToADeclaredSection)
{
  for (const KeyInfo& key : all_keys()) {
    const std::string parent = parent_path(key.path);
    EXPECT_TRUE(parent.empty() || parent == "boundary.SIDE" || find_section(parent) != nullptr) << key.path;
  }
}

TEST(Keys, DefaultsAreInTheirRange)
{
  Case values = case_with_one_of_each();
  for (const KeyInfo& key : all_keys()) {
    const Field field = key.field(values, 0);
    const auto* number = std::get_if<Real*>(&field);
    if (number != nullptr && !key.required && key.required_for.empty() && !std::isnan(**number)) {
      EXPECT_TRUE(key.range.contains(**number) || **number == -infinity) << key.path;  // a start before all times
    }
  }
}

TEST(Keys, WordsStandForTheEnumsOfTheSameName)
{
  Case values;
  const auto set = [&](const char* path, int word) { std::get<WordField>(find_key(path)->field(values, 0)).set(word); };
  set("method.weights", 1);
  EXPECT_EQ(find_key("method.weights")->words()[1], "summed");
  EXPECT_EQ(values.method.weights, Weights::summed);
  set("initial.stress", 1);
  EXPECT_EQ(find_key("initial.stress")->words()[1], "k0");
  EXPECT_EQ(values.initial.stress, InitialStress::k0);
}

TEST(Keys, OfALawFollowItsTable)
{
  const MaterialType& law = *find_material("tresca_softening");
  const auto keys = keys_of_law(law);
  ASSERT_EQ(keys.size(), law.parameters.size() + 2);
  EXPECT_EQ(keys[law.parameters.size()].path, "material.NAME.stiffness_ratio");
  EXPECT_EQ(keys[0].instead, "stiffness_ratio");
  EXPECT_EQ(keys[2].path, "material.NAME.su_peak");
  EXPECT_EQ(keys[2].unit, "Pa");
  EXPECT_TRUE(keys[2].required);
}

TEST(Keys, OutputFieldsHoldTheStateOfEveryLawAndItsParametersThatMayVary)
{
  const auto names = output_field_names();
  for (const MaterialType* law : all_materials()) {
    for (const StateInfo& state : law->state) EXPECT_THAT(names, Contains(std::string(state.name)));
    for (const DerivedInfo& derived : law->derived) EXPECT_THAT(names, Contains(std::string(derived.name)));
    for (const ParameterInfo& parameter : law->parameters)
      if (parameter.may_vary) {
        EXPECT_THAT(names, Contains("parameter_" + std::string(parameter.name)));
      }
  }
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace keys_test
