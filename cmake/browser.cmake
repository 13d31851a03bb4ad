# Toolchain file: WebAssembly in a page of a browser, compiled by Debian 13's emscripten. Used by `make browser` and
# tools/build_browser_libraries. TERP_EMSCRIPTEN: where tools/unpack_emscripten put it; TERP_BROWSER_LIBRARIES: where
# tools/build_browser_libraries puts what it makes.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TERP_EMSCRIPTEN TERP_BROWSER_LIBRARIES)
include(${TERP_EMSCRIPTEN}/debian/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_FIND_ROOT_PATH ${TERP_BROWSER_LIBRARIES})
