# The instruction sets of the hot code (src/base/instruction_set.hpp), and their compiler flags. A WebAssembly module
# is compiled either with or without vector instructions; Pelt's always has them.
set(PELT_INSTRUCTION_SETS scalar)
if(EMSCRIPTEN)
  set(PELT_INSTRUCTION_SETS "")
endif()
set(PELT_WIDE_FLAGS_scalar -DPELT_INSTRUCTION_SET=scalar -DPELT_SCALAR)
# A quick build (see pelt_compiled_quickly) leaves out the middle one of three, and hardly optimises the scalar one, which
# only very old processors use.
if(NOT PELT_SCALAR)
  if(NOT (PELT_QUICK_BUILD AND PELT_X86))
    list(APPEND PELT_INSTRUCTION_SETS simd128)
  endif()
  set(PELT_WIDE_FLAGS_simd128 -DPELT_INSTRUCTION_SET=simd128)
  if(PELT_X86)
    list(APPEND PELT_WIDE_FLAGS_simd128 -msse4.1)
    list(APPEND PELT_INSTRUCTION_SETS avx2)
    set(PELT_WIDE_FLAGS_avx2 -DPELT_INSTRUCTION_SET=avx2 -DPELT_INSTRUCTION_SET_AVX2 -mavx2)
  endif()
endif()

# pelt_wide_sources(LIBRARY sources...): adds sources that are compiled for every instruction set. Defines
# PELT_HAS_SCALAR, PELT_HAS_SIMD128 and PELT_HAS_AVX2 for those that exist.
function(pelt_wide_sources library)
  foreach(set IN LISTS PELT_INSTRUCTION_SETS)
    set(objects ${library}_${set})
    add_library(${objects} OBJECT ${ARGN})
    pelt_library_target(${objects})
    pelt_compiled_together(${objects} BY_FOLDER)
    target_compile_options(${objects} PRIVATE ${PELT_WIDE_FLAGS_${set}})
    if(PELT_X86 AND set STREQUAL "scalar")
      pelt_compiled_quickly(${objects})
    endif()
    target_include_directories(${objects}
      PRIVATE $<TARGET_PROPERTY:${library},INCLUDE_DIRECTORIES>)
    target_sources(${library} PRIVATE $<TARGET_OBJECTS:${objects}>)
    string(TOUPPER ${set} name)
    target_compile_definitions(${library} PRIVATE PELT_HAS_${name})
  endforeach()
endfunction()
