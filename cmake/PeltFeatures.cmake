# The features of the build, and the packages that each of them needs.
#
# A feature is ON, OFF or AUTO. AUTO builds the feature if its packages are installed, and prints one
# line if they are not. ON stops the configuration instead.

# pelt_find(PACKAGE): looks for the contents of the Debian package PACKAGE, and sets
# FOUND_<PACKAGE>. A macro, because the caller needs the variables that find_package sets.
macro(pelt_find package)
  set(FOUND_${package} FALSE)
  if("${package}" STREQUAL nlohmann-json3-dev)
    find_package(nlohmann_json 3.11 QUIET)
    set(FOUND_${package} ${nlohmann_json_FOUND})
  elseif("${package}" STREQUAL libmeshoptimizer-dev)
    find_library(PELT_MESHOPTIMIZER meshoptimizer)
    set(FOUND_${package} ${PELT_MESHOPTIMIZER})
  elseif("${package}" STREQUAL libcli11-dev)
    find_package(CLI11 QUIET)
    set(FOUND_${package} ${CLI11_FOUND})
  elseif("${package}" STREQUAL python3)
    find_package(Python3 QUIET COMPONENTS Interpreter)
    set(FOUND_${package} ${Python3_FOUND})
  elseif("${package}" STREQUAL libgtest-dev)
    find_package(GTest QUIET)
    set(FOUND_${package} ${GTest_FOUND})
  elseif("${package}" STREQUAL libgmp-dev)
    find_library(PELT_GMP gmp)
    find_library(PELT_GMPXX gmpxx)
    if(PELT_GMP AND PELT_GMPXX)
      set(FOUND_${package} TRUE)
    endif()
  elseif("${package}" STREQUAL libcgal-dev)
    find_library(PELT_GMP gmp)
    if(PELT_GMP) # without it, CGAL's package stops the configuration
      set(CMAKE_MESSAGE_LOG_LEVEL WARNING) # CGAL reports each library that it finds
      find_package(CGAL QUIET)
      unset(CMAKE_MESSAGE_LOG_LEVEL)
      set(FOUND_${package} ${CGAL_FOUND})
    endif()
  elseif("${package}" STREQUAL python3-numpy)
    pelt_find_python()
    if(PELT_PYTHON)
      set(FOUND_${package} TRUE)
    endif()
  elseif("${package}" STREQUAL python3-dev)
    if(PELT_PYTHON)
      set(Python_EXECUTABLE ${PELT_PYTHON})
    endif()
    find_package(Python QUIET COMPONENTS Interpreter Development.Module)
    set(FOUND_${package} ${Python_Development.Module_FOUND})
  elseif("${package}" STREQUAL pybind11-dev)
    set(PYBIND11_NOPYTHON ON) # Python is found above
    find_package(pybind11 2.10 CONFIG QUIET)
    set(FOUND_${package} ${pybind11_FOUND})
  else()
    message(FATAL_ERROR "pelt_find does not know the package ${package}")
  endif()
endmacro()

# pelt_missing(RESULT PACKAGES...): looks for the packages, and sets RESULT to those not found.
macro(pelt_missing result)
  set(${result} "")
  foreach(pelt_package ${ARGN})
    pelt_find(${pelt_package})
    if(NOT FOUND_${pelt_package})
      list(APPEND ${result} ${pelt_package})
    endif()
  endforeach()
endmacro()

# pelt_left_out(FEATURE WHAT REASON PACKAGES...): prints the line for what is not built; an error if
# FEATURE is ON. The error also names PACKAGES, which the lines of other features name.
function(pelt_left_out feature what reason)
  if("${${feature}_WISH}" STREQUAL AUTO)
    message(STATUS "Pelt: without ${what} (${reason})")
  else()
    if(ARGN)
      list(JOIN ARGN " " packages)
      string(APPEND reason "; install ${packages}")
    endif()
    message(FATAL_ERROR "Pelt: ${feature} is ON, but this cannot be built: ${what} (${reason})")
  endif()
endfunction()

# pelt_feature(NAME DESCRIPTION [AFTER FEATURE] [PACKAGES packages...]): declares the option NAME, AUTO
# in Pelt's own build and OFF inside another project, and then sets NAME to ON or OFF for this folder
# and those below. NAME is OFF without the feature AFTER. Sets NAME_ABSENT to the packages that NAME and
# AFTER lack.
macro(pelt_feature name description)
  cmake_parse_arguments(PELT_FEATURE "" "AFTER" "PACKAGES" ${ARGN})
  set(pelt_default OFF)
  if(PROJECT_IS_TOP_LEVEL)
    set(pelt_default AUTO)
  endif()
  set(${name} ${pelt_default} CACHE STRING "Build ${description}: ON, OFF, or AUTO (if possible)")
  set_property(CACHE ${name} PROPERTY STRINGS AUTO ON OFF)
  set(${name}_WISH ${${name}})
  set(${name}_ABSENT "")
  if(${name})
    set(${name} OFF)
    pelt_missing(pelt_absent ${PELT_FEATURE_PACKAGES})
    set(${name}_ABSENT ${${PELT_FEATURE_AFTER}_ABSENT} ${pelt_absent})
    if(PELT_FEATURE_AFTER AND NOT ${PELT_FEATURE_AFTER})
      pelt_left_out(${name} "${description}" "needs ${PELT_FEATURE_AFTER}" ${${name}_ABSENT})
    elseif(pelt_absent)
      list(JOIN pelt_absent " " pelt_absent)
      pelt_left_out(${name} "${description}" "install ${pelt_absent}")
    else()
      set(${name} ON)
    endif()
  endif()
endmacro()

# pelt_part(FEATURE DESCRIPTION PACKAGES...): looks for packages that only a part of FEATURE needs, and
# prints the line for the part if one is missing.
macro(pelt_part feature description)
  pelt_missing(pelt_absent ${ARGN})
  if(pelt_absent)
    list(JOIN pelt_absent " " pelt_absent)
    pelt_left_out(${feature} "${description}" "install ${pelt_absent}")
  endif()
endmacro()

# pelt_program(PROGRAM PACKAGE DESCRIPTION): prints a line if a program is missing that is called at
# run time. Sets PELT_PROGRAM_<PROGRAM> to the path of the program.
function(pelt_program program package description)
  find_program(PELT_PROGRAM_${program} ${program})
  if(NOT PELT_PROGRAM_${program})
    message(STATUS "Pelt: without ${description} (install ${package})")
  endif()
endfunction()
