# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# What an installation holds besides the programs, and a Debian package of it: cmake --build build/release --target package
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The libraries: install(TARGETS) stands with them, in esm_public().
if(NOT ESM_SANITIZE)
  foreach(kind static shared)
    install(EXPORT esm-${kind} NAMESPACE esm:: DESTINATION ${ESM_CMAKE_FOLDER} COMPONENT development)
  endforeach()
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/esmConfig.cmake.in ${PROJECT_BINARY_DIR}/esmConfig.cmake
  INSTALL_DESTINATION ${ESM_CMAKE_FOLDER} PATH_VARS ESM_WORKER_FOLDER)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/esmConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/esmConfig.cmake ${PROJECT_BINARY_DIR}/esmConfigVersion.cmake
  DESTINATION ${ESM_CMAKE_FOLDER} COMPONENT development)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/samples DESTINATION ${CMAKE_INSTALL_DATADIR}/esm)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ ${PROJECT_SOURCE_DIR}/LICENSES DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(ESM_GUI)
  install(FILES ${PROJECT_SOURCE_DIR}/resources/desktop/esm-modeler.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
endif()

# Three packages: the programs, what a host runs with, what a host is built with.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENT_UNSPECIFIED_GROUP programs)
set(CPACK_COMPONENT_IMPORT_WORKER_GROUP shared)
set(CPACK_COMPONENT_SHARED_GROUP shared)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(library libesm${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME esm)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION})") # for the import worker
set(CPACK_DEBIAN_SHARED_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_SHARED_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libesm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION}), libeigen3-dev, zlib1g-dev")
set(CPACK_PACKAGE_NAME esm)
set(CPACK_PACKAGE_CONTACT "The ESM authors <esm@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # needs dpkg-shlibdeps
set(CPACK_STRIP_FILES ON)
include(CPack)
