# `cmake --install`: the program, and the library as a CMake package. A program elsewhere then says
#   find_package(terp REQUIRED)
#   target_link_libraries(mine PRIVATE terp::core)
# and includes "run/loop/simulation.hpp". The package was compiled for the instruction sets of its build.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(TERP_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/terp)

set_target_properties(terp_core PROPERTIES EXPORT_NAME core)
target_compile_features(terp_core INTERFACE cxx_std_20)
target_compile_options(terp_core INTERFACE $<INSTALL_INTERFACE:-Wno-psabi>)  # packs of eight in the headers
install(TARGETS terp_core ${layers} EXPORT terpTargets ARCHIVE INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/terp)
install(TARGETS terp)
if(TARGET terp_openturns)
  install(TARGETS terp_openturns LIBRARY DESTINATION lib/terp)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/terp
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def" PATTERN "*.h")
install(EXPORT terpTargets NAMESPACE terp:: DESTINATION ${TERP_PACKAGE_FOLDER})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/terpConfigVersion.cmake COMPATIBILITY ExactVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/terpConfig.cmake ${PROJECT_BINARY_DIR}/terpConfigVersion.cmake
        DESTINATION ${TERP_PACKAGE_FOLDER})
