# The shared libraries.
#
# The command, the tests and the evaluation call internal functions, which a shared library hides. They
# therefore link the static libraries `pelt` and `pelt_asset`, in every build. BUILD_SHARED_LIBS selects
# what users get: what pelt::pelt and pelt::asset are, and what is installed.

# pelt_shared_library(LIBRARY NAME objects...): adds LIBRARY_shared, a shared library that is linked from
# the objects of the static LIBRARY and from other objects, and adds pelt::NAME. Nothing is compiled
# twice, so the tests have a shared library in each build. The caller links what LIBRARY links.
function(pelt_shared_library library name)
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  if(NOT BUILD_SHARED_LIBS)
    add_library(pelt::${name} ALIAS ${library})
    if(PELT_SANITIZE OR NOT PELT_BUILD_TESTS)
      return()
    endif()
  endif()
  add_library(${library}_shared SHARED $<TARGET_OBJECTS:${library}> ${ARGN})
  pelt_target(${library}_shared)
  set_target_properties(${library}_shared PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME ${library}
                                                      EXPORT_NAME ${name})
  target_compile_definitions(${library}_shared INTERFACE PELT_SHARED)
  get_target_property(folders ${library} INTERFACE_INCLUDE_DIRECTORIES)
  if(folders)
    target_include_directories(${library}_shared INTERFACE ${folders})
  endif()
  if(BUILD_SHARED_LIBS)
    add_library(pelt::${name} ALIAS ${library}_shared)
    target_compile_definitions(${library} PRIVATE PELT_SHARED PELT_BUILDING)
  endif()
endfunction()
