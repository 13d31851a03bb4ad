# The kernels: what a step spends its time in, compiled once per instruction set (docs/decisions/0028). One of the sets
# is chosen when the program starts, in src/os/instructions.cpp.

# Compiled for each set, and there alone, of soil and of mpm. A new law or scheme belongs to them by itself.
file(GLOB TERP_KERNELS_soil CONFIGURE_DEPENDS src/soil/laws/*.cpp)
list(REMOVE_ITEM TERP_KERNELS_soil ${PROJECT_SOURCE_DIR}/src/soil/laws/material.cpp)
file(GLOB TERP_KERNELS_mpm CONFIGURE_DEPENDS src/mpm/schemes/*.cpp src/mpm/features/*_kernels.cpp)
list(REMOVE_ITEM TERP_KERNELS_mpm ${PROJECT_SOURCE_DIR}/src/mpm/schemes/scheme.cpp)
foreach(kernel os/machine mpm/step/core_kernels mpm/step/kernel_table mpm/step/score mpm/step/step mpm/step/totals)
  list(APPEND TERP_KERNELS_mpm ${PROJECT_SOURCE_DIR}/src/${kernel}.cpp)
endforeach()
set(TERP_KERNEL_SOURCES ${TERP_KERNELS_soil} ${TERP_KERNELS_mpm})
# With TERP_UNITY: small files, whose headers take longer than they do.
file(GLOB TERP_FEATURE_KERNELS CONFIGURE_DEPENDS src/mpm/features/*_kernels.cpp)
set_source_files_properties(${TERP_FEATURE_KERNELS} PROPERTIES UNITY_GROUP feature_kernels)
# The tables of each (src/os/kernel_table.hpp), the files that offer them, and those that choose.
set(TERP_TABLES_soil materials)
set(TERP_TABLES_mpm schemes simulation)
set(TERP_KERNEL_TABLES src/soil/laws/laws.cpp src/mpm/schemes/scheme_list.cpp src/mpm/step/kernel_table.cpp)
set(TERP_KERNEL_CHOICES src/os/instructions.cpp src/soil/laws/material.cpp src/mpm/schemes/scheme.cpp
                        src/mpm/step/kernels.cpp)
# Compiled for each set, and once more for what calls them before the first step (seeding) and for their tests.
set(TERP_SHARED_soil)
set(TERP_SHARED_mpm src/mpm/mesh/locate.cpp src/mpm/points/move.cpp src/mpm/kernels/gauss_average.cpp
                    src/mpm/kernels/overlap.cpp src/mpm/features/cut_cells.cpp src/mpm/features/soil_border.cpp)

# Read once for all files of a copy, with TERP_UNITY.
set(TERP_HEADERS_soil src/soil/laws/law.hpp)
set(TERP_HEADERS_mpm src/soil/laws/law.hpp src/mpm/schemes/scheme.hpp)

set(TERP_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
set(TERP_FLAGS_avx2 -march=x86-64-v3)
# Here an operation on a pack has four parts, which GCC takes for too long to be inlined early: a step took 1.4 times as
# long, in the same bits.
set(TERP_FLAGS_sse2 -march=x86-64 $<$<CXX_COMPILER_ID:GNU>:--param=early-inlining-insns=60>)

# With the address sanitizer a step is 2.4 times as fast when the kernels are optimised and GCC does not mark the scope
# of each pack that an expression makes. Limits of arrays, the heap and undefined behaviour are checked in them as
# everywhere. GCC 12.2 itself fails in its pass ipa-cp there.
if(TERP_SANITIZE OR TERP_TSAN)
  set(options -O2)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND options -fno-sanitize-address-use-after-scope -fno-ipa-cp)
  endif()
  set_source_files_properties(${TERP_KERNEL_SOURCES} ${TERP_SHARED_mpm}
                              PROPERTIES COMPILE_OPTIONS "${options}")
endif()

# Links a generated object with whatever links a library, where it was built or where it is installed. As a source of
# the library every object file of it would wait for it.
function(link_object target object)
  get_filename_component(name ${object} NAME_WE)
  add_custom_target(${name} DEPENDS ${object})
  include(GNUInstallDirs)
  set(folder ${CMAKE_INSTALL_LIBDIR}/terp)
  # As an option it stands before the library, so that what it needs is taken from there.
  target_link_options(${target} INTERFACE $<BUILD_INTERFACE:${object}>
                                          $<INSTALL_INTERFACE:$<INSTALL_PREFIX>/${folder}/${name}.o>)
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_LINK_DEPENDS $<BUILD_INTERFACE:${object}>)
  install(FILES ${object} DESTINATION ${folder})
endfunction()

# So that a shared library, as a module of Python, can hold Terp. Calls within it stay direct: nobody replaces a
# function of Terp from outside.
function(position_independent target)
  if(EMSCRIPTEN)  # one program, which calls what it has at fixed places
    return()
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# Adds the kernels of a layer to a target. sets: the best first; "native" or "plain" alone mean one copy, linked like
# anything else.
function(add_kernels target layer sets)
  list(TRANSFORM sets REPLACE "(.+)" "TERP_KERNEL_SET(\\1)" OUTPUT_VARIABLE calls)
  list(JOIN calls " " calls)
  set_source_files_properties(${TERP_KERNEL_CHOICES} PROPERTIES COMPILE_DEFINITIONS "TERP_KERNEL_SETS=${calls}")
  if(sets STREQUAL "native" OR sets STREQUAL "plain")
    set_source_files_properties(${TERP_KERNEL_TABLES} PROPERTIES COMPILE_DEFINITIONS TERP_KERNEL_COPY=${sets})
    target_sources(${target} PRIVATE ${TERP_KERNELS_${layer}})
    return()
  endif()
  foreach(set ${sets})
    add_kernel_copy(${target} ${layer} ${set})
  endforeach()
endfunction()

# The same for Windows. The compiler must not move vectors as if they were aligned on the stack, which is aligned to 16
# bytes there (GCC's bug 54412): tools/check_vector_moves sees that the assembler was told.
function(close_kernels_windows kernels layer set whole object)
  target_compile_options(${kernels} PRIVATE -Wa,-muse-unaligned-vector-move)
  list(TRANSFORM TERP_TABLES_${layer} REPLACE "(.+)" "terp_\\1_${set}" OUTPUT_VARIABLE names)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_COMMAND} -DLINKER=${CMAKE_LINKER} -DOBJCOPY=${CMAKE_OBJCOPY}
            "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:${kernels}>,,>" -DWHOLE=${whole} -DOBJECT=${object}
            "-DKEEP=$<JOIN:${names},,>" -P ${PROJECT_SOURCE_DIR}/cmake/close_kernels_windows.cmake
    COMMAND ${PROJECT_SOURCE_DIR}/tools/check_vector_moves ${object}
    DEPENDS $<TARGET_OBJECTS:${kernels}> ${PROJECT_SOURCE_DIR}/cmake/close_kernels_windows.cmake
            ${PROJECT_SOURCE_DIR}/tools/check_vector_moves
    COMMENT "Closing the kernels of ${layer} for ${set}" VERBATIM)
endfunction()

# One relocatable object per set, with one global name per table. Inline functions and templates would else be merged
# between the copies and with the rest of the program by the linker, which takes any: --force-group-allocation ends
# their COMDAT groups, and objcopy makes their names local.
function(add_kernel_copy target layer set)
  set(kernels terp_kernels_${layer}_${set})
  add_library(${kernels} OBJECT ${TERP_KERNELS_${layer}} ${TERP_SHARED_${layer}})
  position_independent(${kernels})
  target_include_directories(${kernels} PRIVATE src)
  target_link_libraries(${kernels} PRIVATE fmt::fmt)
  target_compile_options(${kernels} PRIVATE ${TERP_FLAGS_${set}} -fno-gnu-unique)
  target_compile_definitions(${kernels} PRIVATE TERP_KERNEL_COPY=${set})
  if(TERP_UNITY AND NOT WIN32)
    target_precompile_headers(${kernels} PRIVATE <fmt/format.h> ${TERP_HEADERS_${layer}})
    set_target_properties(${kernels} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endif()
  set(objects "$<FILTER:$<TARGET_OBJECTS:${kernels}>,EXCLUDE,gch$>")  # which lists the header, too
  set(whole ${PROJECT_BINARY_DIR}/kernels_${layer}_${set}_whole.o)
  set(object ${PROJECT_BINARY_DIR}/kernels_${layer}_${set}.o)
  if(WIN32)
    close_kernels_windows(${kernels} ${layer} ${set} ${whole} ${object})
    link_object(${target} ${object})
    return()
  endif()
  list(TRANSFORM TERP_TABLES_${layer} REPLACE "(.+)" "--keep-global-symbol=terp_\\1_${set}" OUTPUT_VARIABLE keep)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${whole} ${objects}
    COMMAND ${CMAKE_OBJCOPY} ${keep} ${whole} ${object}
    DEPENDS ${objects}
    COMMENT "Closing the kernels of ${layer} for ${set}" COMMAND_EXPAND_LISTS VERBATIM)
  link_object(${target} ${object})
endfunction()
