// Rows are numbered one behind another in the order in which they are added, and a number never changes afterwards. So
// whoever adds a row may keep its number. Laws that have a quantity of the same name share its rows, because a point
// belongs to one material and needs them once.

#include "soil/row_table.hpp"

#include "math/errors.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {

bool RowInfo::is_of(Index material) const { return of.empty() || std::ranges::find(of, material) != of.end(); }

Real RowInfo::initial_in(Index material) const
{
  const auto own = std::ranges::find(initials, material, &std::pair<Index, Real>::first);
  return own != initials.end() ? own->second : initial;
}

RowTable::RowTable()
{
  const auto fixed = [this](int first, int n, const char* name, const char* unit, const char* meaning, bool shown) {
    TERP_ASSERT(first == n_rows());
    entries_.push_back(
        {.name = name, .unit = unit, .meaning = meaning, .owner = "motion", .shown = shown, .n = n, .first = first});
  };
  fixed(Rows::x, 2, "position", "m", "place of the point", false);  // a frame has it beside its fields
  fixed(Rows::xi, 2, "local", "-", "local coordinates in the cell", false);
  fixed(Rows::v, 2, "velocity", "m/s", "velocity of the point", true);
  fixed(Rows::mass, 1, "mass", "kg/m", "mass per metre of thickness", false);
  fixed(Rows::volume, 1, "volume", "m^2", "volume per metre of thickness", true);
  fixed(Rows::sigma, n_sym<2>, "stress", "Pa", "Cauchy stress xx yy zz xy, tension positive", true);
  fixed(Rows::strain, n_sym<2>, "strain", "-", "accumulated strain xx yy zz xy, tensorial shear", true);
  fixed(Rows::id, 1, "id", "-", "number of the point", false);
  TERP_ASSERT(n_rows() == Rows::state);
  n_fixed_ = entries_.size();
}

int RowTable::add(RowInfo info)
{
  for (RowInfo& known : entries_) {
    if (known.name != info.name) continue;
    if (known.owner != info.owner || known.unit != info.unit || known.n != info.n || known.averaging != info.averaging)
      throw InputError(Problem{"material", fmt::format("two quantities of the points have the name `{}`", info.name),
          fmt::format("One is \"{}\" in {}, the other \"{}\" in {}. Give the state variable of the library another "
                      "name.",
              known.meaning, known.unit, info.meaning, info.unit),
          "library"});
    if (info.initial != known.initial)
      for (const Index material : info.of) known.initials.emplace_back(material, info.initial);
    known.of.insert(known.of.end(), info.of.begin(), info.of.end());
    return known.first;
  }
  info.first = n_rows();
  entries_.push_back(std::move(info));
  return entries_.back().first;
}

int RowTable::n_rows() const { return entries_.empty() ? 0 : entries_.back().first + entries_.back().n; }

}  // namespace terp
