#include "soil/libraries/describe_library.hpp"
#include "support/laws.hpp"
#include "support/problems.hpp"

namespace describe_library_test {

std::vector<Problem> problems_with(LibraryCase library)
{
  const std::array<Real, 2> moduli{1e6, 0.3};
  return problems_of([&] { load_user_law("clay", law_folder(), moduli, library); });
}

TEST(Library, ThatIsNoLibraryIsRefused)
{
  const ScratchFolder scratch;
  std::ofstream(scratch.path() + "/text.so")
      << "this is text, and long enough to be looked at as a library by its head";
  EXPECT_THAT(problems_with({.file = scratch.path() + "/text.so"}),
      ElementsAre(told("library", "the library cannot be opened", HasSubstr("This is no shared library"))));
}

TEST(Library, ThatThisMachineCannotLoadIsRefusedInWords)
{
  const ScratchFolder scratch;
  std::ifstream file(law_folder() + "/elastic.so", std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(file), {}};
  const auto said = [&](const char* why, auto change) {
    std::string bytes = good;
    change(bytes);
    const std::string path = scratch.path() + "/law.so";
    std::ofstream(path, std::ios::binary) << bytes;
    EXPECT_THAT(problems_with({.file = path}),
        ElementsAre(told("library", "the library cannot be opened", HasSubstr(path + ": " + why))));
  };
  constexpr std::size_t bits = 4, type = 16, machine = 18;  // in the head of an ELF file
  said("it is a library of 32 bits, and this program has 64", [](std::string& b) { b[bits] = 1; });
  said("it was built for another processor", [](std::string& b) { b[machine] ^= 1; });
  said("it is an object file: link it with -shared", [](std::string& b) { b[type] = 1; });
  said("the end of the file is missing", [](std::string& b) { b.resize(b.size() / 3); });
}

TEST(Library, ThatLacksAUtilityRoutineOfAbaqusIsToldWhereItIs)
{
  EXPECT_THAT(problems_with({.file = "calls_sinv.so", .interface = LawInterface::umat}),
      ElementsAre(told("library", "the library cannot be opened",
          HasSubstr("undefined symbol: sinv_\n`sinv` is a utility routine of Abaqus. Build the library with "
                    "abaqus.f90"))));
}

TEST(Library, WithoutTheFunctionIsRefused)
{
  EXPECT_THAT(problems_with({.file = "wrong_umat.so", .symbol = "umat_clay"}),
      ElementsAre(told("symbol", "the library has no function umat_clay", HasSubstr("`nm -D wrong_umat.so` lists"))));
  EXPECT_THAT(problems_with({.file = "wrong_native.so", .interface = LawInterface::umat}),
      ElementsAre(told("library", "the library has no function umat_ or umat or UMAT")));
}

TEST(Library, WhoseDescriptionIsWrongIsRefused)
{
  const auto said = [](const char* symbol, const char* what, const char* detail) {
    EXPECT_THAT(problems_with({.file = "wrong_native.so", .symbol = symbol}),
        ElementsAre(told("library", what, HasSubstr(detail))));
  };
  said("old_law", "the library was built for another version of the interface", "has version 2, this Terp has 1.");
  said("empty_law", "the description of the law is not complete", "tables of as many");
  said("no_law", "the library returns no description of its law", "returned NULL");
  said("crashing_law", "the library failed when it was asked to describe its law",
      "A copy of this program asked it, and was ended by signal 11 (Segmentation fault).");
  said("torn_law", "the library failed when it was asked to describe its law", "signal 11 (Segmentation fault)");
  said("huge_law", "the law has too many variables", "0 parameters and 1000000 state variables; at most 1000 and 100.");
  said("nan_law", "the state variable `void_ratio` of the library begins with no number", "`initial` is nan");
  said("named_law", "the library has a variable named `two words`", "letters, digits and _");
}

TEST(Library, ThatTakesOtherParametersIsRefused)
{
  LibraryCase library{.file = "elastic.so", .parameters = {{"", 1e6}}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("parameters", "the library takes 2 parameters, the case gives 1",
                                          HasSubstr("stiffness, poisson"))));
  library.parameters = {{"stifness", 1e6}, {"poisson", 0.3}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("parameters", "the library has no parameter `stifness`",
                                          StartsWith("Did you mean `stiffness`?"))));
  library.parameters = {{"stiffness", 1e6}};
  EXPECT_THAT(
      problems_with(library), ElementsAre(told("parameters", "the parameter `poisson` of the library is missing")));
  library.parameters = {{"poisson", 0.3}, {"poisson", 0.2}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("parameters", "two entries have the name `poisson`")));
}

TEST(Library, WhoseStateHasOtherNamesIsRefused)
{
  LibraryCase library{.file = "elastic.so", .parameters = {{"", 1e6}, {"", 0.3}}, .state = {{"void_ratio", 0.8}}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("state", "the library has no state variable `void_ratio`")));
  library = {.file = "wrong_umat.so", .interface = LawInterface::umat, .state = {{"e 0", 0.8}}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("state", "`e 0` is no name of a state variable")));
  library.state = {{"", 0.8}};
  EXPECT_THAT(problems_with(library), ElementsAre(told("state", "a state variable has no name")));
}

TEST(Library, IsCalledByOneThreadAtATimeIfTheCaseOrTheLibrarySaysSo)
{
  const std::array<Real, 2> moduli{1e6, 0.3};
  LibraryCase library{.file = "elastic.so", .parameters = {{"", 1e6}, {"", 0.3}}};
  load_user_law("clay", law_folder(), moduli, library);
  EXPECT_TRUE(library.thread_safe) << "it says so itself";
  load_user_law("clay", law_folder(), moduli, library, {}, true);
  EXPECT_FALSE(library.thread_safe);
  library = {.file = "wrong_native.so", .parameters = {{"", 1e6}, {"", 0.3}}, .thread_safe = true};
  EXPECT_THAT(problems_with(library),
      ElementsAre(told("thread_safe", "the library says of itself that it is not thread safe")));
}

TEST(Library, BeginsWithTheStateOfTheCase)
{
  LibraryCase library{.file = "elastic.so", .parameters = {{"", 1e6}, {"", 0.3}}, .state = {{"shear_path", 0.5}}};
  const auto law = load_user_law("clay", law_folder(), std::array<Real, 2>{1e6, 0.3}, library);
  ASSERT_EQ(law->state.size(), 1u);
  EXPECT_EQ(law->state[0].name, "shear_path");
  EXPECT_EQ(law->state[0].initial, 0.5);
  EXPECT_EQ(law->state[0].meaning, "sum of the shear strain increments");
}

/// A law that remembers a plastic strain and a strength, in kPa.
LibraryCase softening_law()
{
  return {.file = "wrong_umat.so",
      .interface = LawInterface::umat,
      .state = {{"k", 0.0}, {"cu", 8.0}, {"p_0 [kN/m^2]", 50.0}},
      .stress_unit = 1e3};
}

constexpr std::array<Real, 2> moduli{1e6, 0.3};

TEST(Library, IsAskedForTheStrainAndTheStrengthThatTheCaseNames)
{
  LibraryCase library = softening_law();
  const auto law = load_user_law("clay", law_folder(), moduli, library, {.plastic_strain = "k", .strength = "cu"});
  EXPECT_EQ(find_role(law->state, Role::plastic_strain), 0);
  ASSERT_EQ(law->derived.size(), 1u);
  EXPECT_EQ(law->derived[0].name, "su");
  EXPECT_EQ(law->derived[0].unit, "Pa");
  EXPECT_EQ(law->derived[0].meaning, "current strength, the state variable cu of the library");
  EXPECT_EQ(law->derived[0].role, Role::strength);
  EXPECT_EQ(law->state[0].unit, "-");
  EXPECT_EQ(law->state[1].unit, "kPa") << "that of the stresses";
  EXPECT_EQ(law->state[2].name, "p_0");
  EXPECT_EQ(law->state[2].unit, "kN/m^2");
  std::vector<Real> state{0.1, 3.0, 50.0};
  EXPECT_EQ(law->make(moduli)->derived(0, {.state = {.data = state.data()}, .parameters = {}}), 3e3);
  EXPECT_TRUE(std::isnan(terms_of(*law)->residual_strength));
  EXPECT_EQ(terms_of(*find_material("tresca_softening")), nullptr);
}

TEST(Library, OfWhichNothingIsSaidHasThePlasticStrainOfItsNameAlone)
{
  LibraryCase library = softening_law();
  EXPECT_EQ(find_role(load_user_law("clay", law_folder(), moduli, library)->state, Role::plastic_strain), -1);
  library.state[0].name = "eps_eq_p";
  const auto law = load_user_law("clay", law_folder(), moduli, library);
  EXPECT_EQ(find_role(law->state, Role::plastic_strain), 0);
  EXPECT_TRUE(law->derived.empty());
}

TEST(Library, WhoseStrainAndStrengthCannotBeMeantIsRefused)
{
  const auto refused = [](
                           const LawTerms& terms, const char* key, const char* what, const char* detail,
                           std::function<void(LibraryCase&)> change = [](LibraryCase&) {}) {
    LibraryCase library = softening_law();
    change(library);
    EXPECT_THAT(problems_of([&] { load_user_law("clay", law_folder(), moduli, library, terms); }),
        ElementsAre(told(key, what, HasSubstr(detail))));
  };
  refused({.plastic_strain = "kk"}, "plastic_strain", "the library has no state variable `kk`",
      "Those of the library, in its order: k, cu, p_0.");
  refused({.strength = "c"}, "strength", "the library has no state variable `c`", "in its order: k, cu, p_0.");
  refused({.plastic_strain = "k", .strength = "k"}, "strength", "`k` cannot be the strength and the plastic strain",
      "Give the name of another state variable");
  refused({.strength = "eps_eq_p"}, "strength", "`eps_eq_p` cannot be the strength and the plastic strain",
      "Give the name of another state variable", [](LibraryCase& c) { c.state[1].name = "eps_eq_p"; });
  refused({.strength = "cu"}, "strength", "the strength `cu` is 0 at t = 0", "state = { cu = VALUE }",
      [](LibraryCase& c) { c.state[1].value = 0.0; });
  refused({.residual_strength = 2e3}, "residual_strength", "nothing says which state variable is the strength",
      "Give its name as `strength`");
  refused({.strength = "cu", .residual_strength = 9e3}, "residual_strength",
      "the residual strength is above that at t = 0", "Got 9000 Pa; `cu` begins at 8000 Pa.");
  refused({}, "state", "`p_0 []` has no unit that can be read", "A unit has 1 to 20 letters",
      [](LibraryCase& c) { c.state[2].name = "p_0 []"; });
  refused({}, "state", "`p 0` is no name of a state variable", "letters, digits and _",
      [](LibraryCase& c) { c.state[2].name = "p 0 [kPa]"; });
}

}  // namespace describe_library_test
