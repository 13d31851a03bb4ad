// Transfinite interpolation is the sum of the two linear blends of opposite sides, less the bilinear blend of the
// corners. Round-off would move nodes off their sides, so the sides are written again at the end.

#include "model/meshes/structured.hpp"

#include "math/plane.hpp"

#include <cmath>

namespace terp {
namespace {

using Places = std::vector<Vec<2>>;

Real length_of(const Places& line)
{
  Real sum = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += distance(line[k - 1], line[k]);
  return sum;
}

/// Places at shares of the arc length, shape [shares]; ends exact.
Places along(const Places& line, const std::vector<Real>& shares)
{
  Places places;
  const Real whole = length_of(line);
  std::size_t k = 1;
  Real before = 0.0;
  for (const Real share : shares) {
    while (k + 1 < line.size() && before + distance(line[k - 1], line[k]) < share * whole) {
      before += distance(line[k - 1], line[k]);
      ++k;
    }
    const Real part = (share * whole - before) / distance(line[k - 1], line[k]);
    places.push_back(part >= 1.0 ? line[k] : between(line[k - 1], line[k], part));
  }
  places.front() = line.front();
  places.back() = line.back();
  return places;
}

}  // namespace

std::vector<Real> graded_shares(Index n, Real grading)
{
  std::vector<Real> shares{0.0};
  Real cell = 1.0, sum = 0.0;
  const Real ratio = n > 1 ? std::pow(grading, 1.0 / (n - 1)) : 1.0;
  for (Index k = 0; k < n; ++k) {
    shares.push_back(sum += cell);
    cell *= ratio;
  }
  for (Real& share : shares) share /= sum;
  if (grading == 1.0)
    for (Index k = 0; k <= n; ++k) shares[k] = static_cast<Real>(k) / n;
  return shares;
}

Mesh<2> make_graded_rectangle(Vec<2> origin, Vec<2> size, std::array<Index, 2> n, Vec<2> grading)
{
  const auto x = graded_shares(n[0], grading[0]), y = graded_shares(n[1], grading[1]);
  std::vector<Vec<2>> nodes;
  for (const Real b : y)
    for (const Real a : x) nodes.push_back({origin[0] + size[0] * a, origin[1] + size[1] * b});
  return make_grid(std::move(nodes), n);
}

Mesh<2> make_mapped_rectangle(const std::array<Places, 4>& sides, std::array<Index, 2> n, Vec<2> grading)
{
  const auto s = graded_shares(n[0], grading[0]), t = graded_shares(n[1], grading[1]);
  const Places bottom = along(sides[0], s), right = along(sides[1], t), top = along(sides[2], s),
               left = along(sides[3], t);
  const Vec<2> corner_00 = bottom.front(), corner_10 = bottom.back(), corner_01 = top.front(), corner_11 = top.back();
  std::vector<Vec<2>> nodes;
  for (Index j = 0; j <= n[1]; ++j)
    for (Index i = 0; i <= n[0]; ++i) {
      const Vec<2> up = between(bottom[i], top[i], t[j]), across = between(left[j], right[j], s[i]);
      const Vec<2> twice = between(between(corner_00, corner_10, s[i]), between(corner_01, corner_11, s[i]), t[j]);
      nodes.push_back({up[0] + across[0] - twice[0], up[1] + across[1] - twice[1]});
    }
  for (Index i = 0; i <= n[0]; ++i) nodes[i] = bottom[i], nodes[n[1] * (n[0] + 1) + i] = top[i];
  for (Index j = 0; j <= n[1]; ++j) nodes[j * (n[0] + 1)] = left[j], nodes[j * (n[0] + 1) + n[0]] = right[j];
  return make_grid(std::move(nodes), n);
}

}  // namespace terp
