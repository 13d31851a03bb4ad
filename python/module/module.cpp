// The compiled part of the Python package: a case, and a run in memory as numpy sees it (docs/python.md).
// Not for: conveniences of Python, which are in python/terp/simulation.py.

#include "run/measure/followers.hpp"
#include "io/case/case_file.hpp"
#include "io/case/case_record.hpp"
#include "io/files/summary_json.hpp"
#include "free_parameters.hpp"
#include "row_keeper.hpp"
#include "element.hpp"
#include "run_files.hpp"
#include "run/loop/simulation.hpp"
#include "run/loop/stages.hpp"
#include "run/report/frame_fields.hpp"
#include "model/soils/strength_profile.hpp"
#include "run/findings/setup_warnings.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <unordered_map>

namespace py = pybind11;

namespace terp {
namespace {

/// Python owns the values from here on; nothing is copied.
py::array_t<double> as_array(std::vector<Real>&& values, int n_components)
{
  auto* kept = new std::vector<Real>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Real>*>(p); });
  std::vector<py::ssize_t> shape{std::ssize(*kept) / n_components};
  if (n_components > 1) shape.push_back(n_components);
  return py::array_t<double>(shape, kept->data(), owner);
}

py::array read_only(py::array array)
{
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Asks Python between steps whether the user pressed Ctrl-C; the run then ends after the step that it is in.
class SignalWatch : public Observer {
 public:
  std::atomic<bool> stop{false};

  void progress(const Progress&) override
  {
    const py::gil_scoped_acquire python;
    if (!stop && PyErr_CheckSignals() != 0) stop = true;
  }
};

/// The mesh of a case is that of another one. Throws CaseError with the first value in which they differ.
void check_same_mesh(const CaseFile& file, const CaseFile& other, const Mesh<2>& mesh)
{
  const bool of_bodies = file.values.mesh.kind == MeshKind::polygon && file.values.mesh.follow_bodies;
  for (const ChangedValue& change :
      changes_since(record_text(make_case_record(other, mesh)), make_case_record(file, mesh)))
    if (change.key.starts_with("mesh") ||
        (of_bodies && change.key.starts_with("body") && !change.key.ends_with(".material")))
      throw CaseError("mesh_of: that simulation is of another mesh: " + change.text());
}

/// A run in memory. Python's lock is free while it computes; a second thread of Python that calls it is refused.
class PythonSimulation {
 public:
  PythonSimulation(std::shared_ptr<const CaseFile> file, int threads, const PythonSimulation* mesh_of,
      const std::string& output, bool force)
      : file_(std::move(file))
  {
    alone([&] {
      if (mesh_of != nullptr) check_same_mesh(*file_, *mesh_of->file_, *mesh_of->run_->model.mesh);
      run_ = mesh_of == nullptr
                 ? std::make_shared<Simulation>(file_->values, threads, all_followers())
                 : std::make_shared<Simulation>(file_->values, mesh_of->run_->model.mesh, threads, all_followers());
      if (!output.empty()) files_ = std::make_unique<RunFiles>(*file_, *run_, output, force);
    });
    if (files_) run_->observers = files_->observers();
    run_->observers.push_back(&tables_);
    run_->observers.push_back(&watch_);
  }

  const Simulation& run() const { return *run_; }
  /// False while another thread makes steps.
  bool has_ended()
  {
    const Turn turn(in_use_);
    return turn.is_mine && ended();
  }

  void start()
  {
    solve([&] { return run_->start(watch_.stop); });
  }
  void step(std::int64_t n)
  {
    solve([&] { return run_->step(n, watch_.stop); });
  }
  void advance_to(Real time)
  {
    solve([&] { return run_->advance_to(time, watch_.stop); });
  }
  void run_until(Real time)
  {
    solve([&] { return run_->run(watch_.stop, time); });
  }

  py::array_t<double> field(const std::string& name)
  {
    PointField found;
    alone([&] { answer([&] { found = run_->field(name); }); });
    return as_array(std::move(found.values), found.n_components);
  }

  void set_field(const std::string& name, const py::array_t<double, py::array::c_style | py::array::forcecast>& values)
  {
    const std::vector<Real> copy(values.data(), values.data() + values.size());
    alone([&] { answer([&] { run_->set_field(name, copy); }); });
  }

  /// Views of a row of the points, one for each block, in the order of cells. Those that are as they were are made
  /// once: a step moves few points to other blocks.
  py::list blocks(const std::string& name)
  {
    const MyTurn turn(in_use_);
    const RowInfo* row = nullptr;
    std::string names;
    for (const RowInfo& entry : run_->model.rows.entries()) {
      if (entry.name == name) row = &entry;
      names += (names.empty() ? "" : ", ") + entry.name;
    }
    if (row == nullptr) throw CaseError("points carry no row `" + name + "`\n  They carry: " + names + ".");
    if (!memory_)
      memory_ =
          py::capsule(new std::shared_ptr(run_), [](void* p) { delete static_cast<std::shared_ptr<Simulation>*>(p); });
    std::unordered_map<const Real*, View>& kept = views_[row->first];
    if (kept.size() > 2 * run_->state.points.occupied().size()) kept.clear();
    py::list views;
    for_each_block(run_->state.points, [&](const PointBlock<2>& block) {
      if (!row->is_of(block.material)) return;
      View& view = kept[block.data];
      if (view.n != block.n || view.capacity != block.capacity) view = {block.n, block.capacity, view_of(block, *row)};
      views.append(view.array);
    });
    return views;
  }

  /// Name, unit and number of components of all fields; of a parameter of a law that points have values of their own
  /// of, "parameter".
  std::vector<std::tuple<std::string, std::string, int, bool>> fields()
  {
    const MyTurn turn(in_use_);
    std::vector<std::tuple<std::string, std::string, int, bool>> list{{"position", "m", 2, false}};
    for (const FrameField& field : frame_fields(run_->model, run_->state))
      list.emplace_back(field.name, field.unit, field.n_components, is_parameter(field.name));
    return list;
  }

  std::vector<RowKeeper::Column> table(const std::string& name)
  {
    const MyTurn turn(in_use_);
    return tables_.table(name);
  }

  std::vector<ProfileRow> profile(Real x)
  {
    const MyTurn turn(in_use_);
    return strength_profile(run_->model, run_->state, x);
  }

  StateImage save()
  {
    const MyTurn turn(in_use_);
    return run_->save();
  }
  void restore(const StateImage& image)
  {
    views_.clear();
    if (memory_ && memory_.ref_count() > 1)
      throw py::buffer_error("views from blocks() are still in use: delete them before restore()");
    if (files_)  // rows and frames after the saved state would stay in them
      throw CaseError("this run writes files, which do not go back: restore() a Simulation without `output`");
    alone([&] { run_->restore(image); });
    tables_.go_back(run_->state.time, run_->state.step == 0);
    has_fault_ = false;
  }

  std::string summary()
  {
    const MyTurn turn(in_use_);
    return summary_text(summarise(run_->model, run_->state), ended(), {file_->values.name, file_->text});
  }
  std::string warnings()
  {
    const MyTurn turn(in_use_);
    return render_warnings(find_warnings(run_->model, run_->state), *file_);
  }
  std::string stage()
  {
    const MyTurn turn(in_use_);
    return run_->model.stage.name;
  }
  Real end_time()
  {
    const MyTurn turn(in_use_);
    return run_->model.time_of(last_step_of_run(run_->model, run_->state));
  }

  /// The files of the run as far as it is, with a checkpoint from which `terp resume` goes on.
  void finish()
  {
    if (!files_) return;
    alone([&] {
      static constexpr std::atomic<bool> at_once{true};
      if (!ended() && run_->state.step > 0 && !has_fault_) run_->step(1, at_once);  // makes none
      files_->finish(ended());
    });
  }

 private:
  /// Holds the simulation, if nobody else does: another thread, or the function of a signal that comes during steps.
  class Turn {
   public:
    explicit Turn(std::atomic<bool>& in_use) : is_mine(!in_use.exchange(true)), in_use_(in_use) {}
    ~Turn()
    {
      if (is_mine) in_use_ = false;
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    const bool is_mine;

   private:
    std::atomic<bool>& in_use_;
  };

  /// Throws if it is not.
  class MyTurn : public Turn {
   public:
    explicit MyTurn(std::atomic<bool>& in_use) : Turn(in_use)
    {
      if (!is_mine)
        throw std::runtime_error("this simulation is in use by another thread: give each thread one of its own");
    }
  };

  bool is_parameter(const std::string& name) const
  {
    return std::ranges::any_of(run_->model.description.materials, [&](const MaterialCase& material) {
      return std::ranges::any_of(material.fields, [&](const ParameterField& field) {
        return row_of_parameter(material.type()->parameters[field.parameter]).name == name;
      });
    });
  }

  bool ended() const { return run_->model.stage.is_last() && terp::has_ended(run_->model, run_->state); }

  /// What is wrong with what Python asked for, which is no fault of the case.
  template <class F>
  void answer(F&& f)
  {
    try {
      f();
    } catch (const InputError& error) {
      const Problem& problem = error.problems().front();
      throw CaseError(problem.key + ": " + problem.what + "\n  " + problem.detail);
    }
  }

  /// Without Python's lock, by one thread at a time. What is wrong with the case is told in the words of its file.
  template <class F>
  void alone(F&& f)
  {
    const MyTurn turn(in_use_);
    const py::gil_scoped_release others_go_on;
    try {
      f();
    } catch (const InputError& error) {
      throw CaseError(render(error.problems(), *file_));
    }
  }

  template <class F>
  void solve(F&& f)
  {
    watch_.stop = false;
    try {
      alone(f);
    } catch (const RunError&) {
      has_fault_ = true;
      throw;
    }
    if (watch_.stop) throw py::error_already_set();
    if (files_ && has_ended()) finish();
  }

  struct View {
    Index n = -1, capacity = -1;
    py::object array;
  };

  py::array view_of(const PointBlock<2>& block, const RowInfo& row) const
  {
    std::vector<py::ssize_t> shape{block.n}, strides{sizeof(Real)};
    if (row.n > 1) shape.push_back(row.n), strides.push_back(block.capacity * static_cast<py::ssize_t>(sizeof(Real)));
    return read_only(py::array_t<double>(std::move(shape), std::move(strides), block.row(row.first), memory_));
  }

  std::shared_ptr<const CaseFile> file_;
  std::shared_ptr<Simulation> run_;
  std::unique_ptr<RunFiles> files_;
  SignalWatch watch_;
  RowKeeper tables_;
  std::atomic<bool> in_use_ = false;
  bool has_fault_ = false;                                      // the run stopped itself
  py::object memory_;                                           // of the points; views share it and keep it
  std::map<int, std::unordered_map<const Real*, View>> views_;  // by first row and block
};

/// A view of what never changes, kept alive by the mesh that it is of.
template <class Value, class Entries>
py::array of_mesh(const SharedMesh& mesh, const Entries& entries, py::ssize_t n_columns)
{
  const py::capsule owner(new SharedMesh(mesh), [](void* p) { delete static_cast<SharedMesh*>(p); });
  return read_only(
      py::array_t<Value>({std::ssize(entries), n_columns}, reinterpret_cast<const Value*>(entries.data()), owner));
}

/// Errors of Terp as those of the package, with the same message.
void translate_errors()
{
  py::register_exception_translator([](std::exception_ptr error) {
    const auto raise = [](const char* name, const char* what) {
      PyErr_SetString(py::module_::import("terp.errors").attr(name).ptr(), what);
    };
    try {
      if (error) std::rethrow_exception(error);
    } catch (const CaseError& e) {
      raise("CaseError", e.what());
    } catch (const InputError& e) {
      raise("CaseError", e.what());
    } catch (const RunError& e) {
      raise("SolveError", e.what());
    } catch (const FileError& e) {
      raise("RunError", e.what());
    }
  });
}

using SharedCase = std::shared_ptr<CaseFile>;

void bind_case(py::module_& module)
{
  py::class_<CaseFile, SharedCase>(module, "CaseFile")
      .def_readonly("text", &CaseFile::text)
      .def_readonly("path", &CaseFile::path)
      .def_property_readonly("title", [](const CaseFile& file) { return file.values.title; })
      .def_property_readonly("name", [](const CaseFile& file) { return file.values.name; })
      .def_property_readonly("warnings", [](const CaseFile& file) { return render_warnings(file); })
      .def_property_readonly("names_files", [](const CaseFile& file) { return !file.inputs.empty(); })
      .def("changes_to_vary", &changes_to_vary);
  module.def("read_case", [](const std::string& path, const std::vector<std::string>& changes) {
    return std::make_shared<CaseFile>(read_case(path, changes));
  });
  module.def(
      "read_case_text", [](const std::string& text, const std::string& path, const std::vector<std::string>& changes) {
        return std::make_shared<CaseFile>(read_case_text(text, path, changes));
      });
}

void bind_simulation(py::module_& module)
{
  using S = PythonSimulation;
  py::class_<StateImage>(module, "SavedState")
      .def_readonly("time", &StateImage::time)
      .def_readonly("step", &StateImage::step);
  py::class_<S>(module, "Simulation")
      .def(py::init([](const SharedCase& file, int threads, const S* mesh_of, const std::string& output, bool force) {
        return std::make_unique<S>(file, threads, mesh_of, output, force);
      }))
      .def("start", &S::start)
      .def("step", &S::step)
      .def("advance_to", &S::advance_to)
      .def("run_until", &S::run_until)
      .def("field", &S::field)
      .def("set_field", &S::set_field)
      .def("blocks", &S::blocks)
      .def("fields", &S::fields)
      .def("table",
          [](S& s, const std::string& name) {
            py::list columns;
            for (RowKeeper::Column& column : s.table(name))
              columns.append(py::make_tuple(column.name, column.unit,
                  column.is_text ? py::cast(column.texts) : py::object(as_array(std::move(column.values), 1))));
            return columns;
          })
      .def("profile",
          [](S& s, double x) {
            py::list rows;
            for (const ProfileRow& row : s.profile(x)) {
              py::dict strengths;
              for (const ProfileStrength& strength : row.strengths) strengths[py::str(strength.name)] = strength.value;
              rows.append(py::make_tuple(row.depth, row.x[1], row.material, row.stress, row.pore, row.last_stress,
                  row.yield_stress, row.shear, strengths));
            }
            return rows;
          })
      .def("save", &S::save)
      .def("restore", &S::restore)
      .def("finish", &S::finish)
      .def_property_readonly("summary", &S::summary)
      .def_property_readonly("warnings", &S::warnings)
      .def_property_readonly("has_ended", &S::has_ended)
      .def_property_readonly("time", [](const S& s) { return s.run().state.time; })
      .def_property_readonly("n_steps", [](const S& s) { return s.run().state.step; })
      .def_property_readonly("dt", [](const S& s) { return s.run().model.dt; })
      .def_property_readonly("stage", &S::stage)
      .def_property_readonly("end_time", &S::end_time)
      .def_property_readonly("n_points", [](const S& s) { return s.run().state.n_ids(); })
      .def_property_readonly(
          "nodes", [](const S& s) { return of_mesh<double>(s.run().model.mesh, s.run().model.mesh->nodes, 2); })
      .def_property_readonly(
          "cells", [](const S& s) { return of_mesh<Index>(s.run().model.mesh, s.run().model.mesh->cells, 4); });
}

}  // namespace

PYBIND11_MODULE(_core, module)
{
  module.doc() = "The compiled part of terp. Use terp.Case and terp.Simulation.";
  module.attr("version") = TERP_VERSION;
  translate_errors();
  bind_case(module);
  bind_simulation(module);
  bind_element(module);
}

}  // namespace terp
