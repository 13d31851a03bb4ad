// Element tests for Python: terp.element (docs/element.md).
#pragma once

#include <pybind11/pybind11.h>

namespace terp {

void bind_element(pybind11::module_& module);

}  // namespace terp
