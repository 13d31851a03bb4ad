#include "schemes/scheme.hpp"
#include "simulation/state_image.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"
#include "support/test.hpp"

namespace scheme_test {

TEST(Schemes, ListsEverySchemeOnceWithALineOfText)
{
  std::vector<std::string> names;
  for (const Scheme* scheme : all_schemes()) {
    names.emplace_back(scheme->name);
    EXPECT_FALSE(scheme->summary.empty()) << scheme->name;
    EXPECT_FALSE(scheme->title.empty()) << scheme->name;
  }
  EXPECT_THAT(names, ElementsAre("standard_mpm", "mpm_mixed", "mpm_gp"));
}

TEST(Schemes, AreFoundByNameAndOnlyByName)
{
  for (const Scheme* scheme : all_schemes()) EXPECT_EQ(find_scheme(scheme->name), scheme);
  EXPECT_EQ(find_scheme("mpm"), nullptr);
}

/// State of the column after some steps, with one option of the method changed.
StateImage after_steps(std::string_view scheme, void (*change)(MethodOptions&))
{
  Case c = column(std::string(scheme));
  c.bodies[0].velocity = {2.0, 0.5};
  change(c.method);
  Simulation s(c);
  s.step(40);
  return make_image(s.state);
}

TEST(Schemes, SaysTruthfullyWhichOptionsChangeNothing)
{
  using Change = std::pair<const char*, void (*)(MethodOptions&)>;
  const Change changes[] = {
      {"weights", [](MethodOptions& m) { m.weights = Weights::summed; }},
      {"filled_fraction", [](MethodOptions& m) { m.filled_fraction = 0.5; }},
      {"b_bar", [](MethodOptions& m) { m.b_bar = false; }},
      {"force_operator", [](MethodOptions& m) { m.force_operator = ForceOperator::b; }},
      {"point_pressure", [](MethodOptions& m) { m.point_pressure = PointPressure::own; }},
      {"state_averaging", [](MethodOptions& m) { m.state_averaging = StateAveraging::sub_cell; }},
      {"objective_rate", [](MethodOptions& m) { m.objective_rate = ObjectiveRate::jaumann; }},
      {"flip", [](MethodOptions& m) { m.flip = 0.9; }},
  };
  for (const Scheme* scheme : all_schemes()) {
    const StateImage plain = after_steps(scheme->name, [](MethodOptions&) {});
    for (const auto& [option, change] : changes) {
      const bool changes_nothing = first_difference(plain, after_steps(scheme->name, change)).empty();
      EXPECT_EQ(changes_nothing, !looks_at(*scheme, option)) << scheme->name << ' ' << option;
    }
    EXPECT_EQ(looks_at(*scheme, "pressure_relaxation"), looks_at(*scheme, "point_pressure"));
  }
}

}  // namespace scheme_test
