// The words for a law of a library that failed.

#include "user_laws/library_material.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

std::string list_of(int n, auto&& value)
{
  std::string text;
  for (int k = 0; k < n; ++k) text += fmt::format("{}{:.6g}", k == 0 ? "" : ", ", value(k));
  return n == 0 ? "none" : text;
}

constexpr const char* what_is_left =
    "  left     the checkpoints written so far are whole; with a mended library go on from the newest one:\n"
    "           terp run CASE.toml --from RUN_FOLDER -o NEW_FOLDER (docs/user_laws.md)";

}  // namespace

std::string LibraryMaterial::describe_place(const LawPoints& points) const
{
  const int p = points.at < points.n ? points.at : 0;
  return fmt::format("{} {} of cell {} at x = {:.4g} m, y = {:.4g} m",
      points.of_gauss_points ? "Gauss point" : "material point", points.id[p], points.cell[p], points.x[0][p],
      points.x[1][p]);
}

std::string LibraryMaterial::describe_exit(const LawPoints& points) const
{
  return fmt::format(
      "the law of material `{}` ended the program (STOP, XIT or exit) in the step after t = {:.4f} s\n\n"
      "  where    {}\n"
      "  library  {}\n{}",
      in_use_.material, points.time, describe_place(points), in_use_.title, what_is_left);
}

void LibraryMaterial::keep_fault(const LawPoints& points, const PointsBefore& before) const
{
  const int p = points.at;
  const auto advice = points.wants_smaller ? "a lower time.courant, or a law that takes larger increments"
                                           : "the law with these numbers by itself; then mend the library";
  std::string text = fmt::format(
      "{}\n\n"
      "  where    material `{}`, {}\n"
      "  library  {}\n"
      "  before   stress xx yy zz xy = {} Pa; strain increment {}; dt = {:.3g} s\n"
      "           state {}\n"
      "  try      {}\n{}",
      points.why.data(), in_use_.material, describe_place(points), in_use_.title,
      list_of(4, [&](int k) { return before.sigma[k][p] * in_use_.stress_unit; }),
      list_of(4, [&](int k) { return points.d_eps[k][p]; }), points.dt,
      list_of(static_cast<int>(in_use_.n_state), [&](int k) { return before.state[k * most_points_of_call + p]; }),
      advice, what_is_left);
  faults_([&] {
    const std::pair place(points.cell[p], points.id[p]);
    if (has_fault_ && place >= place_of_fault_) return;
    place_of_fault_ = place;
    fault_ = std::move(text);
    has_fault_ = true;
  });
}

}  // namespace terp
