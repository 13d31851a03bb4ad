// Small results with no two equal numbers, for the tests of the output room.
#pragma once

#include "math/errors.hpp"
#include "run/measure/followers.hpp"
#include "run/report/history.hpp"
#include "run/report/ledger.hpp"
#include "run/loop/observer.hpp"
#include "support/test.hpp"

namespace terp::test {

/// Frame k of five points with one scalar, one vector and one stress.
inline Frame sample_frame(int k)
{
  Frame frame{.time = 0.1 * k,
      .step = 100 * k,
      .x = {},
      .fields = {{"su", "Pa", 1, {}}, {"velocity", "m/s", 2, {}}, {"stress", "Pa", 4, {}}}};
  for (int p = 0; p < 5; ++p) {
    const Real base = 1000.0 * k + 10.0 * p;
    frame.x.insert(frame.x.end(), {base + 0.1, base + 0.2});
    frame.fields[0].values.push_back(base + 0.3);
    for (const Real part : {0.4, 0.5}) frame.fields[1].values.push_back(base + part);
    for (const Real part : {0.6, 0.7, 0.8, 0.9}) frame.fields[2].values.push_back(base + part);
  }
  return frame;
}

/// A table of a run with all followers.
inline const std::shared_ptr<const RunTable>& table_named(std::string_view name)
{
  return *std::ranges::find_if(all_tables(), [&](const auto& table) { return table->name == name; });
}
inline const std::shared_ptr<const RunTable>& sample_ledger_table() { return table_named("ledger"); }

inline std::vector<TableRow> sample_history(Real time)
{
  std::vector<TableRow> rows{TableRow(history_table(), "A"), TableRow(history_table(), "B")};
  rows[0].values = {time, 7.0, 1.5, 0.25, 0.01, 0.002, 8000.0, -125.5, std::nan("")};
  rows[1].values = {time, 9.0, 2.5, 0.75, 0.03, 0.0, std::nan(""), 1.0 / 3.0, std::nan("")};
  return rows;
}

inline std::vector<TableRow> sample_ledger(Real time)
{
  TableRow row(sample_ledger_table());
  row["time"] = time, row["step"] = 100, row["stage"] = 2, row["kinetic"] = 1.25, row["kinetic_nodal"] = 0.75,
  row["elastic"] = 2.5;
  row["plastic"] = 3.75, row["gravity_work"] = 4.5, row["damping_work"] = -5.5, row["boundary_work"] = -6.5;
  row["slip_work"] = 0.0625, row["clamp_work"] = 0.375, row["water_work"] = 0.875, row["load_work"] = -0.5;
  row["relaxation_work"] = -0.25;
  row["left_energy"] = 0.125, row["numerical"] = 1e-12, row["mass"] = 31840.0, row["momentum_x"] = 7.5;
  row["mass_placed"] = 640.0, row["mass_removed"] = 320.0;
  row["momentum_y"] = -8.5, row["clamped"] = 3, row["left"] = 0, row["v_max"] = 6.25, row["v_999"] = 5.75;
  row["front_x"] = 13.1, row["crest_y"] = 1.75, row["crest_left_x"] = 3.5, row["crest_left_y"] = 1.5;
  row["moved_volume"] = 4.25, row["residual_height"] = 3.25, row["width_at_level"] = 5.125, row["intact_width"] = 4.5;
  return {row};
}

inline StateImage sample_image(std::int64_t step)
{
  return {0.001 * static_cast<Real>(step), step,
      {{"points/x", {2, 2}, std::vector<Real>{0.1, 1.0 / 3.0, -0.0, 1e-300}},
          {"points/id", {2}, std::vector<std::int64_t>{-1, std::int64_t{1} << 53}},
          {"counters", {}, std::vector<std::int64_t>{static_cast<std::int64_t>(step)}},
          {"empty", {0, 3}, std::vector<Real>{}}}};
}

inline std::vector<Real> as_single(std::vector<Real> values)
{
  for (Real& value : values) value = static_cast<float>(value);
  return values;
}

template <class Call>
std::string file_error_of(Call&& call)
{
  return refusal<FileError>(call);
}

}  // namespace terp::test
