// A law from a library as the rest of Terp sees it: a MaterialType with names of its own.
// Not for: how the library is called (interface.hpp).
#pragma once

#include "soil/laws/material.hpp"
#include "soil/libraries/library_case.hpp"

#include <limits>
#include <memory>
#include <string>

namespace terp {

inline constexpr std::string_view plastic_strain_name = "eps_eq_p";  ///< as in Terp's own laws

/// What the case says of a library that the library cannot say: what its state variables are to the rest of Terp, and
/// how long the arrays are that it is given.
struct LawTerms {
  std::string plastic_strain = {};  ///< name of the state variable; empty: eps_eq_p, if the law has that
  std::string strength = {};        ///< name of the state variable; empty: not known
  Real residual_strength = std::numeric_limits<Real>::quiet_NaN();  ///< that softening leaves [Pa]; NaN: not known
  Index n_components = 4;  ///< of stress and strain, NTENS: 4 of plane strain, or 6
};

/// Opens the library of a material and asks it what it knows. folder: of the case file. moduli: shear modulus [Pa] and
/// Poisson's ratio of the case. The names of the library's variables complete `library`. Throws InputError, whose
/// problems have the last part of the key alone: "library", "symbol", "parameters", "state". takes_turns: threads do,
/// whatever the library says of itself.
std::shared_ptr<const MaterialType> load_user_law(const std::string& material, const std::string& folder,
    std::span<const Real> moduli, LibraryCase& library, const LawTerms& terms = {}, bool takes_turns = false);

/// Of a law that load_user_law returned; nullptr: of a law of Terp.
const LawTerms* terms_of(const MaterialType& type);

}  // namespace terp
