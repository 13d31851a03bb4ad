// The tables of a run in memory: ledger, history and those of its features, as its files would have them.
#pragma once

#include "run/loop/observer.hpp"

#include <map>
#include <string>
#include <vector>

namespace terp {

class RowKeeper : public Observer {
 public:
  struct Column {
    std::string name, unit;
    bool is_text = false;
    std::vector<Real> values = {};
    std::vector<std::string> texts = {};
  };

  void rows(const std::vector<TableRow>& rows) override;
  /// Drops the rows after a state that the run goes back to. A run that is back at its start reports its first rows
  /// again.
  void go_back(Real time, bool to_start);
  /// Without rows yet: the columns that it will have. Throws CaseError with the names of the tables.
  std::vector<Column> table(const std::string& name) const;

 private:
  std::map<std::string, std::vector<TableRow>, std::less<>> rows_;
};

}  // namespace terp
