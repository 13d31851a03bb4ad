// The frame of a mechanism has its points where they were drawn, but no volumes. So the case is built again on the same
// mesh, in which the points have the same ids, and gives the sizes of the shades. Colours and arrows are scaled by
// quantiles instead of the largest value, so that few points do not set the scale of all others.

#include "io/files/mechanism_files.hpp"

#include "io/files/mesh_file.hpp"
#include "io/files/point_frames.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/section_svg.hpp"
#include "model/parts/setup.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>

namespace terp {
namespace {

constexpr Real few_arrows = 30.0;    // along the width of the section
constexpr Real longest_arrow = 1.2;  // over the distance between two
constexpr Real bright = 0.98;        // share of the points whose shear strain is below full colour

const std::vector<Real>& values_of(const Frame& frame, std::string_view name)
{
  return std::ranges::find(frame.fields, name, &PointField::name)->values;
}

Real quantile(std::vector<Real> sizes, Real share)
{
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<Real>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

std::vector<SectionOverlay::Shade> shades_of(const Frame& frame, const State& state)
{
  const std::vector<Real>& shear = values_of(frame, "shear_increment");
  const Real full = quantile(shear, bright);
  std::vector<SectionOverlay::Shade> shades;
  if (!(full > 0.0)) return shades;
  std::vector<Real> size(shear.size(), 0.0);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    size[id] = std::sqrt(block.row(Rows::volume)[lane]);
  });
  for (std::size_t k = 0; k < shear.size(); ++k)
    shades.push_back({{frame.x[2 * k], frame.x[2 * k + 1]}, size[k], std::min(shear[k] / full, 1.0)});
  return shades;
}

/// One in each square of a grid: the mean motion of its points.
std::vector<SectionOverlay::Arrow> arrows_of(const Frame& frame)
{
  struct Mean {
    Vec<2> x{0.0, 0.0}, dx{0.0, 0.0};
    Real n = 0.0;
  };
  const std::vector<Real>& motion = values_of(frame, "displacement_increment");
  Real low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k < frame.x.size(); k += 2)
    low = std::min(low, frame.x[k]), high = std::max(high, frame.x[k]);
  const Real side = (high - low) / few_arrows;
  std::map<std::pair<long, long>, Mean> squares;
  std::vector<Real> sizes;
  for (std::size_t k = 0; k < frame.x.size() / 2; ++k) {
    Mean& mean = squares[{std::lround(frame.x[2 * k] / side), std::lround(frame.x[2 * k + 1] / side)}];
    for (std::size_t d = 0; d < 2; ++d) mean.x[d] += frame.x[2 * k + d], mean.dx[d] += motion[3 * k + d];
    mean.n += 1.0;
    sizes.push_back(std::hypot(motion[3 * k], motion[3 * k + 1]));
  }
  const Real largest = quantile(sizes, 0.99);
  std::vector<SectionOverlay::Arrow> arrows;
  for (const auto& [place, m] : squares) {
    const Real size = std::hypot(m.dx[0], m.dx[1]) / m.n;
    if (!(size > 0.1 * largest)) continue;
    const Real scale = longest_arrow * side / std::max(largest, size) / m.n;
    arrows.push_back({{m.x[0] / m.n, m.x[1] / m.n}, {scale * m.dx[0], scale * m.dx[1]}});
  }
  return arrows;
}

}  // namespace

std::string draw_mechanism(const Case& quiet, const StabilityResult& result)
{
  const Mechanism& mechanism = *result.what_moves();
  Model model = build_model(quiet, result.mesh, 1);
  const State state = build_state(model);
  SectionOverlay overlay{.subtitle = fmt::format("{}, {} cells, mechanism with all strengths divided by {:.3f}",
                             quiet.scheme, model.mesh->n_cells(), mechanism.factor),
      .shades = shades_of(mechanism.frame, state),
      .arrows = arrows_of(mechanism.frame),
      .line = {},
      .of_shades = "shear strain in the last window",
      .of_arrows = "motion in the last window",
      .of_line = "slip surface"};
  if (mechanism.moving) overlay.line = mechanism.moving->line;
  return draw_section(model, state, overlay);
}

void write_mechanism(
    const std::string& folder, const Case& quiet, const StabilityResult& result, const std::string& run)
{
  const std::string own = path_in(folder, mechanism_folder);
  if (!result.what_moves()) {  // one of an earlier search would pass for that of this one
    std::error_code ignored;
    std::filesystem::remove(path_in(folder, mechanism_picture), ignored);
    remove_run(own);
    std::filesystem::remove(own, ignored);  // if nothing else is in it
    return;
  }
  make_folder(own);
  PointFrameWriter({own, point_frames, run}).append(result.what_moves()->frame);
  write_mesh(path_in(own, mesh_file), *result.mesh, run);
  write_file_atomically(path_in(folder, mechanism_picture), draw_mechanism(quiet, result));
}

}  // namespace terp
