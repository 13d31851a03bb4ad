// What soil lies above what, along vertical lines through the outlines of the bodies. Not for: points, nor soil that
// has moved.
#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/parts/model.hpp"

#include <vector>

namespace terp {

/// A stretch of a vertical line in one material; -1: in none.
struct SoilPiece {
  Index material;
  Real top, base;  ///< [m]
  Real height() const { return top - base; }
};

class SoilPieces {
 public:
  /// tolerance: gaps between outlines that are no gaps [m].
  SoilPieces(const Model& model, Real tolerance);

  /// From the top down.
  std::vector<SoilPiece> at(Real x) const;

 private:
  Index material_at(Real x, Real y) const;

  const Model& model_;
  Real tolerance_;
  std::vector<std::vector<Side>> sides_;  // of each body
};

/// False with a body that came as points, which has no outline.
bool has_outlines(const Model& model);

}  // namespace terp
