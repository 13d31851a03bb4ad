// A surveyed ground as a table of distance and level, or as DAM's surfacelines.csv: with a base below it, it is a
// section of one soil. A table of soils by level, as DAM's soilprofiles.csv, makes layers of it.
// Not for: tables that a case names (model/bodies/csv_rows.hpp), which have one form.
#pragma once

#include "import/drawing/dxf_regions.hpp"

#include <optional>

namespace terp {

struct ProfileOptions {
  std::string name = {};          ///< of the profile in a table of several; empty: the only one
  Real unit = 0.0;                ///< [m]; 0: that of the heads of the columns, or m
  Real depth = 0.0;               ///< of the base below the lowest ground [m]; 0: `usual_depth`
  std::optional<Real> base = {};  ///< level of the base instead [m]
};
inline constexpr Real usual_depth = 10.0;  // [m]

/// One region, `ground`. Throws InputError.
DxfRegions read_profile(const std::string& path, std::string_view text, const ProfileOptions& options);

/// Level layers of soils below the ground of a profile. text: a table of the level of the top of each soil; of a table
/// of several profiles, `name` chooses one. The highest soil reaches up to the ground. Throws InputError.
DxfRegions with_soils(
    const DxfRegions& profile, const std::string& path, std::string_view text, const std::string& name);

}  // namespace terp
