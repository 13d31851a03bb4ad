#include "run/measure/followers.hpp"
#include "io/files/files.hpp"
#include "mpm/step/state_arrays.hpp"
#include "support/simulations.hpp"

namespace followers_test {

TEST(Followers, HaveNamesOfTheirOwnAndDescribeWhatTheyReport)
{
  std::set<std::string_view> names;
  for (const FollowerType* type : all_followers()) {
    EXPECT_TRUE(names.insert(type->name).second) << type->name;
    for (const QuantityInfo& column : type->columns) EXPECT_FALSE(column.meaning.empty()) << column.name;
  }
  for (const auto& table : all_tables()) {
    std::set<std::string_view> columns;
    for (const QuantityInfo& column : table->columns) {
      EXPECT_TRUE(columns.insert(column.name).second) << table->name << ' ' << column.name;
      EXPECT_FALSE(column.label.empty() || column.meaning.empty()) << table->name << ' ' << column.name;
    }
    EXPECT_EQ(table->columns[0].name, "time");
  }
}

TEST(Followers, PutTheSummaryNumbersThatTheyDeclare)
{
  Simulation s = followed(column("mpm_gp"));
  const Summary summary = summarise(s.model, s.state);
  std::size_t n_declared = 0;
  for (const FollowerType* type : all_followers())
    for (const QuantityInfo& number : type->summary) {
      EXPECT_TRUE(summary.numbers.contains(number.name)) << number.name;
      ++n_declared;
    }
  EXPECT_EQ(summary.numbers.size(), n_declared);
}

/// A follower that is not in the list, with a column, a number of the summary and an array: what a new one needs.
class Counter : public Follower {
  Real rows_ = 0.0;
  void row(const LedgerContext&, std::span<Real> values) override { values[0] = ++rows_; }
  void summarise(const Model&, const State&, Summary& summary) const override { summary.numbers["rows"] = rows_; }
  void save(ArrayWriter& arrays) const override { arrays.copy("rows", std::vector<Real>{rows_}); }
  void load(const Model&, const State&, const ArrayReader& arrays) override { rows_ = arrays.reals("rows", 1)[0]; }
};

const FollowerType counter{.name = "counter",
    .columns = {{"rows", "-", "rows", "rows of the ledger so far"}},
    .summary = {{"rows", "-", "rows", "rows of the ledger"}},
    .make = make_follower<Counter>};

TEST(Followers, OneAloneIsEnoughForARun)
{
  Simulation s = followed(column("mpm_gp"));
  s.model.followers = {&counter};
  start_followers(s.model, s.state);
  keep_ledger(s.model, s.state, s.work);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["rows"], 2.0);
  EXPECT_THROW(row["crest_x"], std::logic_error);
  s.state = restore(s.model, make_image(s.state));
  EXPECT_EQ(keep_ledger(s.model, s.state, s.work)["rows"], 3.0);
  EXPECT_EQ(summarise(s.model, s.state).numbers.at("rows"), 3.0);
}

}  // namespace followers_test
