# ready_modules(): frozen modules of the shipped presets, made by a program of this build. There are none where
# presets or SPIRV-Tools are left out.
if(AIRLIGHT_SHADERS_FROM)
  airlight_take_shaders(airlight_ready)
  return()
endif()
add_library(airlight_ready STATIC)
target_link_libraries(airlight_ready PUBLIC airlight_flags)
if(NOT (AIRLIGHT_TOOL OR AIRLIGHT_LIBRARY) OR NOT SPIRV-Tools-opt_FOUND)
  target_sources(airlight_ready PRIVATE ${PROJECT_SOURCE_DIR}/core/render/ready/none.cpp)
  return()
endif()

add_executable(freeze_presets ${PROJECT_SOURCE_DIR}/core/render/ready/freeze_presets.cpp
               ${PROJECT_SOURCE_DIR}/core/render/ready/none.cpp ${AIRLIGHT_PROGRAM_SOURCES})
target_link_libraries(freeze_presets PRIVATE airlight_gpu_core airlight_scene)
set(ready_source ${PROJECT_BINARY_DIR}/ready_modules.cpp)
add_custom_command(
  OUTPUT ${ready_source}
  COMMAND freeze_presets ${ready_source} ${airlight_preset_files}
  DEPENDS freeze_presets ${airlight_preset_files}
  COMMENT "Freezing the presets' shaders"
  VERBATIM)
target_sources(airlight_ready PRIVATE ${ready_source})
