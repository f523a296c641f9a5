# `cmake --install`: libraries, headers, a CMake package, pkg-config files, the command and its page.
include(CMakePackageConfigHelpers)

set(pelt_libraries pelt)
if(TARGET pelt_asset)
  list(APPEND pelt_libraries pelt_asset)
endif()
set(installed ${pelt_libraries})
if(BUILD_SHARED_LIBS)
  list(TRANSFORM installed APPEND _shared)
  # Before 1.0 a minor version may change the interface.
  set_target_properties(${installed} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()
install(TARGETS ${installed} EXPORT pelt)
set(not_built "")
if(NOT TARGET pelt_asset)
  set(not_built PATTERN asset.hpp EXCLUDE)
endif()
install(DIRECTORY include/pelt ${PROJECT_BINARY_DIR}/include/pelt TYPE INCLUDE
        FILES_MATCHING PATTERN "*.hpp" ${not_built})
install(FILES LICENSE docs/third-party.md TYPE DOC)

# --- CMake package: find_package(pelt) -> pelt::pelt, pelt::asset
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pelt)
configure_package_config_file(cmake/pelt-config.cmake.in pelt-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(pelt-config-version.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT pelt NAMESPACE pelt:: FILE pelt-targets.cmake DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/pelt-config.cmake ${PROJECT_BINARY_DIR}/pelt-config-version.cmake
        DESTINATION ${package_dir})

# --- pkg-config: pelt, pelt-asset. Paths are relative to the file, because `cmake --install` may
# change the prefix.
file(RELATIVE_PATH pc_to_include ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
     ${CMAKE_INSTALL_FULL_INCLUDEDIR})
# Libraries that a static library needs to link; a shared library loads them itself.
set(pc_meshoptimizer "")
if(NOT BUILD_SHARED_LIBS)
  set(pc_meshoptimizer -lmeshoptimizer)
endif()
set(pc_define "")
if(BUILD_SHARED_LIBS)
  set(pc_define -DPELT_SHARED)
endif()
set(pc_sanitize "")
if(PELT_SANITIZE)
  set(pc_sanitize -fsanitize=${PELT_SANITIZE})
endif()
foreach(library IN LISTS pelt_libraries)
  string(REPLACE _ - name ${library})
  configure_file(cmake/${name}.pc.in ${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

# --- the command
if(TARGET pelt_command)
  install(TARGETS pelt_command)
  install(FILES docs/pelt.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  # The page of `pelt view` and `pelt check --html`, if scripts/build-viewer has built it.
  install(FILES viewer/dist/index.html DESTINATION ${CMAKE_INSTALL_DATADIR}/pelt
          RENAME viewer.html OPTIONAL)
endif()
