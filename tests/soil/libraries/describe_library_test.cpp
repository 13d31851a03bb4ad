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

}  // namespace describe_library_test
