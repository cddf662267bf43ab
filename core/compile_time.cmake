# How long the compiler takes. The standard library's headers, compiled once for all targets of the same flags. Sources include what they use all the
# same: the preset `dev` builds without this.
set(airlight_standard_headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string>
    <string_view> <utility> <variant> <vector>)

# Where no time is spent at run time the compiler's counts: what reads words and writes them is optimised little, and not
# at all with the sanitizers, and so are tests.
set(airlight_little)
set(airlight_test_options)
if(AIRLIGHT_SANITIZE)
  set(airlight_little -O0)
  set(airlight_test_options -O0)
elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(airlight_little -O1)
  set(airlight_test_options -O0)
endif()

# An object library that holds nothing but the precompiled headers NAME, compiled with OPTIONS; POSITION_INDEPENDENT says
# whether with -fPIC.
function(airlight_precompiled name position_independent options)
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE airlight_flags Threads::Threads)
  target_compile_options(${name} PRIVATE ${options})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ${position_independent})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# airlight_optimise_little(TARGET...): targets that do not exist are passed over.
function(airlight_optimise_little)
  if(AIRLIGHT_PRECOMPILE)
    airlight_precompiled(airlight_headers_little OFF "${airlight_little}" ${airlight_standard_headers})
  endif()
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_compile_options(${target} PRIVATE ${airlight_little})
      if(AIRLIGHT_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM airlight_headers_little)
      endif()
    endif()
  endforeach()
endfunction()

# airlight_precompile(TARGET...): the others, alike.
function(airlight_precompile)
  # Not where the compiler optimises fully: GCC 12 forgets that precompiled headers are the system's and warns of them.
  if(NOT AIRLIGHT_PRECOMPILE OR CMAKE_BUILD_TYPE STREQUAL "Release")
    return()
  endif()
  airlight_precompiled(airlight_headers OFF "" ${airlight_standard_headers})
  airlight_precompiled(airlight_headers_pic ON "" ${airlight_standard_headers})
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      get_target_property(pic ${target} POSITION_INDEPENDENT_CODE)
      if(pic)
        target_precompile_headers(${target} REUSE_FROM airlight_headers_pic)
      else()
        target_precompile_headers(${target} REUSE_FROM airlight_headers)
      endif()
    endif()
  endforeach()
endfunction()
