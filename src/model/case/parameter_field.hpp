// A parameter of a law that varies over the soil, as a case has it: its value at each place at t = 0.
// Not for: the kinds of fields (soil_fields.hpp), nor the rows of the points that hold the values
// (point_parameters.hpp).
#pragma once

#include "math/types.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terp {

class Overburden;
struct CorrelationKind;

/// A place in the soil at t = 0, with what lies above it. It serves where a plain place is asked for.
struct PlaceInSoil {
  Vec<2> x;                            ///< [m]
  const Overburden* ground = nullptr;  ///< of the model; nullptr only for fields that do not ask for it

  operator const Vec<2>&() const { return x; }
};

/// Value at a place, in the unit of the parameter; not a number where it has none.
using FieldValue = std::function<Real(const PlaceInSoil&)>;

/// The part of the section that a file has values for.
struct FieldCover {
  std::string file;            ///< as the case names it
  Vec<2> low{0.0, 0.0}, high;  ///< corners of the box about its places [m]
};

/// What the pairs of a field are given for: from where to where, and what each place has of it.
struct FieldReach {
  std::string_view what, unit;  ///< "depth", "m"
  Real low, high;
  FieldValue argument;
};

/// Of a random field.
struct FieldScale {
  Vec<2> theta;                        ///< [m]
  const CorrelationKind* correlation;  ///< never null
};

/// What a field asks of the case beside the place.
struct FieldNeeds {
  bool outlines = false;                ///< the ground above a place: bodies that are drawn
  bool stress = false;                  ///< effective vertical stress: water, gravity, and bodies that are drawn
  std::vector<FieldCover> covers;       ///< of the files that it comes from
  std::vector<FieldReach> reaches;      ///< of the pairs that it is made of
  std::vector<FieldScale> scales;       ///< of the random fields that it is made of
  std::vector<std::string> situations;  ///< names of water that it asks for
  std::string stress_water = {};        ///< the water of sigma'_v, "start" that of t = 0; empty: it does not ask
  std::string daily_water = {};         ///< the same of sigma'_v,daily, from which sigma'_p follows
  FieldValue yield_stress = {};         ///< sigma'_p [Pa], of SHANSEP
};

struct ParameterField {
  std::size_t parameter;  ///< number in the law's table
  FieldValue value_at;
  std::string text = {};  ///< as the case file has it, on one line
  FieldNeeds needs = {};
  std::optional<std::size_t> follows = {};  ///< number of the parameter, which varies, that it is found from
};

/// A number beside which another parameter is found: a sensitivity. Not a number: not given.
struct RatioCase {
  Real value = std::numeric_limits<Real>::quiet_NaN();
  std::optional<ParameterField> field = {};  ///< instead of the value

  bool is_given() const { return field.has_value() || value == value; }
};

}  // namespace terp
