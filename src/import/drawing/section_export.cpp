#include "import/drawing/section_export.hpp"

#include "math/errors.hpp"
#include "import/drawing/dxf_file.hpp"
#include "import/drawing/point_section.hpp"
#include "io/case/case_file.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

PointSection section_of_frame(const Frames& frames, std::size_t k)
{
  const SoilPoints points = soil_points(frames, k);
  return section_of_points(points.places, points.volumes, points.materials);
}

}  // namespace

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

SectionExport export_section(const RunResults& run)
{
  const Frames frames = run.frames();
  frames.require_first_and_last();
  const std::size_t n = frames.times().size();
  const PointSection start = section_of_frame(frames, 0), end = section_of_frame(frames, n - 1);
  if (end.ground.empty())
    throw FileError(fmt::format(
        "{}: no soil is left at t = {:.4g} s: there is no section to export", run.folder, frames.times().back()));
  const Case description = read_case_text(run.case_toml, run.folder + "/case.toml").values;
  std::vector<DxfLine> lines{{"ground_start", start.ground, false, ""}, {"ground_end", end.ground, false, ""}};
  for (const CleanRegion& region : end.regions) {
    const auto number = static_cast<std::size_t>(region.drawn);
    const std::string name =
        number < description.materials.size() ? description.materials[number].name : fmt::format("{}", number);
    lines.push_back({name, region.polygon, true, ""});
    for (const Polygon& hole : region.holes) lines.push_back({name, hole, true, ""});
  }
  SectionExport section{dxf_text(lines), {}, frames.times().front(), frames.times().back()};
  for (const Vec<2>& x : end.ground) section.profile.push_back({x[0], start.ground_at(x[0]), x[1]});
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
