#include "import_checks.hpp"

#include "input/case_file.hpp"
#include "input/printable.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

enum class Of { both, stix, drawing };      // kind of file
enum class In { both, list, case_folder };  // what is made of it

struct ImportOption {
  const char* name;
  bool is_given;
  Of file;
  In result;
};

[[noreturn]] void refuse_option(const ImportOption& option, const std::string& what, const std::string& cure)
{
  throw CaseError(printable(fmt::format("error: {} {}\n  {}\n", option.name, what, cure)));
}

}  // namespace

void refuse_unused_options(const ImportCommand& command, bool is_drawing)
{
  const ImportOption options[] = {{"--slices", !command.slices.empty(), Of::stix, In::list},
      {"--json", command.json, Of::stix, In::list}, {"--force", command.force, Of::both, In::case_folder},
      {"--scenario", command.scenario != 0, Of::stix, In::case_folder},
      {"--stage", command.stage != 0, Of::stix, In::case_folder},
      {"--strength", !command.strength.empty(), Of::stix, In::case_folder},
      {"--cell", command.cell != 0.0, Of::both, In::case_folder},
      {"--between", !command.between.empty(), Of::both, In::case_folder},
      {"--base", command.base.has_value(), Of::both, In::case_folder},
      {"--unit", !command.unit.empty(), Of::drawing, In::both},
      {"--trigger", !command.trigger.empty(), Of::stix, In::case_folder},
      {"--river", command.river.has_value(), Of::stix, In::case_folder},
      {"--held", command.is_held, Of::stix, In::case_folder},
      {"--soil-defaults", !command.soil_defaults.empty(), Of::both, In::case_folder}};
  const Of file = is_drawing ? Of::drawing : Of::stix;
  const In result = command.output.empty() ? In::list : In::case_folder;
  for (const ImportOption& option : options) {
    if (!option.is_given) continue;
    if (option.file != Of::both && option.file != file)
      refuse_option(option, fmt::format("is of {}", option.file == Of::stix ? "D-Stability files" : "drawings"),
          fmt::format("{} is a {}. Leave the option out.", command.path, is_drawing ? "drawing" : "D-Stability file"));
    if (option.result == In::case_folder && result == In::list)
      refuse_option(option, "has no effect without -o", "Give a folder for the case, -o FOLDER, or leave it out.");
    if (option.result == In::list && result == In::case_folder)
      refuse_option(option, "is not written with -o", "Make the list and the case one after the other.");
  }
}

}  // namespace terp
