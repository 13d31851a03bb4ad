#include "row_keeper.hpp"

#include "io/case/case_file.hpp"
#include "run/measure/followers.hpp"

#include <algorithm>

namespace terp {

void RowKeeper::rows(const std::vector<TableRow>& rows)
{
  std::vector<TableRow>& kept = rows_[std::string(rows.front().table->name)];
  kept.insert(kept.end(), rows.begin(), rows.end());
}

void RowKeeper::go_back(Real time, bool to_start)
{
  for (auto& [name, rows] : rows_)
    std::erase_if(rows, [&](const TableRow& row) { return to_start || row.values.front() > time; });
}

std::vector<RowKeeper::Column> RowKeeper::table(const std::string& name) const
{
  const auto& tables = all_tables();
  const auto known = std::ranges::find(tables, name, [](const auto& table) { return table->name; });
  if (known == tables.end()) {
    std::string names;
    for (const auto& table : tables) names += (names.empty() ? "" : ", ") + std::string(table->name);
    throw CaseError("a run has no table `" + name + "`\n  Its tables: " + names + ".");
  }
  const auto found = rows_.find(name);
  const std::vector<TableRow> none;
  const std::vector<TableRow>& rows = found == rows_.end() ? none : found->second;
  std::vector<Column> columns;
  std::size_t k = 0;
  for (const QuantityInfo& info : (*known)->columns) {
    Column column{std::string(info.name), std::string(info.unit), info.is_text};
    for (const TableRow& row : rows)
      if (info.is_text)
        column.texts.push_back(row.text);
      else
        column.values.push_back(row.values[k]);
    if (!info.is_text) ++k;
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace terp
