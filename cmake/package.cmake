# `make package`: a Debian package with the program, the Python package, documents, cases, manual page and completion.
# Headers and library are a component of their own, "development", which is not in it: `cmake --install` installs both.
set(TERP_MANUAL ${PROJECT_BINARY_DIR}/terp.1.gz)
add_custom_command(OUTPUT ${TERP_MANUAL}
                   COMMAND ${PROJECT_SOURCE_DIR}/packaging/make_man $<TARGET_FILE:terp> | gzip -9n > ${TERP_MANUAL}
                   DEPENDS terp ${PROJECT_SOURCE_DIR}/packaging/make_man)
set(TERP_SCHEMA ${PROJECT_BINARY_DIR}/terp.schema.json)
add_custom_command(OUTPUT ${TERP_SCHEMA} COMMAND terp schema > ${TERP_SCHEMA} DEPENDS terp)
add_custom_target(manual DEPENDS ${TERP_MANUAL} ${TERP_SCHEMA})

set(python_packages lib/python3/dist-packages)
install(FILES ${TERP_MANUAL} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT user EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/packaging/terp.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME terp COMPONENT user EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/terp DESTINATION ${python_packages} COMPONENT user EXCLUDE_FROM_ALL
        PATTERN __pycache__ EXCLUDE)
if(TARGET python_module)
  install(TARGETS python_module LIBRARY DESTINATION ${python_packages}/terp COMPONENT user EXCLUDE_FROM_ALL)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/terp COMPONENT user
        EXCLUDE_FROM_ALL PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cases DESTINATION ${CMAKE_INSTALL_DATADIR}/terp COMPONENT user
        EXCLUDE_FROM_ALL PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/src/soil/libraries/terp_law.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT user
        EXCLUDE_FROM_ALL)
install(FILES ${TERP_SCHEMA} DESTINATION ${CMAKE_INSTALL_DATADIR}/terp COMPONENT user EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT user EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT user EXCLUDE_FROM_ALL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT user
        EXCLUDE_FROM_ALL)
install(TARGETS terp COMPONENT user EXCLUDE_FROM_ALL)
if(TARGET terp_openturns)
  install(TARGETS terp_openturns LIBRARY DESTINATION lib/terp COMPONENT user EXCLUDE_FROM_ALL)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME terp)
# There is no address at which the authors are reached. Who publishes the package gives their own.
set(TERP_PACKAGE_CONTACT "The Terp authors <terp@example.org>" CACHE STRING "Maintainer of the Debian package")
set(CPACK_PACKAGE_CONTACT "${TERP_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Explicit material point method for soil that softens and fails")
set(CPACK_COMPONENT_USER_DESCRIPTION
    "Terp solves how a slope or dike of softening soil fails, and how far the soil moves.
It gives a verdict on a flood, a factor of safety, stages, and probabilities. The program
terp reads case files and sections of D-Stability; the Python package terp solves cases and
reads results. A soil law of your own is a shared library.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL user)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_USER_PACKAGE_NAME terp)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gmsh, python3-numpy, python3-h5py, python3-matplotlib, bash-completion")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gfortran, python3-pandas")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
include(CPack)
