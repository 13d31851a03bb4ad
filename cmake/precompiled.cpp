// For the precompiled header of cmake/layers.cmake.
