#include "element.hpp"

#include "io/element/element_case.hpp"
#include "io/element/element_csv.hpp"
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

py::tuple follow(
    const CaseFile& file, const std::vector<std::string>& material, const ElementPath& path, Real void_ratio)
{
  try {
    const MaterialCase& found = *materials_of_element(file.values, material).front();
    return as_python(follow_path(element_soil(file.values, found), path, void_ratio));
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
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
  module.def("element_test", [](const CaseFile& file, const std::string& material, const std::string& test,
                                 const Stress& stress, bool undrained, const std::vector<Real>& strain,
                                 const std::vector<Real>& load, int increments, Real duration, Real void_ratio) {
    ElementTestOptions options{.stress = stress, .undrained = undrained, .strain = strain, .load = load};
    for (const ElementTestInfo& info : element_tests())
      if (info.name == test) options.test = &info;
    options.increments = increments, options.duration = duration;
    return follow(file, {material}, path_of_test(options), void_ratio);
  });
  module.def("element_path",
      [](const CaseFile& file, const std::string& material, const std::string& name, const std::string& text,
          const Stress& stress, bool undrained, int increments, Real duration, Real void_ratio) {
        const PathFileOptions options{stress, undrained, increments, duration};
        ElementPath path;
        try {
          path = text.empty() ? read_path_csv(name, options) : read_path_csv_text(name, text, options);
        } catch (const FileError& error) {
          throw CaseError(std::string("error: ") + error.what() + '\n');
        }
        return follow(file, {material}, path, void_ratio);
      });
}

}  // namespace terp
