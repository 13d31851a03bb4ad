// The axes of a law whose strength depends on the direction of shearing. They stay where they are while the soil turns.
// A parameter of this name says to the rest of Terp that a law has axes: `terp check` compares them with gravity.
#pragma once

#include "soil/laws/material.hpp"
#include "math/pack.hpp"

#include <numbers>

namespace terp {

inline constexpr ParameterInfo axis_angle_info{.name = "axis_angle",
    .unit = "deg",
    .range = between(-45.0, 45.0),
    .typical = 5.0,
    .meaning = "angle of the soil's vertical from y, anticlockwise; of gravity [9.81 sin(a), -9.81 cos(a)] it is a",
    .fallback = 0.0,
    .may_vary = true};

/// Turns the shear x = (xx - yy)/2, y = xy of a tensor into the axes, and back.
template <class P>
struct MaterialAxes {
  P cos_2, sin_2;  ///< of twice the angle, which is at most 90 degrees

  MaterialAxes(P cos, P sin) : cos_2(cos), sin_2(sin) {}
  explicit MaterialAxes(P degrees) : cos_2(0.0), sin_2(sine(degrees * (std::numbers::pi / 90.0)))
  {
    cos_2 = sqrt(max(P(0.0), P(1.0) - sin_2 * sin_2));
  }

  template <class R>
  void enter(R& x, R& y) const
  {
    const R along = R(cos_2) * x + R(sin_2) * y;
    y = R(cos_2) * y - R(sin_2) * x;
    x = along;
  }
  template <class R>
  void leave(R& x, R& y) const
  {
    const R along = R(cos_2) * x - R(sin_2) * y;
    y = R(cos_2) * y + R(sin_2) * x;
    x = along;
  }
};

}  // namespace terp
