#include "verify/scope.hpp"
#include "whole/ledger_samples.hpp"

namespace scope_test {

std::string expected_with(const std::string& constants)
{
  return "title = \"Flight\"\n[constants]\n" + constants +
         "\n[[run]]\nname = \"a\"\n[[quantity]]\nname = \"path\"\nvalue = \"ux\"\nreduce = \"max_error\"\n"
         "reference = \"0\"\ntolerance = 1\nsource = \"Newton\"\n";
}

/// Constants of the flying box, with changes of its case; dt = 0.01 s.
std::map<std::string, Real> constants_of(const std::string& text, const std::vector<std::string>& changes = {})
{
  const LedgerSample sample(expected_with(text));
  const Expected expected = read_expected(sample.path());
  return make_scope(expected, expected.variants.at(0), read_case(sample.folder.path() + "/case.toml", changes), 0.01)
      .constants;
}

std::string refusal_of(const std::string& text)
{
  return refusal<CaseError>([&] { constants_of(text); });
}

TEST(Scope, KnowsTheEndAndTheTimeStep)
{
  const auto constants = constants_of("a = \"end/dt\"");
  EXPECT_EQ(constants.at("end"), 0.5);
  EXPECT_DOUBLE_EQ(constants.at("a"), 50.0);
}

TEST(Scope, TakesNumbersOfTheCaseAsItRuns)
{
  EXPECT_EQ(constants_of("G = { key = \"material.rock.shear_modulus\" }").at("G"), 1e6);
  EXPECT_EQ(
      constants_of("G = { key = \"material.rock.shear_modulus\" }", {"material.rock.shear_modulus=3e6"}).at("G"), 3e6);
  EXPECT_EQ(constants_of("n = { key = \"body[0].points_per_cell\" }").at("n"), 2.0);
}

TEST(Scope, LaterFormulasKnowEarlierConstants)
{
  EXPECT_EQ(constants_of("rho = { key = \"material.rock.density\" }\ntwice = \"2*rho\"").at("twice"), 4000.0);
  EXPECT_THAT(refusal_of("twice = \"2*rho\""), HasSubstr("this formula cannot be evaluated"));
}

TEST(Scope, RefusesAKeyThatGivesNoNumber)
{
  EXPECT_THAT(refusal_of("a = { key = \"material.rock.model\" }"), HasSubstr("`material.rock.model` is not a number"));
  EXPECT_THAT(refusal_of("a = { key = \"material.rock.su_peak\" }"),
      HasSubstr("the case says nothing of `material.rock.su_peak`"));
}

}  // namespace scope_test
