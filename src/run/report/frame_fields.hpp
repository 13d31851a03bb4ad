// The fields of the material points that results show. Those that follow from any point are entries of one table here:
// name, unit, label, meaning, and how they are read; those of a row follow from its RowInfo, those of a law from its
// own tables. Frames, output.fields.names, `terp list`, `terp explain` and the report walk what is listed here. Not
// for: gathering them into a frame (frame.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <functional>
#include <span>

namespace terp {

struct FrameField {
  std::string name, unit;
  std::string label;       ///< of an axis or a colour scale
  std::string meaning;     ///< of a manual
  int n_components = 1;    ///< of a vector 3, with z = 0; of a tensor 4: xx yy zz xy
  bool by_default = true;  ///< written where output.fields.names is left out

  /// Reads the points of a block into those of a frame: places, by lane, `nowhere` if the point is not in it;
  /// values, shape [n_points, n_components]. Empty in the lists without a run.
  using Places = std::span<const std::size_t>;
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  std::function<void(const PointBlock<2>&, Places places, Real* values)> read = {};
};

/// Calls f(lane, out) for the points of a block that are in the frame; out: their n_components values.
template <class F>
void for_each_place(const PointBlock<2>& block, FrameField::Places places, int n_components, Real* values, F&& f)
{
  for (Index lane = 0; lane < block.n; ++lane)
    if (const std::size_t place = places[static_cast<std::size_t>(lane)]; place != FrameField::nowhere)
      f(lane, values + place * static_cast<std::size_t>(n_components));
}

/// Every field that the points of a run have, in the order of its files. Refers to model and state.
std::vector<FrameField> frame_fields(const Model& model, const State& state);
/// Every field that the points of some run may have, without `read`, each name once.
std::vector<FrameField> all_frame_fields();
/// Those of a law: its state, what follows from it, and its parameters that may vary.
std::vector<FrameField> frame_fields_of(const MaterialType& law);

/// Deviatoric measure of a strain tensor (xx yy zz xy): sqrt(1/2 e:e) (reading R18) [-].
Real deviatoric_strain(const std::array<Real, 4>& strain);
/// That of a point.
Real deviatoric_strain(const PointBlock<2>& block, Index lane);

}  // namespace terp
