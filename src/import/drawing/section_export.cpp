#include "import/drawing/section_export.hpp"

#include "math/errors.hpp"
#include "math/nan.hpp"
#include "import/drawing/dxf_file.hpp"
#include "import/drawing/point_section.hpp"
#include "io/case/case_file.hpp"
#include "io/files/mesh_file.hpp"
#include "io/files/run_folder.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace terp {
SoilPoints soil_points(const Frames& frames, std::size_t frame)
{
  const std::vector<Real> x = frames.places(frame), material = frames.read("material", frame),
                          volume = frames.read("volume", frame);
  SoilPoints points;
  for (std::size_t p = 0; p < material.size(); ++p) {
    if (!is_soil(x, p)) continue;
    points.places.push_back({x[2 * p], x[2 * p + 1]});
    points.volumes.push_back(volume[p]);
    points.materials.push_back(static_cast<int>(material[p]));
  }
  return points;
}

EndsOfRun ends_of(const RunResults& run)
{
  EndsOfRun ends{read_case_text(run.case_toml, run.folder + "/case.toml").values, run.frames(), {}, {}, {}};
  ends.frames.require_first_and_last();
  ends.end = soil_points(ends.frames, ends.frames.times().size() - 1);
  const Mesh<2> mesh = read_mesh(path_in(run.folder, mesh_file));
  ends.ground_start = ground_line(ends.description, mesh, soil_points(ends.frames, 0));
  ends.ground_end = ground_line(ends.description, mesh, ends.end);
  if (ends.ground_end.empty())
    throw FileError(fmt::format(
        "{}: no soil is left at t = {:.4g} s: there is no section to export", run.folder, ends.frames.times().back()));
  return ends;
}

SectionExport export_section(const RunResults& run)
{
  const auto [description, frames, soil, before, after] = ends_of(run);
  std::vector<DxfLine> lines{{"ground_start", before, false, ""}, {"ground_end", after, false, ""}};
  for (const CleanRegion& region : regions_of_points(soil.places, soil.volumes, soil.materials).regions) {
    const auto number = static_cast<std::size_t>(region.drawn);
    const std::string name =
        number < description.materials.size() ? description.materials[number].name : fmt::format("{}", number);
    lines.push_back({name, region.polygon, true, ""});
    for (const Polygon& hole : region.holes) lines.push_back({name, hole, true, ""});
  }
  SectionExport section{dxf_text(lines), {}, frames.times().front(), frames.times().back()};
  for (const Vec<2>& x : after) {
    const auto same = std::ranges::find(before, x[0], [](const Vec<2>& place) { return place[0]; });
    section.profile.push_back({x[0], same == before.end() ? nan : (*same)[1], x[1]});
  }
  return section;
}

std::vector<std::array<Real, 3>> profile_of(const RunResults& run) { return export_section(run).profile; }

std::string SectionExport::profile_csv() const
{
  std::string text = "x,start,end\n";
  for (const auto& [x, before, after] : profile)
    text += std::isnan(before) ? fmt::format("{:.4f},,{:.4f}\n", x, after)
                               : fmt::format("{:.4f},{:.4f},{:.4f}\n", x, before, after);
  return text;
}

}  // namespace terp
