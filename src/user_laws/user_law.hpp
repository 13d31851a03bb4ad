// A law from a library as the rest of Terp sees it: a MaterialType with names of its own.
// Not for: how the library is called (interface.hpp).
#pragma once

#include "materials/material.hpp"
#include "user_laws/library_case.hpp"

#include <limits>
#include <memory>
#include <string>

namespace terp {

inline constexpr std::string_view plastic_strain_name = "eps_eq_p";  ///< as in Terp's own laws

/// What the state variables of a library are to the rest of Terp: the case says it, since the library cannot.
struct LawRoles {
  std::string plastic_strain = {};  ///< name of the state variable; empty: eps_eq_p, if the law has that
  std::string strength = {};        ///< name of the state variable; empty: not known
  Real residual_strength = std::numeric_limits<Real>::quiet_NaN();  ///< that softening leaves [Pa]; NaN: not known
};

/// Opens the library of a material and asks it what it knows. folder: of the case file. moduli: shear modulus [Pa] and
/// Poisson's ratio of the case. The names of the library's variables complete `library`. Throws InputError, whose
/// problems have the last part of the key alone: "library", "symbol", "parameters", "state". takes_turns: threads do,
/// whatever the library says of itself.
std::shared_ptr<const MaterialType> load_user_law(const std::string& material, const std::string& folder,
    std::span<const Real> moduli, LibraryCase& library, const LawRoles& roles = {}, bool takes_turns = false);

/// Of a law that load_user_law returned; nullptr: of a law of Terp.
const LawRoles* roles_of(const MaterialType& type);

}  // namespace terp
