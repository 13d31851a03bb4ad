// What a library offers, and whether it goes with what the case file says of it.
// Not for: calling its law (library_material.hpp).
#pragma once

#include "soil/libraries/interface.hpp"
#include "soil/libraries/user_law.hpp"

namespace terp {

struct FoundLibrary {
  std::string path;  ///< of the file
  std::shared_ptr<const SharedLibrary> library;
  std::string symbol;  ///< of the function that was found
  void* function = nullptr;
};

/// Opens the library and finds its function. Throws InputError (user_law.hpp).
FoundLibrary find_library(const std::string& folder, const LibraryCase& library);

/// Units that the case gives to its state variables, in their order, as in "p_0 [kPa]"; the names are left without.
/// Throws InputError.
std::vector<std::string> take_units(LibraryCase& library);

/// Refuses roles that state variables of these names and values at t = 0 cannot have. Throws InputError.
void check_terms(const LibraryCase& library, const LawTerms& terms);

/// Completes `library` with what the library says of its parameters and state: an order, names, initial values.
/// Returns nothing where it cannot say anything. Throws InputError.
std::optional<LawVariables> describe_library(const FoundLibrary& found, LibraryCase& library);

}  // namespace terp
