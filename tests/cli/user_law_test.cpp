#include "support/laws.hpp"
#include "support/process.hpp"

#include <csignal>

namespace user_law_test {

/// A case with wrong_umat.c beside it. kind, time: what its law does wrong, from when [s].
class UserLawProgram : public testing::Test {
 protected:
  UserLawProgram() { std::filesystem::copy(law_folder() + "/wrong_umat.so", path("law.so")); }

  std::string path(const std::string& name) const { return scratch_.path() + '/' + name; }

  std::string case_with(int kind, double time) const
  {
    std::ofstream(path("case.toml"))
        << "[time]\nend = 0.2\n[mesh]\nsize = [4.0, 2.0]\ncell = 0.5\n[[body]]\nmaterial = \"clay\"\n"
           "box = [[0.0, 0.0], [2.0, 1.0]]\n[material.clay]\nmodel = \"library\"\nlibrary = \"law.so\"\n"
           "interface = \"umat\"\nparameters = [2e6, 0.3, "
        << kind << ", " << time
        << ", -1.0, 0.0]\nstate = { calls = 3.0 }\ndensity = 1990.0\nshear_modulus = 2e6\npoisson_ratio = 0.3\n"
           "[forces]\ngravity = [0.0, -9.81]\n[boundary]\nbottom = \"fixed\"\n[output]\ncheckpoint = { every = 0.05, "
           "keep = 0 }\n";
    return path("case.toml");
  }

  const ScratchFolder scratch_;
};

TEST_F(UserLawProgram, SaysWhatTheLawCosts)
{
  const Finished check = succeeded(test::terp({"check", case_with(0, 0.0)}));
  EXPECT_THAT(check.out, AllOf(HasSubstr("  law of clay    law.so: "), HasSubstr(" us per point and step, "),
                             HasSubstr("one thread at a time (thread_safe = false)")));
}

TEST_F(UserLawProgram, SaysWhatTheLawIsGiven)
{
  const Finished check = test::terp({"check", case_with(0, 0.5)});
  EXPECT_THAT(check.out,
      HasSubstr("  clay is given  6 parameters: (1) = 2e+06, (2) = 0.3, (3) = 0, (4) = 0.5, (5) = -1, (6) = 0\n"));
  EXPECT_THAT(check.out, HasSubstr("  clay remembers 1 state variable: calls = 3\n"));
  const Finished units =
      test::terp({"check", case_with(0, 0.5), "--set", "material.clay.state={\"calls [1/m]\" = 3.0}"});
  EXPECT_THAT(units.out, HasSubstr("  clay remembers 1 state variable: calls = 3 1/m\n")) << units.err;
}

TEST_F(UserLawProgram, RefusesAStrengthThatIsNotInTheUnitOfTheStresses)
{
  const auto said = [&](const std::string& state, const std::string& stress_unit) {
    return test::terp({"check", case_with(0, 0.0), "-q", "--set", "material.clay.state={" + state + " = 8.0}", "--set",
        "material.clay.strength=\"cu\"", "--set", "material.clay.stress_unit=\"" + stress_unit + "\""});
  };
  const Finished pascal = said("\"cu [kPa]\"", "Pa"), angle = said("\"cu [deg]\"", "Pa");
  EXPECT_EQ(pascal.status, 2);
  EXPECT_THAT(pascal.err, HasSubstr("the strength `cu` is in kPa, the stresses of the library in Pa"));
  EXPECT_THAT(pascal.err, HasSubstr("Correct `stress_unit`, or the unit of the state variable."));
  EXPECT_THAT(angle.err, HasSubstr("the strength `cu` is in deg, the stresses of the library in Pa"));
  EXPECT_THAT(angle.err, HasSubstr("Allowed: a state variable in the unit of `stress_unit`."));
  for (const char* good : {"\"cu [Pa]\"", "\"cu [N/m^2]\"", "cu"}) EXPECT_EQ(said(good, "Pa").status, 0) << good;
}

TEST_F(UserLawProgram, WarnsOfAStrengthBelowZero)
{
  const auto err = [&](int kind, const char* folder) {
    return test::terp(
        {"run", case_with(kind, 0.1), "-q", "-o", path(folder), "--set", "material.clay.strength=\"calls\""})
        .err;
  };
  EXPECT_THAT(err(23, "run"), HasSubstr(": a law of a library returned a strength of -0.5 Pa, below zero; see "
                                        "docs/user_laws.md#the-keys\n"));
  EXPECT_THAT(err(0, "other"), Not(HasSubstr("below zero")));
}

TEST_F(UserLawProgram, NamesTheInterfaceThatTheLibraryHas)
{
  EXPECT_THAT(error_with(2, test::terp({"check", case_with(0, 0.0), "--set", "material.clay.interface=\"native\""})),
      HasSubstr("It has umat_, that of interface = \"umat\". Give this interface."));
}

TEST_F(UserLawProgram, ShearsTheOneCellOfTheExample)
{
  if (!is_built("tresca.so")) GTEST_SKIP() << "built without gfortran";
  std::filesystem::copy(law_folder() + "/tresca.so", path("tresca.so"));
  std::filesystem::copy(test::source_path("cases/user_law/one_cell.toml"), path("one_cell.toml"));
  EXPECT_EQ(succeeded(test::terp({"run", path("one_cell.toml"), "-q", "-o", path("run")})).err, "");
  succeeded(test::terp({"export", path("run"), "--field", "stress", "--frames", "1,5,last"}));
  for (const auto& [frame, by_hand] : std::map<std::string, std::string>{
           {"frame_00001", ",7272.727\n"}, {"frame_00005", ",5856.719"}, {"frame_00050", ",2041.472"}})
    EXPECT_THAT(text_of(path("run/csv/" + frame + ".csv")), HasSubstr(by_hand)) << "docs/user_laws.md has the numbers";
}

TEST_F(UserLawProgram, RefusesALawThatReadsAParameterWhichTheCaseForgot)
{
  const std::string file = case_with(25, 0.0);  // compares with a number behind PROPS, and is elastic where it is none
  for (const char* command : {"check", "run"}) {
    EXPECT_THAT(error_with(2, test::terp({command, file, "-q"})),
        AllOf(HasSubstr("case.toml:13:14: the law of the library uses more parameters than the case gives"),
            HasSubstr(
                "It is given 6, and what it returned for strains of 0.05 to 1 % changed with numbers that do not"),
            HasSubstr("Give all parameters that the law has, in its order.")));
  }
}

TEST_F(UserLawProgram, IsToldOfStateThatIsTooShortBeforeARunBegins)
{
  const std::string file = case_with(15, 0.0);  // writes behind STATEV
  for (const char* command : {"check", "run"}) {
    EXPECT_THAT(error_with(2, test::terp({command, file, "-q"})),
        HasSubstr("case.toml:14:9: the law of the library uses more state variables than the case"));
  }
}

TEST_F(UserLawProgram, IsToldOfAFaultOnce)
{
  const std::string fault = "the law returned a stress that is not a number";
  const std::string check = error_with(3, test::terp({"check", case_with(1, 0.0)}));
  EXPECT_THAT(
      check, AllOf(HasSubstr("error: the run would stop itself: "), HasSubstr(fault), Not(HasSubstr("checkpoint"))));
  EXPECT_EQ(check.find(fault), check.rfind(fault)) << check;
  EXPECT_THAT(error_with(3, test::terp({"run", case_with(1, 0.0), "-q", "-o", path("run")})),
      HasSubstr("left     no checkpoint was written yet: begin anew with the corrected library or case"));
}

TEST_F(UserLawProgram, SaysNothingOfAPlasticStrainThatIsNotKnown)
{
  const std::string file = case_with(0, 0.0);
  const Finished unknown = test::terp({"run", file, "-o", path("unknown")});
  EXPECT_THAT(unknown.out, Not(HasSubstr("largest eps_eq_p")));
  EXPECT_THAT(text_of(path("unknown/summary.json")), HasSubstr("\"max_eps_eq_p\": null"));
  const Finished known =
      test::terp({"run", file, "-o", path("known"), "--set", "material.clay.plastic_strain=\"calls\""});
  EXPECT_THAT(known.out, HasSubstr("largest eps_eq_p ")) << known.err;
}

TEST_F(UserLawProgram, ComparesTheStiffnessOfTheLawWithTheCase)
{
  const std::string file = case_with(0, 0.0);
  const auto said = [&](const std::vector<std::string>& more) { return test::terp(with({"check", file, "-q"}, more)); };
  EXPECT_THAT(said({}).err, Not(HasSubstr("the law of the library")));
  EXPECT_THAT(succeeded(said({"--set", "material.clay.shear_modulus=3e6"})).err,
      AllOf(HasSubstr("the law of the library is softer than the case says"),
          HasSubstr("give shear_modulus = 2e+06 and poisson_ratio = 0.3.")));
  EXPECT_THAT(succeeded(said({"--set", "material.clay.shear_modulus=1e6"})).err,
      AllOf(HasSubstr("is stiffer than the case says"),
          HasSubstr("G = 2e+06 Pa; shear_modulus and poisson_ratio say 3.5e+06 Pa and 1e+06 Pa."),
          HasSubstr("is too long by a factor of 1.41")));
  EXPECT_THAT(error_with(2, said({"--set", "material.clay.shear_modulus=2e3"})),
      HasSubstr("=2e3: the law of the library is too stiff for the time step"));
  EXPECT_EQ(test::terp({"run", file, "-q", "-o", path("run"), "--set", "material.clay.shear_modulus=2e3"}).status, 2);
}

TEST_F(UserLawProgram, IsWarnedOfAShearStrainTakenAsTensorial)
{
  const std::string file = case_with(21, 0.0);
  for (const std::vector<std::string>& words :
      {std::vector<std::string>{"check", file, "-q"}, {"run", file, "-q", "-o", path("run")}}) {
    EXPECT_THAT(succeeded(test::terp(words)).err,
        AllOf(HasSubstr("the law of the library is stiffer in one direction of shearing than in another"),
            HasSubstr("G is 4e+06 Pa of the shear strain 12 (xy), 2e+06 Pa of the strains 11 and 22"),
            HasSubstr("a UMAT and an ESM are given engineering shear")));
  }
}

TEST_F(UserLawProgram, ResumesInAFolderThatWasMovedWithTheSameBits)
{
  const std::string file = case_with(0, 0.0);
  succeeded(test::terp({"run", file, "-q", "-o", path("whole")}));
  succeeded(test::terp({"run", file, "-q", "-o", path("part"), "--set", "time.end=0.2"}));
  std::filesystem::rename(path("part"), path("moved"));
  std::filesystem::remove(path("law.so"));
  std::filesystem::path first;
  for (const auto& entry : std::filesystem::directory_iterator(path("moved")))
    if (entry.path().filename().string().starts_with("checkpoint_") && (first.empty() || entry.path() < first))
      first = entry.path();
  succeeded(test::terp({"resume", first.string(), "-q"}));
  EXPECT_EQ(text_of(path("moved/ledger.csv")), text_of(path("whole/ledger.csv")));
}

TEST_F(UserLawProgram, DoesNotResumeWithAnotherLibrary)
{
  succeeded(test::terp({"run", case_with(0, 0.0), "-q", "-o", path("run")}));
  std::filesystem::copy(
      law_folder() + "/wrong_umat.so", path("run/library_1.so"), std::filesystem::copy_options::overwrite_existing);
  std::ofstream(path("run/library_1.so"), std::ios::app) << "rebuilt";
  EXPECT_THAT(error_with(1, test::terp({"resume", path("run"), "-q"})), HasSubstr("material.clay.library (content)"));
}

TEST_F(UserLawProgram, KeepsTheCheckpointsOfARunWhoseLawCrashes)
{
  const std::string run = error_with(3, test::terp({"run", case_with(1, 0.12), "-q", "-o", path("run")}));
  EXPECT_THAT(run, HasSubstr("the law returned a stress that is not a number"));
  EXPECT_THAT(run, AllOf(HasSubstr("material `clay`, material point "), HasSubstr("left     the checkpoint at t = 0.1"),
                       HasSubstr("terp run CASE.toml --from " + path("run") + " -o NEW_FOLDER")));
  EXPECT_EQ(test::terp({"run", case_with(3, 0.12), "-q", "-o", path("run"), "--force"}).status, 128 + SIGSEGV);
  succeeded(test::terp({"run", case_with(0, 0.0), "-q", "--from", path("run"), "-o", path("mended")}));
}

TEST_F(UserLawProgram, RefusesALawThatEndsItsTrial)
{
  for (const auto& [kind, how] : {std::pair{3, "was ended by signal 11 (Segmentation fault)"},
           {29, "ended before its time, as by STOP, XIT or exit"}}) {
    const std::string file = case_with(kind, 0.0);
    for (const std::vector<std::string>& words :
        {std::vector<std::string>{"check", file}, {"run", file, "-o", path("run")}})
      EXPECT_THAT(error_with(2, test::terp(words)),
          AllOf(HasSubstr("case.toml:11:11: the law of the library failed when it was tried"), HasSubstr(how)));
  }
  EXPECT_FALSE(std::filesystem::exists(path("run")));
}

TEST_F(UserLawProgram, StopsWithItsOwnStatusWhereTheLawEndsTheProgram)
{
  EXPECT_THAT(error_with(3, test::terp({"run", case_with(6, 0.12), "-q", "-o", path("run")})),
      HasSubstr("error: the law of material `clay` ended the program"));
}

TEST_F(UserLawProgram, IsNotJudgedForItsFactorOfSafety)
{
  EXPECT_THAT(error_with(2, test::terp({"stability", case_with(0, 0.0), "-o", path("stability")})),
      HasSubstr("Terp cannot know which of the library's parameters are strengths"));
}

}  // namespace user_law_test
