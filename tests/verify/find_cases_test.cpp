#include "verify/find_cases.hpp"
#include "math/errors.hpp"
#include "support/paths.hpp"

namespace find_cases_test {

struct Cases {
  Cases()
  {
    for (const char* name : {"bar", "column_1", "column_2", "no_case"})
      std::filesystem::create_directory(folder.path() + "/" + name);
    for (const char* name : {"bar", "column_1", "column_2"})
      std::ofstream(folder.path() + "/" + name + "/expected.toml") << "title = \"x\"\n";
  }
  ScratchFolder folder;
};

TEST(FindCases, ThoseOfTheSourceAreFoundFromTheProgram)
{
  EXPECT_THAT(names_of_cases(find_cases_folder()), Contains("gravity_column"));
}

TEST(FindCases, AllWithoutANameAndThoseThatBeginAlike)
{
  const Cases cases;
  EXPECT_THAT(choose_cases(cases.folder.path(), {}), ElementsAre("bar", "column_1", "column_2"));
  EXPECT_THAT(choose_cases(cases.folder.path(), {"column*"}), ElementsAre("column_1", "column_2"));
  EXPECT_THAT(choose_cases(cases.folder.path(), {"column_2"}), ElementsAre("column_2"));
}

TEST(FindCases, AWrongNameIsRefusedWithTheNearest)
{
  const Cases cases;
  EXPECT_EQ(refusal<FileError>([&] { choose_cases(cases.folder.path(), {"colum_1"}); }),
      "there is no verification case `colum_1`. Did you mean `column_1`?\n  Cases: bar, column_1, column_2");
}

TEST(FindCases, AFolderWithoutCasesIsRefused)
{
  const ScratchFolder empty;
  EXPECT_THAT(refusal<FileError>([&] { names_of_cases(empty.path()); }),
      HasSubstr("there are no verification cases: folders with an expected.toml"));
}

}  // namespace find_cases_test
