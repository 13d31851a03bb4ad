#include "element.hpp"

#include "io/element/element_case.hpp"
#include "io/element/element_csv.hpp"
#include "model/parts/setup.hpp"
#include "run/element/element_tests.hpp"

#include <cmath>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace terp {
namespace {

using Stress = std::array<Real, 4>;

/// name, unit, label and values of each column, and the fault.
py::tuple as_python(const ElementResult& result)
{
  py::list columns;
  for (const ElementColumn& column : result.columns)
    columns.append(py::make_tuple(column.name, column.unit, column.label, column.values));
  return py::make_tuple(columns, result.fault);
}

/// Soil with the stress that it begins with.
struct PythonElement {
  std::shared_ptr<const CaseFile> file;
  ElementAtPlace start;

  template <class F>
  auto told(F&& f) const
  {
    try {
      return f();
    } catch (const InputError& error) {
      throw CaseError(render(error.problems(), *file));
    }
  }
  py::tuple follow(const ElementPath& path, Real void_ratio) const
  {
    return told([&] { return as_python(follow_path(start.soil, path, void_ratio)); });
  }
};

PythonElement element_of(
    std::shared_ptr<const CaseFile> file, const std::string& name, const std::optional<Vec<2>>& place)
{
  PythonElement element{std::move(file), {}};
  element.told([&] {
    const Case& c = element.file->values;
    const MaterialCase& material = *materials_of_element(c, {name}).front();
    element.start = place ? element_at(build_model(c, 1), material, *place)
                          : ElementAtPlace{element_soil(c, material), start_of_element(c, material)};
    return 0;
  });
  return element;
}

}  // namespace

void bind_element(py::module_& module)
{
  module.def("read_element_case", [](const std::string& path, const std::vector<std::string>& changes) {
    return std::make_shared<CaseFile>(read_element_case(path, changes));
  });
  module.def("read_element_case_text",
      [](const std::string& text, const std::string& path, const std::vector<std::string>& changes) {
        return std::make_shared<CaseFile>(read_element_case_text(text, path, changes));
      });
  module.def("materials", [](const CaseFile& file) {
    std::vector<std::string> names;
    for (const MaterialCase& material : file.values.materials) names.push_back(material.name);
    return names;
  });
  module.def("element_tests", [] {
    std::vector<std::string> names;
    for (const ElementTestInfo& info : element_tests()) names.emplace_back(info.name);
    return names;
  });
  py::class_<PythonElement>(module, "Element")
      .def(py::init([](const std::shared_ptr<CaseFile>& file, const std::string& material,
                        const std::optional<Vec<2>>& place) { return element_of(file, material, place); }))
      .def_property_readonly("stress", [](const PythonElement& element) { return element.start.stress; })
      .def("test",
          [](const PythonElement& element, const std::string& test, const Stress& stress, bool undrained,
              const std::vector<Real>& strain, const std::vector<Real>& load, int increments, Real duration,
              Real void_ratio) {
            ElementTestOptions options{.stress = stress, .undrained = undrained, .strain = strain, .load = load};
            for (const ElementTestInfo& info : element_tests())
              if (info.name == test) options.test = &info;
            options.increments = increments, options.duration = duration;
            return element.follow(path_of_test(options), void_ratio);
          })
      .def("path", [](const PythonElement& element, const std::string& name, const std::string& text,
                       const Stress& stress, bool undrained, int increments, Real duration, Real void_ratio) {
        const PathFileOptions options{stress, undrained, increments, duration};
        ElementPath path;
        try {
          path = text.empty() ? read_path_csv(name, options) : read_path_csv_text(name, text, options);
        } catch (const FileError& error) {
          throw CaseError(std::string("error: ") + error.what() + '\n');
        }
        return element.follow(path, void_ratio);
      });
}

}  // namespace terp
