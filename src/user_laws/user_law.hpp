// A law from a library as the rest of Terp sees it: a MaterialType with names of its own.
// Not for: how the library is called (interface.hpp).
#pragma once

#include "materials/material.hpp"
#include "user_laws/library_case.hpp"

#include <memory>
#include <string>

namespace terp {

/// Opens the library of a material and asks it what it knows. folder: of the case file. moduli: shear modulus [Pa] and
/// Poisson's ratio of the case. The names of the library's variables complete `library`. Throws InputError, whose
/// problems have the last part of the key alone: "library", "symbol", "parameters", "state". takes_turns: threads do,
/// whatever the library says of itself.
std::shared_ptr<const MaterialType> load_user_law(const std::string& material, const std::string& folder,
    std::span<const Real> moduli, LibraryCase& library, bool takes_turns = false);

}  // namespace terp
