# Whole builds spend half of their time on reading headers. With TERP_UNITY the files of a folder are compiled as one,
# with precompiled headers. Who changes a single file, or shares a compiler cache between clones, does without: the
# `dev` preset. A name in an anonymous namespace is then seen by the files beside its own, so it stands once in a
# folder.

if(TERP_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # One folder needs up to 1.9 GB. Where the compiler does not look for memory to free before, it is 9 % faster.
  add_compile_options("SHELL:--param ggc-min-heapsize=800000")
endif()

# Compiles the sources of a target together: those of each folder as one, or all of it as one where none are named.
# What has options of its own stays alone.
function(compile_together target)
  if(NOT TERP_UNITY OR WIN32)  # whose headers define words like `near`
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  if(NOT ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE BATCH UNITY_BUILD_BATCH_SIZE 0)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME name)
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${name})
  endforeach()
endfunction()
