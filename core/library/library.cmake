# libairlight: a scene in memory rendered in memory. The tool and the tests link its static parts; installed are one
# archive and one shared library, with only the header's names in sight.
set(embedded_presets ${PROJECT_BINARY_DIR}/embedded_presets.cpp)
set(chart_list ${PROJECT_SOURCE_DIR}/presets/chart.json)
add_custom_command(
  OUTPUT ${embedded_presets}
  COMMAND ${CMAKE_COMMAND} -DOUT=${embedded_presets} "-DPRESETS=${airlight_preset_files}"
          -DCHART=${chart_list} -P ${CMAKE_CURRENT_LIST_DIR}/embed_presets.cmake
  DEPENDS ${airlight_preset_files} ${chart_list} ${CMAKE_CURRENT_LIST_DIR}/embed_presets.cmake
  VERBATIM)

file(GLOB library_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
add_library(airlight_library STATIC ${library_sources} ${embedded_presets})
target_link_libraries(airlight_library PRIVATE airlight_flags airlight_clock airlight_scene airlight_gpu)
target_include_directories(airlight_library PUBLIC ${CMAKE_CURRENT_LIST_DIR}/include)
target_compile_features(airlight_library PUBLIC cxx_std_20)
set_property(SOURCE ${CMAKE_CURRENT_LIST_DIR}/scene.cpp APPEND PROPERTY COMPILE_DEFINITIONS
             AIRLIGHT_MAJOR=${PROJECT_VERSION_MAJOR} AIRLIGHT_MINOR=${PROJECT_VERSION_MINOR}
             AIRLIGHT_PATCH=${PROJECT_VERSION_PATCH})

# Sanitized, or without its own shaders, the library is for this build's tests alone.
if(NOT AIRLIGHT_LIBRARY OR AIRLIGHT_SANITIZE OR AIRLIGHT_SHADERS_FROM)
  return()
endif()

set(library_parts airlight_library airlight_clock airlight_scene airlight_gpu_core airlight_ready airlight_shaders airlight_spectra)
foreach(part IN LISTS library_parts)
  set_target_properties(${part} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                           VISIBILITY_INLINES_HIDDEN ON)
  # Functions that nobody can replace are inlined as in a program.
  target_compile_options(${part} PRIVATE -fno-semantic-interposition)
endforeach()

add_library(airlight_shared SHARED $<TARGET_OBJECTS:airlight_library>)
target_link_libraries(airlight_shared PRIVATE airlight_flags airlight_clock airlight_scene airlight_gpu)
airlight_harden(airlight_shared)
target_link_options(airlight_shared PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed LINKER:-z,defs)
set_target_properties(airlight_shared PROPERTIES OUTPUT_NAME airlight VERSION ${PROJECT_VERSION}
                                                 SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_include_directories(airlight_shared PUBLIC ${CMAKE_CURRENT_LIST_DIR}/include)
target_compile_features(airlight_shared PUBLIC cxx_std_20)

# One archive of all parts. The archiver's script takes no path with a space, so it names files of its own folder.
set(archive ${PROJECT_BINARY_DIR}/libairlight.a)
set(script ${PROJECT_BINARY_DIR}/libairlight.mri)
set(archives)
foreach(part IN LISTS library_parts)
  list(APPEND archives "addlib $<TARGET_FILE_NAME:${part}>")
endforeach()
file(GENERATE OUTPUT ${script} CONTENT "create libairlight.a\n$<JOIN:${archives},\n>\nsave\nend\n")
add_custom_command(
  OUTPUT ${archive}
  COMMAND ${CMAKE_COMMAND} -E rm -f ${archive}
  COMMAND ${CMAKE_AR} -M <libairlight.mri
  COMMAND ${CMAKE_RANLIB} ${archive}
  DEPENDS ${library_parts} ${script}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
add_custom_target(airlight_archive DEPENDS ${archive})

# What add_subdirectory() gives; find_package() gives the same names (airlightConfig.cmake.in).
if(BUILD_SHARED_LIBS)
  add_library(airlight::airlight ALIAS airlight_shared)
else()
  add_library(airlight::airlight ALIAS airlight_library)
endif()
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(airlight_libraries ALL DEPENDS airlight_shared airlight_archive)
  include(${CMAKE_CURRENT_LIST_DIR}/python.cmake)
else()
  set_target_properties(airlight_shared PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
