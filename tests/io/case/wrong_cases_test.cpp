// A catalogue of wrong case files: one line each in wrong_cases/*.wrong, with what the message must say.
#include "io/case/case_file.hpp"
#include "io/case/samples.hpp"
#include "model/parts/setup.hpp"
#include "support/catalogue.hpp"
#include "support/laws.hpp"
#include "support/process.hpp"

namespace wrong_cases_test {

const std::string folder = source_path("tests/io/case/wrong_cases/");

std::string replaced_law(const std::string& law) { return small_case.substr(0, small_case.find("model =")) + law; }

/// A good case of the catalogue: a file of its folder, or a change of small_case.
std::string good_case(const std::string& name)
{
  const std::map<std::string, std::string> made{{"small", small_case}, {"graded", small_case_on(graded)},
      {"four_sides", small_case_on(mapped)}, {"outline", small_case_on(polygon)},
      {"file", small_case_on("file = \"a.msh\"")},
      {"drained", replaced(small_case, "poisson_ratio = 0.48", "poisson_ratio = 0.3")}, {"two_clays", two_clays},
      {"wet", wet_soil},
      {"heavy", small_case + "[forces]\ngravity = [0, -9.81]\n[water]\nphreatic_line = [[0, 1.5]]\n"
                             "[initial]\nstress = \"k0\"\n"},
      {"staged", replaced(replaced(small_case, "[time]\nend = 4.0\n", ""), "box = [[0.0, 0.0], [8.0, 2.0]]\n",
                     "box = [[0.0, 0.0], [8.0, 2.0]]\n[[body]]\nname = \"berm\"\nmaterial = \"clay\"\n"
                     "box = [[8.0, 0.0], [9.0, 1.0]]\n") +
                     "[[stage]]\nname = \"a\"\nduration = 1.0\nramp = 0.0\n[[stage]]\nname = \"b\"\nduration = 1.0\n"
                     "ramp = 0.5\nplace = [\"berm\"]\n[[stage]]\nname = \"c\"\nduration = 1.0\nramp = 0.25\n"
                     "remove = [\"berm\"]\n"},
      {"user_law",
          replaced_law("model = \"library\"\nlibrary = \"" + law_folder() +
                       "/elastic.so\"\ninterface = \"native\"\nparameters = { stiffness = 2e6, poisson = 0.3 }\n"
                       "state = { shear_path = 0.5 }\ndensity = 1990.0\nshear_modulus = 2.0e6\n"
                       "poisson_ratio = 0.3\n")},
      {"sand", replaced_law("model = \"mohr_coulomb\"\ndensity = 1990.0\nshear_modulus = 2.0e6\npoisson_ratio = 0.3\n"
                            "cohesion = 1.0e3\nfriction_angle = 30.0\n")}};
  const auto found = made.find(name);
  return found != made.end() ? found->second : text_of(folder + name + ".toml");
}

/// What `terp run` says of a case in the file `path`, whose folder is left out of the message.
std::string message_of(const std::string& text, const std::string& path, const WrongRow& row, bool set_up)
{
  std::string message;
  try {
    const CaseFile file = read_case_text(text, path, row.changes);
    message = "accepted\n" + render_warnings(file);
    if (set_up) {
      Model model = build_model(file.values, 1);
      build_state(model);
    }
  } catch (const CaseError& error) {
    message = error.what();
  } catch (const InputError& error) {
    message = render(error.problems(), read_case_text(text, path));
  }
  const std::string before = path.substr(0, path.rfind('/') + 1);
  for (std::size_t at = 0; (at = message.find(before, at)) != std::string::npos;) message.erase(at, before.size());
  return message;
}

class WrongCases : public testing::Test {
 protected:
  WrongCases()
  {
    std::ofstream(scratch_.path() + "/a.msh"), std::ofstream(scratch_.path() + "/a.csv");
    std::filesystem::create_directory(scratch_.path() + "/folder");
  }
  const ScratchFolder scratch_;
};

TEST_F(WrongCases, ThatAreFilesHaveTheMessageOfTheCatalogue)
{
  for (const std::string kind : {"column", "polygon", "mapped"})
    for (const WrongRow& row : read_catalogue(folder + kind + ".wrong")) {
      const std::string path = folder + kind + ".toml", good = good_case(kind);
      EXPECT_EQ(message_of(good, path, {}, true).substr(0, 8), "accepted") << path;
      const std::string message = message_of(spoil(good, row), path, row, true);
      EXPECT_THAT(message, HasSubstr(row.expected)) << row.where;
      EXPECT_THAT(message, HasSubstr("error: " + kind + ".toml")) << row.where << ": the place is missing";
      EXPECT_THAT(message, HasSubstr("nothing was run.")) << row.where;
    }
}

TEST_F(WrongCases, ThatAreChangesOfASmallCaseHaveTheMessageOfTheCatalogue)
{
  std::vector<WrongRow> rows;
  for (const char* subject : {"small_case", "stages", "meshes", "water", "strength", "library"})
    std::ranges::copy(read_catalogue(folder + subject + ".wrong"), std::back_inserter(rows));
  EXPECT_GE(rows.size(), 400u);
  for (const WrongRow& row : rows) {
    const std::string good = good_case(row.name), path = scratch_.path() + "/case.toml";
    EXPECT_THAT(message_of(good, path, {}, false), StartsWith("accepted\n")) << row.name;
    const std::string message = message_of(spoil(good, row), path, row, false);
    EXPECT_THAT(message, HasSubstr(row.expected)) << row.where;
    if (row.verdict.starts_with("refused")) {
      EXPECT_THAT(message, HasSubstr("error: ")) << row.where;
      EXPECT_EQ(message.ends_with("\n1 error; nothing was run.\n"), row.verdict == "refused") << row.where << message;
      EXPECT_THAT(message, EndsWith("; nothing was run.\n")) << row.where;
    }
    if (row.verdict == "doubted") {
      EXPECT_THAT(message, StartsWith("accepted\nwarning: ")) << row.where;
    }
    if (row.verdict == "accepted") {
      EXPECT_EQ(message, "accepted\n") << row.where;
    }
  }
}

TEST_F(WrongCases, HaveAtMostEightFootings)
{
  std::string nine = small_case;
  for (const char name : std::string("abcdefghi"))
    nine +=
        std::string("[[footing]]\nbox = [[1.0, 2.0], [2.0, 2.5]]\nvelocity = [0.0, -0.1]\nname = \"") + name + "\"\n";
  EXPECT_THAT(message_for(nine), HasSubstr("a case has at most 8 footings"));
}

TEST_F(WrongCases, ABodyThatAStagePlacesInSoilOrOutsideOfTheMeshIsRefused)
{
  const auto said = [&](const std::string& box) {
    return message_of(
        replaced(good_case("staged"), "box = [[8.0, 0.0], [9.0, 1.0]]", box), scratch_.path() + "/case.toml", {}, true);
  };
  EXPECT_EQ(said("box = [[8.0, 0.0], [9.0, 1.0]]"), "accepted\n");
  EXPECT_THAT(said("box = [[7.0, 0.0], [9.0, 1.0]]"),
      HasSubstr(
          "error: case.toml:7:1: body `berm` is placed where body 0 is\n\n    7 | [[body]]\n      | ^^^^^^^^\n"
          "  100 of its points lie in it, the first at (7.05, 0.05) m. Draw it beside the other, or let an earlier "
          "stage remove that.\n"));
  EXPECT_THAT(said("box = [[15.0, 0.0], [17.0, 1.0]]"), HasSubstr("the body lies outside the mesh"));
}

TEST_F(WrongCases, WithOneMistakeHaveOneMessage)
{
  const auto with_water = [](const std::string& water) {
    const std::string shansep = "su_peak = { shansep = { S = 0.23, m = 0.9, pop = 15e3, water = \"high\" } }";
    std::string text = replaced(two_clays, "su_peak = 8.0e3", shansep);
    text = replaced(replaced(text, "su_peak = 4.0e3", shansep), "material = \"clay\"", "material = \"peat\"");
    return text + "[[body]]\nmaterial = \"clay\"\nbox = [[8.0, 0.0], [9.0, 1.0]]\n[[body]]\nmaterial = \"sand\"\n" +
           "box = [[9.0, 0.0], [9.5, 1.0]]\n[forces]\ngravity = [0, -9.81]\n" + water;
  };
  const auto said = [&](const std::string& text) { return message_of(text, scratch_.path() + "/case.toml", {}, true); };
  const std::string high = "[[water.situation]]\nname = \"high\"\nphreatic_line = [[0, 2.5]]\n";
  EXPECT_THAT(said(with_water("[water]\nphreatic_line = [[0, 1]]\n" + high)), StartsWith("accepted\n"));
  for (const auto& [water, message] :
      {std::pair<std::string, std::string>{
           "[water]\nphreatic_line = [[5, 1], [0, 2]]\n" + high, "case.toml:39:26: `phreatic_line` goes back in x"},
          {"[water]\nphreatic_line = [[0, 1]]\nreference_lines = [{ line = [[0, 0]], head = \"aquifer\" }]\n" + high,
              "there is no head line `aquifer`"},
          {"[water]\nphreatic_line = [[0, 1]]\nhead_lines = { a = [[0, 1]] }\nreference_lines = [{ line = [[0, 1], [8, "
           "0]], "
           "head = \"a\" }, { line = [[0, 0], [8, 1]], head = \"a\" }]\n" +
                  high,
              "One is above the other on one side of x = 4 m, below it on the other."}}) {
    EXPECT_THAT(said(with_water(water)), AllOf(HasSubstr(message), EndsWith("\n1 error; nothing was run.\n")));
  }
  std::string field = replaced(small_case, "su_peak = 8.0e3", "su_peak = \"1e3 - 1e3*y\"\nsensitivity = 2.0");
  field = replaced(replaced(field, "su_residual = 2.0e3\n", ""), "shear_modulus = 2.0e6", "stiffness_ratio = 100");
  EXPECT_THAT(said(field), AllOf(StartsWith("error: case.toml:14:11: `su_peak` is out of range in part of the soil"),
                               EndsWith("\n1 error; nothing was run.\n")));
}

TEST_F(WrongCases, PointAtTheChangeThatMadeAnOptionUseless)
{
  EXPECT_THAT(message_for(small_case + "[method]\nb_bar = true\n", {"scheme=standard_mpm"}),
      HasSubstr("warning: --set scheme=standard_mpm: `b_bar` has no effect\n"));
}

}  // namespace wrong_cases_test
