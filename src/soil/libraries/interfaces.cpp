// The table of interfaces: a new one is a file like umat.cpp, a line here, and a word in LawInterface.

#include "soil/libraries/interface.hpp"

#include <algorithm>

namespace terp {

std::optional<LawVariables> describe_native(void* symbol, LibraryCase& library);
std::optional<LawVariables> describe_udsm(void* symbol, LibraryCase& library);

namespace {

std::optional<LawVariables> say_nothing(void*, LibraryCase&) { return std::nullopt; }

constexpr std::string_view native_symbols[] = {"terp_law"};
constexpr std::string_view umat_symbols[] = {"umat_", "umat", "UMAT"};
constexpr std::string_view esm_symbols[] = {"esm_", "esm", "ESM"};
constexpr std::string_view udsm_symbols[] = {"user_mod_", "user_mod", "User_Mod", "USER_MOD"};

constexpr InterfaceInfo interfaces[] = {
    {"native", native_symbols, "Terp's own, in C, on blocks of points (terp_law.h)", &describe_native, &make_native},
    {"umat", umat_symbols, "user material of Abaqus/Standard, in plane strain", &say_nothing, &make_umat},
    {"esm", esm_symbols, "external soil model of Anura3D, in plane strain", &say_nothing, &make_esm},
    {"udsm", udsm_symbols, "user-defined soil model of Plaxis, USER_MOD", &describe_udsm, &make_udsm},
};

}  // namespace

std::span<const InterfaceInfo> law_interfaces() { return interfaces; }

bool keeps(const LibraryCase& library, std::string_view kinematics)
{
  return std::ranges::find(library.kinematics, kinematics) != library.kinematics.end();
}

}  // namespace terp
