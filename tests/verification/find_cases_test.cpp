#include "verification/find_cases.hpp"

#include "base/errors.hpp"
#include "support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Cases {
  Cases()
  {
    for (const char* name : {"bar", "column_1", "column_2", "no_case"})
      std::filesystem::create_directory(folder.path() + "/" + name);
    for (const char* name : {"bar", "column_1", "column_2"})
      std::ofstream(folder.path() + "/" + name + "/expected.toml") << "title = \"x\"\n";
  }
  test::ScratchFolder folder;
};

TEST(FindCases, ThoseOfTheSourceAreFoundFromTheProgram)
{
  EXPECT_THAT(names_of_cases(find_cases_folder()), testing::Contains("gravity_column"));
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
  try {
    choose_cases(cases.folder.path(), {"colum_1"});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(),
        "there is no verification case `colum_1`. Did you mean `column_1`?\n  Cases: bar, column_1, column_2");
  }
}

TEST(FindCases, AFolderWithoutCasesIsRefused)
{
  const test::ScratchFolder empty;
  try {
    names_of_cases(empty.path());
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there are no verification cases: folders with an expected.toml"));
  }
}

}  // namespace
}  // namespace terp
