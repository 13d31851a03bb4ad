# Whole builds spend half of their time on reading headers. With TERP_UNITY six files of a room are compiled as one,
# with precompiled headers. Who changes a single file, or shares a compiler cache between clones, does without: the
# `dev` preset. A name in an anonymous namespace is then seen by the files beside its own, so it stands once in a room.

# Compiles the sources of a target together, six files of one folder at a time. What has options of its own stays alone.
function(compile_together target)
  if(NOT TERP_UNITY OR WIN32)  # whose headers define words like `near`
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME room)
    if(NOT DEFINED files_${room})
      set(files_${room} 0)
    endif()
    math(EXPR batch "${files_${room}} / 6")
    math(EXPR files_${room} "${files_${room}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${batch})
  endforeach()
endfunction()
