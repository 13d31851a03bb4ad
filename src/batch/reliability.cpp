// OpenTURNS and the ninety libraries that it brings are opened by the first study that asks for them. Linked to the
// program they took four fifths of the time that each start needs.

#include "batch/reliability.hpp"

#include "io/case/case_file.hpp"
#include "os/shared_library.hpp"
#include "os/files.hpp"

#include <filesystem>

namespace terp {
namespace {

/// Empty: there is none.
std::string openturns_library()
{
  std::error_code ignored;
  const auto folder = std::filesystem::canonical(program_file(), ignored).parent_path();
  if (folder.empty()) return {};
  for (const char* place : {"", "../lib/terp"})  // as built, as installed
    if (const auto file = folder / place / "terp_openturns.so"; std::filesystem::exists(file, ignored))
      return file.string();
  return {};
}

std::string advice(const ReliabilityRule& rule, const std::string& reason)
{
  return "error: `" + std::string(info_of(rule.kind).name) + "` needs OpenTURNS, " + reason +
         "\n  Install it with `tools/install-dependencies --study`, or libopenturns-dev of Debian, and build again.\n";
}

}  // namespace

bool has_openturns() { return !openturns_library().empty(); }

ReliabilityResult find_probability(const ReliabilityRule& rule, const LimitState& limit)
{
  using Find = void(const ReliabilityRule&, const LimitState&, ReliabilityResult&);
  static const SharedLibrary* library = nullptr;  // never closed: its threads may live as long as the program
  try {
    if (library == nullptr && has_openturns()) library = new SharedLibrary(openturns_library());
  } catch (const FileError& error) {
    throw CaseError(advice(rule, std::string("which cannot be opened. ") + error.what()));
  }
  if (library == nullptr) throw CaseError(advice(rule, "which this terp was built without"));
  const auto layout = static_cast<const std::size_t*>(library->find("terp_reliability_layout"));
  const auto find = reinterpret_cast<Find*>(library->find("terp_find_probability"));
  if (layout == nullptr || *layout != reliability_layout || find == nullptr)
    throw CaseError(advice(rule, "and " + openturns_library() + " is that of another terp"));
  ReliabilityResult result;
  find(rule, limit, result);
  return result;
}

}  // namespace terp
