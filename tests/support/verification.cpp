#include "support/verification.hpp"

#include "model/parts/setup.hpp"

namespace terp::test {

Simulation simulate_on(Mesh<2> mesh, const Case& description, int threads)
{
  Model model = build_model(description, std::make_shared<const Mesh<2>>(std::move(mesh)), threads);
  State state = build_state(model);
  return {std::move(model), std::move(state)};
}

Vec<2> turned(Vec<2> x, Real angle)
{
  return {std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]};
}

Mesh<2> reconnected(const Mesh<2>& mesh)
{
  Mesh<2> fresh;
  fresh.nodes = mesh.nodes;
  fresh.cells = mesh.cells;
  fresh.sides = mesh.sides;
  connect(fresh);
  return fresh;
}

Mesh<2> turned(const Mesh<2>& mesh, Real angle)
{
  Mesh<2> result = mesh;
  for (Vec<2>& x : result.nodes) x = turned(x, angle);
  return reconnected(result);
}

Vec<2> centre_of_mass(const State& state)
{
  Vec<2> sum{0.0, 0.0};
  Real mass = 0.0;
  for (const Point& p : points_by_id(state)) {
    mass += p.mass;
    for (int d = 0; d < 2; ++d) sum[d] += p.mass * p.x[d];
  }
  return {sum[0] / mass, sum[1] / mass};
}

Vec<2> mean_velocity(const State& state)
{
  Real mass = 0.0;
  for (const Point& p : points_by_id(state)) mass += p.mass;
  const Vec<2> m = momentum(state);
  return {m[0] / mass, m[1] / mass};
}

}  // namespace terp::test
