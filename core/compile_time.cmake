# Settings that shorten compilation. The preset `dev` uses none of them: it compiles every source on its own and so
# finds a header that someone forgot to include.

# The standard library's headers, compiled once for all targets of the same flags.
set(airlight_standard_headers
    <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string> <string_view> <utility>
    <variant> <vector>)

# Code that takes no time at run time is compiled for short compilation: code that reads and writes text is optimised
# little, and with the sanitizers not at all; so are tests.
set(airlight_little)
set(airlight_test_options)
if(AIRLIGHT_SANITIZE)
  set(airlight_little -O0)
  set(airlight_test_options -O0)
elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(airlight_little -O1)
  set(airlight_test_options -O0)
endif()

# An object library that contains only the precompiled headers NAME, compiled with OPTIONS.
function(airlight_precompiled name options)
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE airlight_flags Threads::Threads)
  target_compile_options(${name} PRIVATE ${options})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# The methods' sources use the same names in their unnamed namespaces: one of them at most is compiled with others.
set(airlight_own_names)
foreach(source IN ITEMS analytic march nested orders sky_view path_trace/path_trace)
  list(APPEND airlight_own_names ${PROJECT_SOURCE_DIR}/core/methods/${source}.cpp)
endforeach()

# Holds the code of volk, whose header must not have been read before.
set_source_files_properties(${PROJECT_SOURCE_DIR}/core/gpu/vulkan_api.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Sources in a unit: more make less work, and fewer units than processors would make it longer.
set(airlight_batch 12)

# Orders the target's sources such that each unit has at most one of those with their own names: in its middle, since
# the sources that have options of their own do not count.
function(airlight_apart target)
  get_target_property(sources ${target} SOURCES)
  set(apart)
  foreach(source IN LISTS airlight_own_names)
    if(source IN_LIST sources)
      list(REMOVE_ITEM sources ${source})
      list(APPEND apart ${source})
    endif()
  endforeach()
  math(EXPR place "${airlight_batch} / 2")
  foreach(source IN LISTS apart)
    list(INSERT sources ${place} ${source})
    math(EXPR place "${place} + ${airlight_batch}")
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
endfunction()

# airlight_compile_together(TARGET...): compiles several sources in one go, so that their shared headers are read once.
function(airlight_compile_together)
  if(NOT AIRLIGHT_QUICK_COMPILE)
    return()
  endif()
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      airlight_apart(${target})
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${airlight_batch})
      # A class may have a member of a type from its own source's unnamed namespace: only that source knows the class.
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
  endforeach()
endfunction()

# airlight_optimise_little(TARGET...): targets that do not exist are skipped.
function(airlight_optimise_little)
  if(AIRLIGHT_QUICK_COMPILE)
    airlight_precompiled(airlight_headers_little "${airlight_little}" ${airlight_standard_headers})
  endif()
  airlight_compile_together(${ARGN})
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_compile_options(${target} PRIVATE ${airlight_little})
      get_target_property(in_library ${target} POSITION_INDEPENDENT_CODE)  # which the headers' object is not
      if(AIRLIGHT_QUICK_COMPILE AND NOT in_library)
        target_precompile_headers(${target} REUSE_FROM airlight_headers_little)
      endif()
    endif()
  endforeach()
endfunction()

# airlight_precompile(TARGET...): the same for all other targets.
function(airlight_precompile)
  airlight_compile_together(${ARGN})
  # Not used where the compiler optimises fully: GCC 12 then warns of precompiled system headers as if they were ours.
  if(NOT AIRLIGHT_QUICK_COMPILE OR CMAKE_BUILD_TYPE STREQUAL "Release")
    return()
  endif()
  airlight_precompiled(airlight_headers "" ${airlight_standard_headers})
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_precompile_headers(${target} REUSE_FROM airlight_headers)
    endif()
  endforeach()
endfunction()
