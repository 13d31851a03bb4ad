// A catalogue of wrong case files: one line each in wrong_cases/*.wrong, with what the message must say.
#include "input/case_file.hpp"
#include "simulation/setup.hpp"
#include "support/paths.hpp"
#include "support/process.hpp"

#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>

namespace terp {
namespace {

const std::string folder = test::source_path("tests/input/wrong_cases/");

struct WrongCase {
  std::string where;  ///< "column.wrong:3"
  std::string before, after, expected;
};

std::string unescaped(std::string text)
{
  for (const auto& [mark, character] : {std::pair{"\\n", '\n'}, std::pair{"\\0", '\0'}})
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
      text.replace(at, 2, 1, character);
  return text;
}

std::vector<WrongCase> read_table(const std::string& name)
{
  std::istringstream lines(test::text_of(folder + name));
  std::vector<WrongCase> cases;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.starts_with('#')) continue;
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 2);
    const std::string where = name + ':' + std::to_string(number);
    EXPECT_NE(second, std::string::npos) << where;
    const std::size_t after = std::min(first + 3, second);
    cases.push_back(
        {where, line.substr(0, first), unescaped(line.substr(after, second - after)), line.substr(second + 3)});
  }
  return cases;
}

/// The case with its fault.
std::string spoil(const std::string& good, const WrongCase& wrong)
{
  if (wrong.before.empty()) return good + wrong.after;
  const std::size_t at = good.find(wrong.before);
  EXPECT_NE(at, std::string::npos) << wrong.where << ": the case does not hold `" << wrong.before << '`';
  EXPECT_EQ(good.find(wrong.before, at + 1), std::string::npos) << wrong.where << ": the case holds it twice";
  return std::string(good).replace(at, wrong.before.size(), wrong.after);
}

/// What `terp run` says of it; empty if it would run.
std::string message_of(const std::string& text, const std::string& path)
{
  try {
    const CaseFile file = read_case_text(text, path);
    try {
      Model model = build_model(file.values, 1);
      build_state(model);
    } catch (const InputError& error) {
      return render(error.problems(), file);
    }
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

int try_table(const std::string& kind)
{
  const std::string path = folder + kind + ".toml", good = test::text_of(path);
  EXPECT_EQ(message_of(good, path), "") << path;
  const auto cases = read_table(kind + ".wrong");
  for (const WrongCase& wrong : cases) {
    const std::string message = message_of(spoil(good, wrong), path);
    EXPECT_THAT(message, testing::HasSubstr(wrong.expected)) << wrong.where;
    EXPECT_THAT(message, testing::HasSubstr("error: " + path)) << wrong.where << ": the place is missing";
    EXPECT_THAT(message, testing::HasSubstr("nothing was run.")) << wrong.where;
  }
  return static_cast<int>(cases.size());
}

TEST(WrongCases, EachHasTheMessageOfTheCatalogue)
{
  int n = 0;
  for (const char* kind : {"column", "polygon", "mapped"}) n += try_table(kind);
  EXPECT_GE(n, 60);
}

}  // namespace
}  // namespace terp
