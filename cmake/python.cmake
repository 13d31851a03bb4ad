# The compiled part of the Python package, beside the program: build/python/terp/_core.*.so. `PYTHONPATH=python` of the
# sources finds it there if build/python is in PYTHONPATH, too; an installed package has it in its own folder.
find_program(DEBIAN_PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
set(Python_EXECUTABLE ${DEBIAN_PYTHON3})
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 REQUIRED)

file(GLOB TERP_MODULE CONFIGURE_DEPENDS python/module/*.cpp)
pybind11_add_module(python_module MODULE NO_EXTRAS ${TERP_MODULE})
set_target_properties(python_module PROPERTIES OUTPUT_NAME _core CXX_VISIBILITY_PRESET hidden
                      BUILD_WITH_INSTALL_RPATH ON  # all that it links to lies where the system looks
                      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python/terp)
target_include_directories(python_module PRIVATE python/module)
target_compile_options(python_module PRIVATE $<$<CONFIG:Release>:-O1>)  # it calls; the library computes
target_link_libraries(python_module PRIVATE terp_core)
