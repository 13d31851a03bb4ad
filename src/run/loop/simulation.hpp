// A run in memory: what `terp run` does with a case, as an object that a program, a test or a study drives.
// Not for: case files (io/case) and files of results (io/files); both are connected to it, as a Case and as observers.
#pragma once

#include "run/loop/run.hpp"
#include "model/parts/setup.hpp"

#include <limits>

namespace terp {

/// Nobody stops a run that is given this.
inline const std::atomic<bool> never_stop{false};

/// Model, state and scratch of a run, with its threads. Reads everything; whoever changes `state` himself answers for
/// it. Each Simulation may be driven by a thread of its own; Case and mesh may be shared between them.
struct Simulation {
  /// Builds the mesh, seeds the points and sets the initial stress of "k0". followers: what is measured besides the
  /// balance, as all_followers(); without them the summary has neither front nor crest. Throws
  /// InputError. Where the system grants fewer threads, model.threads says how many there are.
  explicit Simulation(const Case& description, int threads = 1, const FollowerTypes& followers = {});
  /// The same on a mesh that is already there, as in a study of many runs on one mesh.
  Simulation(const Case& description, SharedMesh mesh, int threads = 1, const FollowerTypes& followers = {});
  /// Goes on from a state, as from a checkpoint.
  Simulation(Model ready_model, State ready_state);
  ~Simulation();

  /// What comes before the first step: the search for equilibrium if the case asks for it, and the outputs at t = 0.
  /// The first step does it, too; called on its own, fields can be set after it. Does nothing in a run that has
  /// started.
  Outcome start(const std::atomic<bool>& stop = never_stop);

  /// Makes n steps, with the guards and the outputs that are due, beyond the end of the case if n says so. Throws
  /// RunError where the run must stop itself, InputError if n is negative.
  Outcome step(std::int64_t n = 1, const std::atomic<bool>& stop = never_stop);

  /// Makes steps up to the first one at or after t [s], which may lie beyond the end of the case. Throws as step()
  /// does, and where t lies before the present.
  Outcome advance_to(Real t, const std::atomic<bool>& stop = never_stop);

  /// Makes the steps that are left to the end of the case, stage by stage, or those up to the first one at or after
  /// `until` [s]. Throws RunError as step() does.
  Outcome run(const std::atomic<bool>& stop = never_stop, Real until = std::numeric_limits<Real>::infinity());

  /// A field of all points by its name in results ("velocity", "stress", "eps_eq_p", ...), or "position": shape
  /// [n_points, n_components], sorted by id. NaN where the material of a point has no such variable. Points that left
  /// the mesh keep their places (docs/formats.md). Throws InputError with the names that there are.
  PointField field(const std::string& name) const;

  /// Sets velocity [m/s], stress [Pa], strain [-], volume [m^2] or a state variable of all points; shape and order as
  /// field() gives them. What the change adds to the energy counts as energy of the start. Throws InputError for an
  /// unknown name, a wrong size, and values that are not finite, with the id of the point.
  void set_field(const std::string& name, const std::vector<Real>& values);

  /// The state as a checkpoint holds it.
  StateImage save() const;
  /// Back to a saved state of this case. The run goes on from it with the same bits. Throws FileError if it does not
  /// fit: other materials, cells, number of points or time step. Parameters of the laws may differ.
  void restore(const StateImage& image);

  Model model;
  State state;

 private:
  std::unique_ptr<Workspace> work_;

 public:
  Workspace& work;
  std::vector<Observer*> observers = {};  ///< are shown what the run puts out; not owned

 private:
  /// Makes steps up to `until`, from stage to stage. beyond: also after the end of the last one.
  Outcome advance(std::int64_t until, bool beyond, const std::atomic<bool>& stop);
  /// The first step at or after t, as a number that may be too large for one.
  Real step_at(Real t) const;
};

}  // namespace terp
