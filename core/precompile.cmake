# The standard library's headers, compiled once for all targets of the same flags. Sources include what they use all the
# same: the preset `dev` builds without this.
set(airlight_standard_headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string>
    <string_view> <utility> <variant> <vector>)

# An object library that holds nothing but the precompiled headers NAME, for targets with or without -fPIC.
function(airlight_precompiled name position_independent)
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE airlight_flags Threads::Threads)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ${position_independent})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# airlight_precompile(TARGET...): targets that do not exist are passed over.
function(airlight_precompile)
  if(NOT AIRLIGHT_PRECOMPILE)
    return()
  endif()
  airlight_precompiled(airlight_headers OFF ${airlight_standard_headers})
  airlight_precompiled(airlight_headers_pic ON ${airlight_standard_headers})
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
