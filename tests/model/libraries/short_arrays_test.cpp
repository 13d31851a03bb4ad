#include "model/libraries/short_arrays.hpp"
#include "run/findings/library_warnings.hpp"
#include "run/loop/simulation.hpp"
#include "support/law_cases.hpp"

namespace short_arrays_test {

std::string_view key_of(const MaterialCase& material)
{
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, material), 1);
  return find_short_array(s.model.materials[0], material.parameters, s.state.points.block(0), 0.25, s.model.dt);
}

TEST(ShortArrays, AreNoticedThoughNothingIsLargerThanANumberThatIsNone)
{
  EXPECT_EQ(key_of(wrong_umat(compares_beyond_props)), "parameters");
  EXPECT_EQ(key_of(wrong_umat(compares_beyond_state)), "state");
  EXPECT_EQ(key_of(wrong_umat(compares_in_extension)), "parameters");
  EXPECT_EQ(key_of(wrong_umat(reads_props)), "parameters") << "its stress is no number where there is none";
  EXPECT_EQ(key_of(wrong_umat(beyond_state)), "state") << "it writes the number that is there once";
  EXPECT_EQ(key_of(wrong_umat(adds_beyond_state)), "state");
  EXPECT_EQ(key_of(of_library(library_case("wrong_umat.so", LawInterface::esm, {shear, poisson, 0.0}))), "parameters");
  EXPECT_EQ(key_of(of_library(native("reading_law"))), "parameters");
  EXPECT_EQ(key_of(of_library(native("reading_state_law"))), "state");
}

TEST(ShortArrays, AreNotFoundWhereAllIsGiven)
{
  for (const Kind kind : {elastic_law, nan_stress, counts, small_parts, changes_rounding})
    EXPECT_EQ(key_of(wrong_umat(kind)), "") << kind;
  EXPECT_EQ(key_of(of_library(library_case("wrong_umat.so", LawInterface::esm, {shear, poisson}))), "");
  EXPECT_EQ(key_of(of_library(native("terp_law"))), "");
}

TEST(ShortArrays, OfLawsInFortranAreThoseWithOneNumberLess)
{
  if (!is_built("tresca.so")) GTEST_SKIP() << "there is no gfortran";
  const LibraryCase tresca =
      library_case("tresca.so", LawInterface::umat, {shear, poisson, 8e3, 2e3, 50.0}, {{"eps_eq_p", 0.0}});
  LibraryCase esm =
      library_case("esm_hardening.so", LawInterface::esm, {shear / 1e3, poisson, 2.0}, {{"k", 0.0}, {"calls", 0.0}});
  esm.stress_unit = 1e3;
  const LibraryCase six = library_case(
      "six_components.so", LawInterface::umat, {shear, poisson, 4e3, 1e5, 0.0, 0.0}, {{"eps_eq_p", 0.0}, {"k", 4e3}});
  EXPECT_EQ(key_of(of_library(six, {.n_components = 6})), "");
  for (const LibraryCase& whole : {tresca, esm}) {
    EXPECT_EQ(key_of(of_library(whole)), "") << whole.file;
    LibraryCase less = whole;
    less.state.pop_back();
    EXPECT_EQ(key_of(of_library(less)), "state") << whole.file;
    less = whole;
    less.parameters.pop_back();
    EXPECT_EQ(key_of(of_library(less)), "parameters") << whole.file;
  }
}

std::string said(const MaterialCase& material, double limit_s = limit_of_trial_s)
{
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, material), 1);
  std::vector<Problem> warnings;
  const auto found = problems_of([&] { find_odd_libraries(s.model, s.state, warnings, limit_s); });
  return found.empty() ? "" : found[0].key + ": " + found[0].what + '\n' + found[0].detail;
}

TEST(ShortArrays, AreAFaultOfTheCase)
{
  EXPECT_THAT(said(wrong_umat(compares_beyond_props)),
      AllOf(
          HasSubstr(".parameters: the law of the library uses more parameters than the case gives\nIt is given 6, and"),
          HasSubstr("Give all parameters that the law has, in its order.")));
  EXPECT_THAT(said(wrong_umat(compares_beyond_state)),
      AllOf(
          HasSubstr(".state: the law of the library uses more state variables than the case gives\nIt is given 1, and"),
          HasSubstr("Give all state variables that the law has, in its order.")));
  EXPECT_THAT(said(of_library(native("reading_state_law"))),
      AllOf(HasSubstr("uses more state variables than it describes\nIt is given 2, and"),
          HasSubstr("Correct n_state and the table in the description that the library gives.")));
  EXPECT_EQ(said(wrong_umat(elastic_law)), "");
}

TEST(LibraryTrial, OfALawThatEndsTheProgramEndsACopyAlone)
{
  const struct {
    Kind kind;
    const char* how;
  } rows[] = {{bad_memory, "was ended by signal 11 (Segmentation fault)"},
      {overflows, "was ended by signal 11 (Segmentation fault)"},
      {crashes_in_c, "was ended by signal 11 (Segmentation fault)"},
      {divides, "was ended by signal 8 (Floating point exception)"}, {aborts, "was ended by signal 6 (Aborted)"},
      {leaves, "ended before its time, as by STOP, XIT or exit"},
      {leaves_at_once, "ended before its time, as by STOP, XIT or exit"}};
  for (const auto& [kind, how] : rows)
    EXPECT_THAT(said(wrong_umat(kind)),
        AllOf(HasSubstr(
                  ".library: the law of the library failed when it was tried\nA copy of this program tried it, and " +
                  std::string(how) + ".\nIt strained the points at ("),
            HasSubstr("Call the law by itself with such strains")))
        << kind;
}

TEST(LibraryTrial, OfALawThatDoesNotReturnEnds)
{
  EXPECT_THAT(said(wrong_umat(loops), 0.5), HasSubstr("and did not come to an end within 0.5 s: it may loop.\n"));
}

TEST(LibraryTrial, OfALawThatCopiesTheProgramFindsWhatItWouldFindWithoutThat)
{
  EXPECT_EQ(said(wrong_umat(copies_itself)), "");
}

}  // namespace short_arrays_test
