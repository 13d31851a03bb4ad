// A law fails in two ways. A fault that comes back is kept as text. Of several faults that of the least cell and number
// stays, so that the order of threads does not decide. Where the law ends the program, its memory may be damaged: that
// text is made with snprintf in fixed arrays alone.

#include "soil/libraries/library_material.hpp"

namespace terp {
namespace {

constexpr const char* what_is_left =
    "  left     what was written before, and the checkpoints, if any (docs/user_laws.md#when-the-law-fails)";
constexpr const char* other_numbers =
    "  likely   it reads beyond `parameters` or `state` of the case: this was a trial with other numbers there";

}  // namespace

/// Asks for no memory.
void LibraryMaterial::describe_place(const LawPoints& points, std::array<char, 256>& text) const
{
  const char* const what = points.of_gauss_points ? "Gauss point" : "material point";
  const auto number = [&](int p) { return static_cast<long long>(points.id[p]); };
  const bool known = points.is_at_a_point() || points.n == 1;
  const int p = points.is_at_a_point() ? points.at : 0, last = points.n - 1;
  if (known)
    std::snprintf(text.data(), text.size(), "%s %lld of cell %d at x = %.4g m, y = %.4g m", what, number(p),
        points.cell[p], points.x[0][p], points.x[1][p]);
  else
    std::snprintf(text.data(), text.size(),
        "one of %d %ss that it had at once, from %lld of cell %d at x = %.4g m, y = %.4g m to %lld of cell %d at x = "
        "%.4g m, y = %.4g m",
        points.n, what, number(0), points.cell[0], points.x[0][0], points.x[1][0], number(last), points.cell[last],
        points.x[0][last], points.x[1][last]);
}

/// Asks for no memory.
void LibraryMaterial::describe_exit(const LawPoints& points, const char* why, char* text, std::size_t n) const
{
  std::array<char, 256> place;
  describe_place(points, place);
  std::snprintf(text, n,
      "the law of material `%s` %s in the step after t = %.4f s\n\n"
      "  where    %s\n"
      "  library  %s\n%s",
      in_use_.material.c_str(), why, points.time, place.data(), in_use_.title.c_str(),
      points.beyond == NumbersBeyond{} ? what_is_left : other_numbers);
}

std::string LibraryMaterial::describe_input(const LawPoints& points, const PointsBefore& before) const
{
  if (!points.is_at_a_point()) return {};
  const int p = points.at;
  return fmt::format(
      "  before   stress xx yy zz xy = {} Pa; strain increment {}; dt = {:.3g} s\n"
      "           state {}\n",
      list_of(4, [&](std::size_t k) { return before.sigma[k][p] * in_use_.stress_unit; }),
      list_of(4, [&](std::size_t k) { return points.d_eps[k][p]; }), points.dt,
      list_of(in_use_.n_state, [&](std::size_t k) { return before.state[k * most_points_of_call + p]; }));
}

void LibraryMaterial::keep_fault(const LawPoints& points, const PointsBefore& before) const
{
  const auto advice =
      points.cure != nullptr ? points.cure : "the law with these numbers by itself; then mend the library";
  std::array<char, 256> place;
  describe_place(points, place);
  std::string text = fmt::format(
      "{}\n\n"
      "  where    material `{}`, {}\n"
      "  library  {}\n"
      "{}"
      "  try      {}",
      points.why.data(), in_use_.material, place.data(), in_use_.title, describe_input(points, before), advice);
  faults_([&] {
    const int p = points.is_at_a_point() ? points.at : 0;
    const std::pair number(points.cell[p], points.id[p]);
    if (has_fault_ && number >= place_of_fault_) return;
    place_of_fault_ = number;
    fault_ = std::move(text);
    has_fault_ = true;
  });
}

}  // namespace terp
