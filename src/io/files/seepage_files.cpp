#include "io/files/seepage_files.hpp"

#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/section_svg.hpp"
#include "io/files/svg.hpp"
#include "os/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real day = 86400.0;       // [s]
constexpr Real about_lines = 16.0;  // of equal head and of flow in a picture
constexpr int parts_of_line = 200;  // of along.csv

std::string file_name(std::string_view kind, const std::string& name, std::string_view ending)
{
  std::string file = fmt::format("{}_{}.{}", kind, name, ending);
  for (char& c : file)
    if (c == ' ' || c == '/' || c == '\\' || c == ':') c = '_';
  return file;
}

}  // namespace

SeepageFiles::SeepageFiles(
    std::string folder, const Mesh<2>& mesh, const SeepageSection& section, const std::string& of)
    : folder_(std::move(folder)),
      mesh_(mesh),
      section_(section),
      flows_{"seepage.csv", of + ",part,outflow_m2_per_s,outflow_m2_per_day\n"},
      uplift_{"uplift.csv", of + ",x_m,base_y_m,ground_y_m,total_stress_Pa,pore_pressure_Pa,factor,gradient\n"},
      along_{"along.csv", of + ",x_m,y_m,head_m,pore_pressure_Pa\n"},
      tables_{"tables.csv", of + ",x_m,y_m\n"}
{
}

void SeepageFiles::write(const std::string& name, std::string_view text) const
{
  write_file_atomically(path_in(folder_, name), text);
}

void SeepageFiles::write_tables() const
{
  for (const Table* table : {&flows_, &uplift_, &along_, &tables_})
    if (table->text.size() > table->n_header) write(table->file, table->text);
}

void SeepageFiles::add_flows(const std::string& when, const SeepageCase& conditions, const ComputedWater& water)
{
  const std::vector<std::string> names = names_of_parts(conditions);
  for (std::size_t k = 0; k < names.size(); ++k)
    flows_.text += fmt::format("{},{},{:.9g},{:.9g}\n", csv_cell(when), csv_cell(names[k]), water.flow.outflow[k],
        water.flow.outflow[k] * day);
}

void SeepageFiles::add_uplift(const std::string& situation, const std::vector<UpliftPlace>& places)
{
  for (const UpliftPlace& p : places)
    uplift_.text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", csv_cell(situation), p.x[0],
        p.x[1], p.ground, p.stress, p.pressure, p.factor(), p.gradient);
}

void SeepageFiles::add_along(
    const std::string& situation, const ComputedWater& water, const std::vector<double>& line, Real unit_weight)
{
  const std::size_t before = along_.text.size();
  for (int k = 0; k <= parts_of_line; ++k) {
    const Real share = static_cast<Real>(k) / parts_of_line;
    const Vec<2> x{std::lerp(line[0], line[2], share), std::lerp(line[1], line[3], share)};
    if (const std::optional<Real> head = head_at(mesh_, water.flow.heads, x))
      along_.text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g}\n", csv_cell(situation), x[0], x[1], *head,
          unit_weight * std::max(*head - x[1], 0.0));
  }
  if (along_.text.size() == before)
    throw InputError(Problem{"water", "the line of --along meets no soil",
        fmt::format("Got ({:g}, {:g}) to ({:g}, {:g}) m; the soil reaches from x = {:.4g} to {:.4g} m.", line[0],
            line[1], line[2], line[3], section_.left, section_.right),
        ""});
}

void SeepageFiles::add_table(const std::string& hours, const ComputedWater& water)
{
  for (const Vec<2>& x : water.table) tables_.text += fmt::format("{},{:.6g},{:.6g}\n", hours, x[0], x[1]);
}

void SeepageFiles::write_water(const std::string& name, const SeepageCase& conditions, const ComputedWater& water) const
{
  const BoundingBox box = box_around(mesh_.nodes);
  const auto n = [&](int d) {
    return std::max(static_cast<int>(std::lround((box.high[d] - box.low[d]) / section_.cell)), 1);
  };
  const FreeWaterLevels free(section_, conditions);
  std::string heads = "x,y,value\n";
  for (int i = 0; i <= n(0); ++i)
    for (int j = 0; j <= n(1); ++j) {
      const Vec<2> x{std::lerp(box.low[0], box.high[0], static_cast<Real>(i) / n(0)),
          std::lerp(box.low[1], box.high[1], static_cast<Real>(j) / n(1))};
      heads += fmt::format("{:.9g},{:.9g},{:.9g}\n", x[0], x[1],
          head_at(mesh_, water.flow.heads, x).value_or(std::max(free.level_over(x[0]), x[1])));
    }
  write(file_name("heads", name, "csv"), heads);
  std::string table = "x_m,y_m\n";
  for (const Vec<2>& x : water.table) table += fmt::format("{:.9g},{:.9g}\n", x[0], x[1]);
  write(file_name("table", name, "csv"), table);
}

void SeepageFiles::write_picture(
    const std::string& name, const Simulation& simulation, const ComputedWater& water, Real band) const
{
  Real low = std::numeric_limits<Real>::infinity(), high = -low, out = 0.0;
  for (std::size_t k = 0; k < water.soil.surface.size(); ++k)
    if (water.flow.is_wet[k])
      low = std::min(low, water.soil.surface[k].head), high = std::max(high, water.soil.surface[k].head);
  for (const Real q : water.flow.outflow) out += std::max(q, 0.0);
  SectionOverlay overlay;
  overlay.subtitle = fmt::format("computed water `{}`", name);
  if (high > low) {
    const Real step = nice_step(high - low, about_lines);
    overlay.curves.push_back({lines_of_equal(mesh_, section_, water, water.flow.heads, step), "#0e7c86",
        fmt::format("equal head, every {:g} m", step)});
  }
  if (out > 0.0) {
    const Real step = nice_step(out * day, about_lines) / day;
    overlay.curves.push_back({lines_of_equal(mesh_, section_, water, stream_function(mesh_, water, band), step),
        "#1f3fa8", fmt::format("flow line, {:.2g} m2/day between two", step * day)});
  }
  write(file_name("seepage", name, "svg"), draw_section(simulation.model, simulation.state, overlay));
}

void SeepageFiles::write_for_case(const std::vector<std::string>& names) const
{
  std::string toml =
      "# Water of moments of a flood, in place of [water] of the case: give a stage water = \"NAME\".\n[water]\n";
  for (std::size_t k = 0; k < names.size(); ++k)
    toml += fmt::format("{}head = {{ csv = \"{}\" }}\n",
        k == 0 ? std::string() : fmt::format("\n[[water.situation]]\nname = \"{}\"\n", names[k]),
        file_name("heads", names[k], "csv"));
  write("water.toml", toml);
}

}  // namespace terp
