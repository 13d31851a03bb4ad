// For the leak sanitizer, included by tests that make HDF5 refuse a damaged file: HDF5 1.10 itself loses memory.
#pragma once

extern "C" inline __attribute__((used)) const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
