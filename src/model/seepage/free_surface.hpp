// Flow of water with a free surface: div(k_r k grad h) = 0, or an implicit step in time.
// docs/methods.md, "Seepage". Not for: what a case orders (computed_water.hpp).
#pragma once

#include "model/seepage/flow_law.hpp"
#include "model/seepage/flow_soil.hpp"

#include <optional>
#include <string>

namespace terp {

struct FlowOptions {
  SuctionBand band;
  bool is_saturated = false;  ///< k_r = 1 everywhere
  Real tolerance = 1e-5;      ///< change of h at places of the soil over the height of the soil
  int most_iterations = 100;  ///< of the last band
};

/// An implicit step from heads that were.
struct FlowStep {
  Real dt;                      ///< [s]
  std::span<const Real> heads;  ///< at its start, shape [n_nodes] [m]
};

struct FlowResult {
  std::vector<Real> heads;     ///< at nodes [m], shape [n_nodes]; the elevation where the flow has no equation
  std::vector<char> has_flow;  ///< by nodes: it has an equation
  std::vector<Real> outflow;   ///< by part of the surface [m^2/s]
  std::vector<char> is_wet;    ///< by places of the surface: water passes there
  std::vector<Real> q;         ///< by places of the surface, outwards [m/s]
  Real change = 0.0;           ///< of the last iteration, as in FlowOptions
  Real imbalance = 0.0;        ///< what goes in less what comes out, over the flow; of a step without storage
  Real misfit = 0.0;           ///< of places of a seepage face that were kept as they are, over the flow
  int iterations = 0;
  bool counts = false;  ///< change, balance and seepage faces are within their bounds
};

/// parts: number of those of the surface. start: heads to begin from; empty: full. step: in time; empty: steady.
FlowResult find_flow(const Mesh<2>& mesh, const FlowSoil& soil, std::size_t parts, const FlowOptions& options,
    std::span<const Real> start = {}, const std::optional<FlowStep>& step = std::nullopt);

}  // namespace terp
