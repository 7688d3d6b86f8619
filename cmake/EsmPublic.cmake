# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
# The libraries as other programs see them (docs/EMBEDDING.md).
include(GNUInstallDirs)

set(ESM_INCLUDE_FOLDER ${CMAKE_INSTALL_INCLUDEDIR}/esm-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(ESM_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/esm)
set(ESM_WORKER_FOLDER ${CMAKE_INSTALL_LIBEXECDIR}/esm)

# esm_public(NAME LAYERS targets... HEADERS files... LINK public-dependencies... PRIVATE private-dependencies...)
# esm::NAME: in this build all that the layers are; installed, one library of the same objects (static and shared) with
# the headers, which are named from the folder of the caller.
function(esm_public name)
  cmake_parse_arguments(arg "" "" "LAYERS;HEADERS;LINK;PRIVATE" ${ARGN})
  add_library(esm_public_${name} INTERFACE)
  target_link_libraries(esm_public_${name} INTERFACE ${arg_LAYERS} ${arg_LINK})
  add_library(esm::${name} ALIAS esm_public_${name})
  if(NOT ESM_INSTALL OR ESM_SANITIZE) # nobody wants sanitizers in what is installed
    return()
  endif()
  list(TRANSFORM arg_LAYERS REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  list(TRANSFORM arg_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  string(REPLACE esm-core esm library esm-${name})
  foreach(kind static shared)
    string(TOUPPER ${kind} type)
    set(target esm_${name}_${kind})
    add_library(${target} ${type} ${objects})
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
    list(TRANSFORM arg_LINK REPLACE "^esm::(.*)" "esm_\\1_${kind}" OUTPUT_VARIABLE public)
    target_link_libraries(${target} PUBLIC ${public} PRIVATE ${arg_PRIVATE})
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${library} EXPORT_NAME ${name} LINKER_LANGUAGE CXX
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN)
    install(TARGETS ${target} EXPORT esm-${kind}
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT shared NAMELINK_COMPONENT development
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
      FILE_SET HEADERS DESTINATION ${ESM_INCLUDE_FOLDER} COMPONENT development)
  endforeach()
  # pkg-config finds the prefix from the place of its file, so that the tree can be moved.
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" ESM_UP "${up}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${library}.pc.in ${PROJECT_BINARY_DIR}/${library}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
