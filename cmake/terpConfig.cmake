# find_package(terp) gives terp::core: the library with its kernels.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(fmt)
find_dependency(muparser)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/terpTargets.cmake)
