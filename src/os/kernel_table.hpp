// How code that is compiled once per instruction set offers itself to the rest of the program: a layer has tables of
// what its kernels offer, and each copy of the kernels holds one constant object of it.
//
//   a file of the kernels         TERP_KERNEL_TABLE(simulation, Kernels, table)
//                                 defines terp_simulation_<set>(), which returns &table
//   a file that is compiled once  declares these functions for each line of TERP_KERNEL_SETS (cmake/kernels.cmake), the
//                                 best set first, and takes number chosen_set() (instructions.hpp)
//
// Not for: what a table holds, which is the affair of the layer.
#pragma once

#define TERP_JOIN_(a, b) a##b
#define TERP_JOIN(a, b) TERP_JOIN_(a, b)

/// TERP_KERNEL_COPY: name of the set, from cmake/kernels.cmake.
#define TERP_KERNEL_TABLE(name, Table, table)                                  \
  extern "C" const terp::Table* TERP_JOIN(terp_##name##_, TERP_KERNEL_COPY)(); \
  extern "C" const terp::Table* TERP_JOIN(terp_##name##_, TERP_KERNEL_COPY)() { return &terp::table; }
