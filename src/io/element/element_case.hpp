// The case of an element test: a case file, or materials alone.
#pragma once

#include "io/case/case_file.hpp"

namespace terp {

/// As read_case, of a file that may leave out mesh and bodies. Throws CaseError.
CaseFile read_element_case(const std::string& path, const std::vector<std::string>& overrides = {});
CaseFile read_element_case_text(
    const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {});

/// The materials of these names, in the order of the case; all of them where no name is given. Throws InputError for a
/// name that the case does not have.
std::vector<const MaterialCase*> materials_of_element(const Case& c, const std::vector<std::string>& names);

/// Stress with which a soil begins: that of the first of its bodies that gives one, else 100 kPa from all sides.
std::array<Real, 4> start_of_element(const Case& c, const MaterialCase& material);

}  // namespace terp
