#include "run/report/run_table.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace terp {

std::size_t RunTable::place_of(std::string_view column) const
{
  std::size_t place = 0;
  for (const QuantityInfo& info : columns) {
    if (info.is_text) continue;
    if (info.name == column) return place;
    ++place;
  }
  throw std::logic_error(fmt::format("the table `{}` has no column `{}`", name, column));
}

std::size_t RunTable::n_values() const
{
  return static_cast<std::size_t>(std::ranges::count(columns, false, &QuantityInfo::is_text));
}

TableRow::TableRow(std::shared_ptr<const RunTable> of, std::string its_text)
    : table(std::move(of)), values(table->n_values(), std::numeric_limits<Real>::quiet_NaN()), text(std::move(its_text))
{
}

}  // namespace terp
