# The kernels: what a step spends its time in, compiled once per instruction set (docs/decisions/0028). One of the sets
# is chosen when the program starts, in src/parallel/instructions.cpp.

# Compiled for each set, and there alone. A new law or scheme belongs to them by itself.
file(GLOB TERP_KERNEL_SOURCES CONFIGURE_DEPENDS src/materials/*.cpp src/schemes/*.cpp)
list(REMOVE_ITEM TERP_KERNEL_SOURCES ${PROJECT_SOURCE_DIR}/src/materials/material.cpp
                                     ${PROJECT_SOURCE_DIR}/src/materials/soil_material.cpp
                                     ${PROJECT_SOURCE_DIR}/src/schemes/cut_cells.cpp
                                     ${PROJECT_SOURCE_DIR}/src/schemes/soil_border.cpp
                                     ${PROJECT_SOURCE_DIR}/src/schemes/scheme.cpp)
foreach(kernel parallel/machine simulation/kernel_table simulation/step simulation/totals)
  list(APPEND TERP_KERNEL_SOURCES ${PROJECT_SOURCE_DIR}/src/${kernel}.cpp)
endforeach()
# Rooms whose kernels have a table (src/parallel/kernel_table.hpp), the files that offer it, and those that choose.
set(TERP_KERNEL_ROOMS materials schemes simulation)
set(TERP_KERNEL_TABLES src/materials/laws.cpp src/schemes/scheme_list.cpp src/simulation/kernel_table.cpp)
set(TERP_KERNEL_CHOICES src/parallel/instructions.cpp src/materials/material.cpp src/schemes/scheme.cpp
                        src/simulation/kernels.cpp)
# Compiled for each set, and once more for what calls them before the first step (seeding) and for their tests.
set(TERP_SHARED_KERNEL_SOURCES src/mesh/locate.cpp src/points/move.cpp src/transfer/gauss_average.cpp
                                src/transfer/overlap.cpp src/schemes/cut_cells.cpp src/schemes/soil_border.cpp)

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
  set_source_files_properties(${TERP_KERNEL_SOURCES} ${TERP_SHARED_KERNEL_SOURCES}
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
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# Adds the kernels to a target. sets: the best first; "native" or "plain" alone mean one copy, linked like anything
# else.
function(add_kernels target sets)
  list(TRANSFORM sets REPLACE "(.+)" "TERP_KERNEL_SET(\\1)" OUTPUT_VARIABLE calls)
  list(JOIN calls " " calls)
  set_source_files_properties(${TERP_KERNEL_CHOICES} PROPERTIES COMPILE_DEFINITIONS "TERP_KERNEL_SETS=${calls}")
  if(sets STREQUAL "native" OR sets STREQUAL "plain")
    set_source_files_properties(${TERP_KERNEL_TABLES} PROPERTIES COMPILE_DEFINITIONS TERP_KERNEL_COPY=${sets})
    target_sources(${target} PRIVATE ${TERP_KERNEL_SOURCES})
    return()
  endif()
  foreach(set ${sets})
    add_kernel_copy(${target} ${set})
  endforeach()
endfunction()

# The same for Windows. The compiler must not move vectors as if they were aligned on the stack, which is aligned to 16
# bytes there (GCC's bug 54412): tools/check_vector_moves sees that the assembler was told.
function(close_kernels_windows kernels set whole object)
  target_compile_options(${kernels} PRIVATE -Wa,-muse-unaligned-vector-move)
  list(TRANSFORM TERP_KERNEL_ROOMS REPLACE "(.+)" "terp_\\1_${set}" OUTPUT_VARIABLE names)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_COMMAND} -DLINKER=${CMAKE_LINKER} -DOBJCOPY=${CMAKE_OBJCOPY}
            "-DOBJECTS=$<JOIN:$<TARGET_OBJECTS:${kernels}>,,>" -DWHOLE=${whole} -DOBJECT=${object}
            "-DKEEP=$<JOIN:${names},,>" -P ${PROJECT_SOURCE_DIR}/cmake/close_kernels_windows.cmake
    COMMAND ${PROJECT_SOURCE_DIR}/tools/check_vector_moves ${object}
    DEPENDS $<TARGET_OBJECTS:${kernels}> ${PROJECT_SOURCE_DIR}/cmake/close_kernels_windows.cmake
            ${PROJECT_SOURCE_DIR}/tools/check_vector_moves
    COMMENT "Closing the kernels for ${set}" VERBATIM)
endfunction()

# One relocatable object per set, with one global name per table. Inline functions and templates would else be merged
# between the copies and with the rest of the program by the linker, which takes any: --force-group-allocation ends
# their COMDAT groups, and objcopy makes their names local.
function(add_kernel_copy target set)
  add_library(terp_kernels_${set} OBJECT ${TERP_KERNEL_SOURCES} ${TERP_SHARED_KERNEL_SOURCES})
  position_independent(terp_kernels_${set})
  target_include_directories(terp_kernels_${set} PRIVATE src)
  target_link_libraries(terp_kernels_${set} PRIVATE fmt::fmt)
  target_compile_options(terp_kernels_${set} PRIVATE ${TERP_FLAGS_${set}} -fno-gnu-unique)
  target_compile_definitions(terp_kernels_${set} PRIVATE TERP_KERNEL_COPY=${set})
  if(TERP_UNITY AND NOT WIN32)
    target_precompile_headers(terp_kernels_${set} PRIVATE <fmt/format.h> src/materials/law.hpp src/schemes/scheme.hpp)
  endif()
  set(objects "$<FILTER:$<TARGET_OBJECTS:terp_kernels_${set}>,EXCLUDE,gch$>")  # which lists the header, too
  set(whole ${PROJECT_BINARY_DIR}/kernels_${set}_whole.o)
  set(object ${PROJECT_BINARY_DIR}/kernels_${set}.o)
  if(WIN32)
    close_kernels_windows(terp_kernels_${set} ${set} ${whole} ${object})
    link_object(${target} ${object})
    return()
  endif()
  list(TRANSFORM TERP_KERNEL_ROOMS REPLACE "(.+)" "--keep-global-symbol=terp_\\1_${set}" OUTPUT_VARIABLE keep)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${whole} ${objects}
    COMMAND ${CMAKE_OBJCOPY} ${keep} ${whole} ${object}
    DEPENDS ${objects}
    COMMENT "Closing the kernels for ${set}" COMMAND_EXPAND_LISTS VERBATIM)
  link_object(${target} ${object})
endfunction()
