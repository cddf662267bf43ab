# What the software device's driver compiles for the presets, made by rendering each of them once (driver_code.h). Where
# the build runs on a machine without that device there is none, and a first start compiles. The presets' tables lie
# beside it: another program has others, so each link is followed by these renders.
option(AIRLIGHT_DRIVER_CODE "Build what the software device compiles at its first starts" ON)
if(NOT AIRLIGHT_DRIVER_CODE OR NOT TARGET freeze_presets)
  return()
endif()
set(driver_code_made)
foreach(part 0 1)  # at once: a driver compiles on one processor
  set(made ${PROJECT_BINARY_DIR}/driver_code_${part}.made)
  add_custom_command(
    OUTPUT ${made}
    COMMAND ${CMAKE_COMMAND} -DAIRLIGHT=$<TARGET_FILE:airlight> -DPART=${part} -DMADE=${made} -DSHADERS=${ready_source}
            -DOUT=${PROJECT_BINARY_DIR}/driver_code "-DPRESETS=${airlight_preset_files}"
            -P ${CMAKE_CURRENT_LIST_DIR}/render_presets.cmake
    DEPENDS airlight ${ready_source} ${CMAKE_CURRENT_LIST_DIR}/render_presets.cmake
    COMMENT "Compiling the presets' shaders for the software device, part ${part}"
    VERBATIM)
  list(APPEND driver_code_made ${made})
endforeach()
add_custom_target(airlight_driver_code ALL DEPENDS ${driver_code_made})
add_dependencies(airlight_driver_code airlight)
