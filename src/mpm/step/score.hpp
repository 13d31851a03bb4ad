// The score: what a step does, as a list of plain functions that is chosen once. A kernel does one thing at one place
// of score.def, over a group of cells, a layer of soil, a block, a batch of nodes, or once. The core has kernels
// (core_kernels.cpp), the scheme (mpm/schemes), and each feature that the run has (mpm/features/NAME_kernels.cpp).
// Not for: how they are walked (walks.hpp), nor what they hand on (now.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;
struct StepNow;
struct GroupNow;
struct LayerNow;
struct BlockNow;
struct StripNow;
struct Nodes;
struct Kernel;

/// Over what a kernel runs. strip: called by the law of a block, before the material's. wait: no kernel, a new walk.
enum class Over { once, group, layer, block, strip, nodes, wait };

/// The scores: of a step; of its halves without motion (kernels.hpp).
enum ScoreOf : unsigned { in_step = 1, in_forces = 2, in_strain = 4, in_all = 7 };

/// Where stress lives, and so in which order a scheme walks: points integrate; blocks after the strain of all layers;
/// layer by layer with their blocks; and in two walks, where cells count in each other's patches.
enum StressHome : unsigned {
  at_points = 1,
  cells_first = 2,
  layers_first = 4,
  patched_cells = 8,
  patched_layers = 16,
  in_patches = patched_cells | patched_layers,
  at_gauss_points = cells_first | layers_first | in_patches,
  anywhere = at_points | at_gauss_points
};

enum class ScorePlace : int {
#define TERP_PLACE(name, over, pass, in, homes, text) name,
#define TERP_WAIT(name, pass, homes, text) name,
#include "mpm/step/score.def"
#undef TERP_PLACE
#undef TERP_WAIT
};

struct PlaceInfo {
  std::string_view name;
  Over over;
  int pass;  ///< of passes.hpp; n_passes: none
  unsigned in, homes;
  std::string_view text;
};

struct Kernel {
  ScorePlace place;
  std::string_view name;
  std::variant<void (*)(StepNow&), void (*)(GroupNow&), void (*)(LayerNow&), void (*)(BlockNow&), void (*)(StripNow&),
      void (*)(Nodes&)>
      run;
  unsigned homes = anywhere;  ///< where stress must live for it
};

/// The kernels of a feature in one copy, and whether a run has the feature now.
struct FeatureKernels {
  std::string_view name;
  bool (*present)(const StepModel&, const Workspace&);
  std::span<const Kernel> kernels;
};

/// Kernels `first` to `end` - 1 over the same range.
struct ScoreSegment {
  Over over;
  int first, end;
};
/// Segments over groups of cells, fused; or one over nodes; or one kernel that runs once.
struct ScoreWalk {
  Over over;
  int pass;
  int first, end;  ///< segments
};

/// What a score follows from.
struct ScoreKey {
  const Kernel* scheme = nullptr;
  std::uint64_t features = 0;  ///< by bit, in the order of features.def
  bool operator==(const ScoreKey&) const = default;
};

/// Has room for all, so that it can be chosen anew within a step.
struct Score {
  static constexpr int most = 128;

  ScoreKey key;
  unsigned home = 0;  ///< where stress lives
  std::array<const Kernel*, most> kernels;
  std::array<ScoreSegment, most> segments;
  std::array<ScoreWalk, most> walks;
  int n_kernels = 0, n_segments = 0, n_walks = 0;
  int n_strips = 0;  ///< they stand behind the others

  std::span<const Kernel* const> of(const ScoreSegment& segment) const
  {
    return std::span(kernels).subspan(segment.first, segment.end - segment.first);
  }
  std::span<const ScoreSegment> of(const ScoreWalk& walk) const
  {
    return std::span(segments).subspan(walk.first, walk.end - walk.first);
  }
  std::span<const Kernel* const> strips() const { return std::span(kernels).subspan(n_kernels - n_strips, n_strips); }
};

/// The scores of a run.
struct Scores {
  Score step, forces, strain;
};

/// The score in force, chosen anew where the scheme or the features are others than in the step before.
const Score& score_now(ScoreOf of, const StepModel& model, Workspace& work);

/// That of a step, in this copy of the kernels: call it by way of kernels().score.
const Score& score_compiled(const StepModel& model, Workspace& work);

}  // namespace terp
