#include "batch/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace terp {
namespace {

constexpr std::array<std::array<Real, 3>, 5> scale = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};  // viridis, five of its colours

/// share: 0 to 1.
std::string colour_at(Real share)
{
  const Real at = std::clamp(share, 0.0, 1.0) * static_cast<Real>(scale.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), scale.size() - 2);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(std::lround(scale[k][c] + (at - static_cast<Real>(k)) * (scale[k + 1][c] - scale[k][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace

std::string field_picture(const Study& study, std::size_t field, Index realisation)
{
  constexpr Real width = 460.0, margin = 24.0;  // [px]
  constexpr int most = 90;                      // cells along a side
  const auto& [low, high] = study.boxes[field];
  const Vec<2> size{high[0] - low[0], high[1] - low[1]};
  const Real height = std::clamp(width * size[1] / size[0], 60.0, 400.0);
  const int nx = most, ny = std::clamp(static_cast<int>(most * height / width), 12, most);
  const FieldOverTrend over(study, field, realisation);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" font-size=\"11.5\">\n<text "
      "x=\"0\" y=\"14\">realisation {}, over the trend: dark 0.5, bright 2</text>\n",
      width, height + margin, realisation);
  const Real dx = width / nx, dy = height / ny;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Vec<2> x{low[0] + (i + 0.5) / nx * size[0], high[1] - (j + 0.5) / ny * size[1]};
      fmt::format_to(std::back_inserter(out), "<path d=\"M{:.1f} {:.1f}h{:.2f}v{:.2f}h-{:.2f}z\" fill=\"{}\"/>", i * dx,
          margin + j * dy, dx + 0.3, dy + 0.3, dx + 0.3, colour_at(0.5 + 0.5 * std::log2(over.at(x))));
    }
  return out + "</svg>\n";
}

}  // namespace terp
