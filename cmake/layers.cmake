# The layers of src/ (ARCHITECTURE.md): a static library each, which links those to its left and its own third parties.

# With TERP_UNITY: what most of the program includes, read once for all layers that are compiled alike.
if(TERP_UNITY)
  add_library(terp_headers OBJECT cmake/precompiled.cpp)
  target_include_directories(terp_headers PRIVATE src)
  target_link_libraries(terp_headers PRIVATE Threads::Threads fmt::fmt)
  target_compile_definitions(terp_headers PRIVATE TERP_VERSION="${PROJECT_VERSION}")
  target_compile_options(terp_headers PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${EMSCRIPTEN}>,-Oz,-O1>>)
  position_independent(terp_headers)
  target_precompile_headers(terp_headers PRIVATE cmake/precompiled.hpp)
endif()

# For what a step does not spend its time in -O1 is as fast, and compiles a third faster. In a page of a browser size
# counts.
function(compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${EMSCRIPTEN}>,-Oz,-O1>>)
  if(TERP_UNITY)
    target_precompile_headers(${target} REUSE_FROM terp_headers)
  endif()
endfunction()

# The sources of a layer for this system.
function(find_layer_sources name result)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(REMOVE_ITEM sources ${TERP_KERNEL_SOURCES} ${PROJECT_SOURCE_DIR}/src/batch/openturns.cpp)
  # What asks the operating system has one file for each (src/os/README.md).
  if(WIN32)
    list(FILTER sources EXCLUDE REGEX "_(posix|wasm)\\.cpp$")
  elseif(EMSCRIPTEN)
    list(FILTER sources EXCLUDE REGEX "_win32\\.cpp$")
    foreach(twin ${sources})
      if(twin MATCHES "(.*)_wasm\\.cpp$")
        list(REMOVE_ITEM sources ${CMAKE_MATCH_1}.cpp ${CMAKE_MATCH_1}_posix.cpp)
      endif()
    endforeach()
  else()
    list(FILTER sources EXCLUDE REGEX "_(win32|wasm)\\.cpp$")
  endif()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# add_layer(NAME [STEPPED] [LEFT layers] [LIBRARIES third parties]); STEPPED: a step spends its time in it.
function(add_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 layer "STEPPED" "" "LEFT;LIBRARIES")
  find_layer_sources(${name} sources)
  add_library(terp_${name} STATIC ${sources})
  list(TRANSFORM layer_LEFT PREPEND terp_)
  target_link_libraries(terp_${name} PUBLIC Threads::Threads fmt::fmt ${layer_LEFT} PRIVATE ${layer_LIBRARIES})
  target_include_directories(terp_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_compile_definitions(terp_${name} PUBLIC TERP_VERSION="${PROJECT_VERSION}")
  compile_together(terp_${name} ${sources})
  position_independent(terp_${name})
  if(NOT layer_STEPPED)
    compile_quickly(terp_${name})
  endif()
endfunction()

add_layer(math STEPPED)
add_layer(os LEFT math LIBRARIES ${CMAKE_DL_LIBS})
add_layer(soil STEPPED LEFT os)
add_layer(mpm STEPPED LEFT soil)
add_layer(model LEFT mpm)
add_layer(run LEFT model)
add_layer(io LEFT run LIBRARIES ${HDF5_C_LIBRARIES} muparser::muparser ZLIB::ZLIB)
target_include_directories(terp_io SYSTEM PRIVATE ${HDF5_INCLUDE_DIRS})
add_layer(import LEFT io LIBRARIES ${ZIP_LIBRARY})
add_layer(page LEFT io)
add_layer(batch LEFT page LIBRARIES ${CMAKE_DL_LIBS})
if(EMSCRIPTEN)  # Boost 1.74 takes libc++ to have std::unary_function; clang 19 fails on its long double, which is slow
  target_compile_definitions(terp_batch PRIVATE BOOST_NO_CXX98_FUNCTION_BASE BOOST_MATH_NO_LONG_DOUBLE_MATH_FUNCTIONS)
endif()
set(TERP_LAYERS math os soil mpm model run io import page batch)

# All of them, for whoever wants Terp and not a layer: the program, the module of Python, a program elsewhere.
add_library(terp_core INTERFACE)
list(TRANSFORM TERP_LAYERS PREPEND terp_ OUTPUT_VARIABLE layers)
target_link_libraries(terp_core INTERFACE ${layers})
