file(GLOB app_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/app/*.cpp ${PROJECT_SOURCE_DIR}/app/*/*.cpp)

# Everything but main, so that tests can call it.
list(REMOVE_ITEM app_sources ${PROJECT_SOURCE_DIR}/app/main.cpp)
add_library(airlight_app STATIC ${app_sources})
target_link_libraries(airlight_app PUBLIC airlight_library airlight_gpu airlight_composite airlight_scene airlight_output airlight_measure airlight_foreign airlight_sequence
                                   airlight_chart airlight_stability
                                   PRIVATE CLI11::CLI11)
target_compile_definitions(airlight_app PUBLIC AIRLIGHT_VERSION="${PROJECT_VERSION}")
add_executable(airlight ${PROJECT_SOURCE_DIR}/app/main.cpp ${AIRLIGHT_PROGRAM_SOURCES})
target_link_libraries(airlight PRIVATE airlight_app)
airlight_harden(airlight)

set(libraries)
foreach(library IN ITEMS OpenEXR OpenColorIO OpenImageIO nlohmann_json CLI11 PNG Vulkan)
  set(version ${${library}_VERSION})
  if(library STREQUAL OpenColorIO AND NOT version)
    set(version ${OCIO_VERSION})  # by pkg-config
  elseif(library STREQUAL PNG)
    set(version ${PNG_VERSION_STRING})
  endif()
  string(APPEND libraries "  ${library} ${version}\\n")
endforeach()
set_source_files_properties(${PROJECT_SOURCE_DIR}/app/commands/version.cpp PROPERTIES
                            COMPILE_DEFINITIONS "AIRLIGHT_LIBRARIES=\"${libraries}\"")
