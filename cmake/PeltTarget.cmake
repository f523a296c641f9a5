# Whether Pelt is compiled for an x86 processor. Emscripten calls its own processor x86.
set(PELT_X86 FALSE)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|x86|i[3-6]86)$" AND NOT EMSCRIPTEN)
  set(PELT_X86 TRUE)
endif()

# Settings of every target of Pelt: language level, warnings, floating point that is the same on
# every machine, sanitizers.
function(pelt_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  # A fused multiply-add rounds once instead of twice, so it would give posed vertices other bits on
  # machines that have it. Without errno, a square root is a single instruction that can be
  # vectorised; no code reads errno after a square root.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno)
  # 32-bit x86 otherwise computes in registers of 80 bits, which round differently.
  if(PELT_X86 AND CMAKE_SIZEOF_VOID_P EQUAL 4)
    target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion)
  if(EMSCRIPTEN)
    # The reader counts bytes in 64 bits; its budget limits them to the 32 bits of an address.
    target_compile_options(${target} PRIVATE -msimd128 -Wno-shorten-64-to-32)
  endif()
  if(PELT_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(PELT_SCALAR)
    target_compile_definitions(${target} PRIVATE PELT_SCALAR)
  endif()
  if(PELT_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${PELT_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${PELT_SANITIZE})
  endif()
endfunction()

# pelt_library_target(TARGET): pelt_target for a library that is installed. What PELT_API does not mark
# is hidden, in a shared library and in programs.
function(pelt_library_target target)
  pelt_target(${target})
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# pelt_compiled_fast(TARGET): with sanitizers, optimises the library but not the code that uses it,
# which halves the compile time.
function(pelt_compiled_fast target)
  if(PELT_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# pelt_compiled_quickly(TARGET): with PELT_QUICK_BUILD, compiles TARGET with -O1, in two thirds of the
# time. The library, except its scalar code, and the methods that `pelt bench` measures are always
# fully optimised.
option(PELT_QUICK_BUILD "Compile reader, scenes, command and scalar code with -O1, and leave out simd128: a first build is shorter" OFF)
function(pelt_compiled_quickly target)
  if(PELT_QUICK_BUILD)
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# pelt_compiled_small(TARGET [ONLY sources...]): for WebAssembly, which is downloaded, prefers size to
# speed. For code that runs once per file or call and has no hot loops.
function(pelt_compiled_small target)
  cmake_parse_arguments(ARG "" "" "ONLY" ${ARGN})
  if(NOT EMSCRIPTEN)
    return()
  endif()
  if(ARG_ONLY)
    set_source_files_properties(${ARG_ONLY} PROPERTIES COMPILE_OPTIONS -Os)
  else()
    target_compile_options(${target} PRIVATE -Os)
  endif()
endfunction()

# pelt_precompiled(TARGET headers...): with PELT_PRECOMPILE, compiles these headers once for all
# files of TARGET. A compiler cache saves more, but needs a setting for precompiled headers (see
# scripts/test).
option(PELT_PRECOMPILE "Compile once what many files include: a first build is shorter" OFF)
set(PELT_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <cstring> <functional> <memory>
                          <optional> <span> <string> <string_view> <utility> <vector>)
function(pelt_precompiled target)
  if(PELT_PRECOMPILE)
    # A file with other flags includes the headers as text, which is not an error.
    set_target_properties(${target} PROPERTIES PCH_WARN_INVALID OFF)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# pelt_compiled_together(TARGET [BY_FOLDER] [ALONE sources...]): with PELT_COMPILE_TOGETHER,
# compiles the files of TARGET twenty at a time, or all files of a folder at once, because most of
# the time goes into headers that they share. ALONE lists files that define a name of another file
# differently.
option(PELT_COMPILE_TOGETHER "Compile many small files at once: a first build is shorter" OFF)
function(pelt_compiled_together target)
  cmake_parse_arguments(ARG "BY_FOLDER" "" "ALONE" ${ARGN})
  if(NOT PELT_COMPILE_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 20)
  if(ARG_BY_FOLDER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(GET source PARENT_PATH folder)
      string(REPLACE / _ folder "${folder}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}")
    endforeach()
  endif()
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
