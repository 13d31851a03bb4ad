// What `terp import` and `terp assess` make of the options that they share.
#pragma once

#include "math/errors.hpp"
#include "cli/commands.hpp"
#include "import/dstability/case_folder.hpp"
#include "import/dstability/foreign_file.hpp"

#include <optional>

namespace terp {

/// Throws CaseError: what is wrong, and what to do.
[[noreturn]] void refuse_import(const std::string& what, const std::string& cure);
/// Faults of a file in the words of the other commands.
[[noreturn]] void refuse_import(const std::string& path, const InputError& error);

std::vector<SoilKind> soil_kinds(const ImportCommand& command);
std::optional<Vec<2>> between_of(const ImportCommand& command);

/// Throws CaseError if an option is of the other kind of file, or of the other of list and case folder.
void refuse_unused_options(const ImportCommand& command, SectionFile kind);
/// Strengths that are not the means, and a trigger.
void refuse_options_beside_study(const ImportCommand& command);
/// With their values: "--cell 0.5".
std::vector<std::string> given_options(const ImportCommand& command);
/// Which of the options given do not act on a section whose case is run as it is, and why. Empty: none was given.
/// One that was changed by hand has all of them but the trigger: with others it is refused.
std::string ignored_options(const ImportCommand& given, bool is_changed_by_hand);

/// Numbers as the list has them, from 1. Left out: the only scenario, its last stage.
FolderOptions folder_options(const StixProject& project, const ImportCommand& command);

/// Whether the trigger needs the factor of safety first.
bool asks_for_search(const FolderTrigger& trigger);

/// Finds by how much the soil must be weaker to slide. The case as it is stands in the folder afterwards, the search in
/// its folder stability/. Throws RunError where no factor was found, or the search was stopped.
FolderTrigger find_weakness(
    const StixProject& project, FolderOptions options, const std::string& folder, const RunOptions& run);
FoundFactors factors_of(const StabilityResult& result);

void write_case_folder(const std::string& path, const CaseFolder& folder);

}  // namespace terp
