// How the soil fails in a trial that does not stand: which part of it moves, along which surface, which way. Taken from
// the motion in the last window of the trial, in which elastic strain hardly grows any more. Definitions:
// docs/stability.md. Not for: files and pictures (io/files).
#pragma once

#include "model/ground/section.hpp"
#include "model/parts/model.hpp"
#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"
#include "run/stability/soil_motion.hpp"

#include <optional>
#include <string>

namespace terp {

/// Points as they are at the end of a window, by id: of the trial, in the scale of its own stiffness.
struct PointMotion {
  std::vector<Real> x;       ///< shape [n_points, 2] [m]
  std::vector<Real> strain;  ///< shape [n_points, 4], xx yy zz xy [-]
};

PointMotion look_at_points(const State& state);

/// Along the top of drained soil, where a row of cells carries more than that top (run/findings/weak_borders.hpp).
struct BorderUnderSlip {
  std::string soil;                         ///< name of the soil below
  Real from = 0.0, to = 0.0;                ///< x [m]
  Real row = 0.0;                           ///< height of the row [m]
  Real carried_more = 0.0, strength = 0.0;  ///< of the row, and of all of the slip surface, as reduced [N per m]
  Real share() const { return carried_more / strength; }
};

/// The part that moves, which is one connected stretch of columns.
struct MovingSoil {
  Facing way = Facing::right;    ///< to which it moves
  Facing slope = Facing::right;  ///< on which side of the highest ground its exit lies
  std::vector<Vec<2>> line;  ///< the slip surface from left to right [m]: where the ground is cut, a place per column,
                             ///< where the ground is cut again
  Vec<2> entry{0.0, 0.0}, exit{0.0, 0.0};  ///< its ends behind the slide and in front of it [m]
  Real highest_x = 0.0;                    ///< middle of the highest ground [m]
  Real depth = 0.0;                        ///< of the slip surface below the ground, the largest [m]
  Real area = 0.0;                         ///< of the soil above it [m^2]
  std::string sand = {};  ///< name of the soil without cohesion that most of it is of; empty: other soil
  std::optional<BorderUnderSlip> border = {};  ///< that carries most more; none: the slip surface follows none
  Real other_way = 0.0;  ///< share of the motion, by volume, of the soil that moves to the other side [-]
};

/// Strains and displacements are those of the soil as it is, before it was stiffened.
struct Mechanism {
  Real factor = 0.0;                 ///< of the trial
  Real stiffening = 1.0;             ///< by which the trial's own were multiplied
  std::optional<MovingSoil> moving;  ///< none: nothing moved in the last window
  /// Points as they are at rest, with `displacement` since then [m], `displacement_increment` [m] and
  /// `shear_increment` [-] in the last window, `stress` at its end [Pa], `material`, `cell`, and, with water,
  /// `pore_pressure` [Pa].
  Frame frame;
};

/// before, now: the ends of the last two windows. judged: points whose motion counts. Without the factor of the trial.
Mechanism find_mechanism(const Model& model, const State& state, const PointMotion& before, const PointMotion& now,
    const Judged& judged, Real stiffening);

}  // namespace terp
