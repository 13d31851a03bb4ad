// Options of terp import and assess that were given, and those of them that would have no effect.

#include "cli/import_options.hpp"
#include "io/case/case_file.hpp"
#include "io/case/printable.hpp"

#include <fmt/ranges.h>

namespace terp {
namespace {

enum class Of { all, stix, drawn, drawing, profile };  // kinds of file; drawn: drawings and profiles
enum class In { both, list, case_folder };             // what is made of it

struct ImportOption {
  const char* name;
  std::string value;  ///< empty: it is not given; " ": it has none
  Of file;
  In result;
};

std::vector<ImportOption> import_options(const ImportCommand& c)
{
  const auto flag = [](bool is_given) { return std::string(is_given ? " " : ""); };
  const auto number = [](auto value) { return value == 0 ? "" : fmt::format("{}", value); };
  const auto level = [](const auto& value) { return value ? fmt::format("{}", *value) : ""; };
  return {{"--slices", c.slices, Of::stix, In::list}, {"--json", flag(c.json), Of::stix, In::list},
      {"--force", flag(c.force), Of::all, In::case_folder},
      {"--scenario", number(c.scenario), Of::stix, In::case_folder},
      {"--stage", number(c.stage), Of::stix, In::case_folder}, {"--strength", c.strength, Of::stix, In::case_folder},
      {"--cell", number(c.cell), Of::all, In::case_folder},
      {"--between", fmt::format("{}", fmt::join(c.between, ",")), Of::all, In::case_folder},
      {"--base", level(c.base), Of::all, In::case_folder}, {"--unit", c.unit, Of::drawn, In::both},
      {"--layers", c.layers, Of::drawn, In::both},
      {"--window", fmt::format("{}", fmt::join(c.window, ",")), Of::drawing, In::both},
      {"--depth", number(c.depth), Of::profile, In::both}, {"--soils", c.soils, Of::profile, In::both},
      {"--river", level(c.river), Of::stix, In::case_folder}, {"--held", flag(c.is_held), Of::stix, In::case_folder},
      {"--study", flag(c.study), Of::stix, In::case_folder}, {"--no-film", flag(c.no_film), Of::stix, In::case_folder},
      {"--face-cohesion", level(c.face_cohesion), Of::stix, In::case_folder},
      {"--soil-defaults", c.soil_defaults, Of::all, In::case_folder},
      {"--trigger", c.trigger, Of::stix, In::case_folder}};
}

[[noreturn]] void refuse_option(const ImportOption& option, const std::string& what, const std::string& cure)
{
  throw CaseError(printable(fmt::format("error: {} {}\n  {}\n", option.name, what, cure)));
}

}  // namespace

std::vector<std::string> given_options(const ImportCommand& command)
{
  std::vector<std::string> given;
  for (const ImportOption& option : import_options(command))
    if (!option.value.empty()) given.push_back(fmt::format("{} {}", option.name, option.value));
  return given;
}

void refuse_unused_options(const ImportCommand& command, SectionFile kind)
{
  const In result = command.output.empty() ? In::list : In::case_folder;
  const char* const kinds[] = {"D-Stability file", "drawing", "ground profile"};
  const auto acts = [&](Of file) {
    if (file == Of::drawn) return kind != SectionFile::dstability;
    if (file == Of::drawing) return kind == SectionFile::drawing;
    return file == Of::all || kind == (file == Of::stix ? SectionFile::dstability : SectionFile::profile);
  };
  for (const ImportOption& option : import_options(command)) {
    if (option.value.empty()) continue;
    if (!acts(option.file))
      refuse_option(option,
          fmt::format("is of {}", option.file == Of::stix      ? "D-Stability files"
                                  : option.file == Of::profile ? "ground profiles"
                                                               : "drawings"),
          fmt::format("{} is a {}. Leave the option out.", command.path, kinds[static_cast<int>(kind)]));
    const bool is_base_of_profile = kind == SectionFile::profile && option.name == std::string_view("--base");
    if (option.result == In::case_folder && result == In::list && !is_base_of_profile)
      refuse_option(option, "has no effect without -o", "Give a folder for the case, -o FOLDER, or leave it out.");
    if (option.result == In::list && result == In::case_folder)
      refuse_option(option, "is not written with -o", "Make the list and the case one after the other.");
  }
}

void refuse_options_beside_study(const ImportCommand& command)
{
  if (!command.study) return;
  for (const ImportOption& option : import_options(command)) {
    const std::string name = option.name;
    if (name == "--strength" && !option.value.empty() && option.value != "mean")
      refuse_option(option, "does not go with --study", "A study starts from the means: leave --strength out.");
    if (name == "--trigger" && !option.value.empty())
      refuse_option(option, "does not go with --study",
          "A study asks how probable a slide is, a trigger makes one. Leave one of the two out.");
  }
}

std::string ignored_options(const ImportCommand& given, bool is_changed_by_hand)
{
  std::vector<std::string> options = given_options(given);
  if (is_changed_by_hand) std::erase_if(options, [](const std::string& o) { return !o.starts_with("--trigger"); });
  if (options.empty()) return "";
  return printable(fmt::format("{} {} not applied: {}", fmt::join(options, ", "), options.size() > 1 ? "were" : "was",
      is_changed_by_hand ? "the case was changed by hand, and is solved as it stands; --force imports it anew"
                         : "a case file is run as it is"));
}

}  // namespace terp
