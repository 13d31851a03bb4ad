// Links to the program are followed first, then each folder above it is tried, the nearest one first. So a program that
// is built inside the sources finds their cases before those of an installation. Cases that are asked for come in the
// order of the request, each once.

#include "verify/find_cases.hpp"

#include "math/closest.hpp"
#include "math/errors.hpp"
#include "os/files.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string find_cases_folder()
{
  std::error_code error;
  const fs::path program = fs::canonical(program_file(), error);
  std::vector<std::string> tried;
  for (fs::path above = program.parent_path();; above = above.parent_path()) {
    for (const char* inside : {"cases/verification", "share/terp/cases/verification"}) {
      const fs::path folder = above / inside;
      if (fs::is_directory(folder, error)) return folder.string();
      tried.push_back(folder.string());
    }
    if (above == above.parent_path()) break;
  }
  throw FileError(fmt::format(
      "there are no verification cases beside the program. Looked for:\n  {}\n  Say where they are with --cases DIR.",
      fmt::join(tried, "\n  ")));
}

std::vector<std::string> names_of_cases(const std::string& folder)
{
  std::error_code error;
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (fs::exists(entry.path() / "expected.toml", error)) names.push_back(entry.path().filename().string());
  if (names.empty())
    throw FileError(fmt::format("{}: there are no verification cases: folders with an expected.toml", folder));
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> choose_cases(const std::string& folder, const std::vector<std::string>& wanted)
{
  const std::vector<std::string> names = names_of_cases(folder);
  if (wanted.empty()) return names;
  std::vector<std::string> chosen;
  for (const std::string& word : wanted) {
    const auto n = chosen.size();
    const bool begins = word.ends_with('*');
    for (const std::string& name : names)
      if (begins ? name.starts_with(word.substr(0, word.size() - 1)) : name == word) chosen.push_back(name);
    if (chosen.size() > n) continue;
    const std::string nearest = closest(word, names);
    throw FileError(fmt::format("there is no verification case `{}`.{}\n  Cases: {}", word,
        nearest.empty() ? "" : fmt::format(" Did you mean `{}`?", nearest), fmt::join(names, ", ")));
  }
  std::vector<std::string> once;  // each case once, however often it was named
  for (std::string& name : chosen)
    if (std::ranges::find(once, name) == once.end()) once.push_back(std::move(name));
  return once;
}

}  // namespace terp
