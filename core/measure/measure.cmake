# Metrics, reports and pictures of errors, without OpenImageIO; and the module that reads two EXRs through it. Only
# `airlight diff` loads the module: linking OpenImageIO would cost every start of the tool 0.2 CPU-s and 130 MB.
file(GLOB measure_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
set(compare_sources ${measure_sources})
list(FILTER compare_sources INCLUDE REGEX "/module_[^/]*\\.cpp$")
list(FILTER measure_sources EXCLUDE REGEX "/module_[^/]*\\.cpp$")

# The same module reads other programs' pictures.
list(APPEND compare_sources ${PROJECT_SOURCE_DIR}/core/foreign/module_foreign.cpp
                            ${PROJECT_SOURCE_DIR}/core/output/exr_header.cpp
                            ${PROJECT_SOURCE_DIR}/core/scene/printable.cpp)  # of messages
list(APPEND measure_sources ${PROJECT_SOURCE_DIR}/core/foreign/foreign_picture.cpp)

set(page ${CMAKE_CURRENT_LIST_DIR}/page.html)
set(embedded_page ${PROJECT_BINARY_DIR}/embedded_page.cpp)
add_custom_command(
  OUTPUT ${embedded_page}
  COMMAND ${CMAKE_COMMAND} -DOUT=${embedded_page} -DPAGE=${page} -P ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  DEPENDS ${page} ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  VERBATIM)

add_library(airlight_measure STATIC ${measure_sources} ${embedded_page})
target_link_libraries(airlight_measure PUBLIC airlight_gpu ${CMAKE_DL_LIBS} PRIVATE nlohmann_json::nlohmann_json)
# These libraries become part of the module.
set_target_properties(airlight_measure airlight_gpu_core airlight_spectra airlight_ready airlight_shaders
                      PROPERTIES POSITION_INDEPENDENT_CODE ON)

add_library(airlight_compare MODULE ${compare_sources})
set_target_properties(airlight_compare PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
                                                  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_link_libraries(airlight_compare PRIVATE airlight_measure OpenImageIO::OpenImageIO)
# The module takes only the view rays from airlight_gpu; without this option it would load Vulkan too.
target_link_options(airlight_compare PRIVATE LINKER:--as-needed LINKER:--exclude-libs,ALL)

# Building the tool also builds the module beside it.
cmake_language(DEFER CALL add_dependencies airlight airlight_compare)
# Where the module lies once it is installed, and the way there from the program, which finds it wherever both are moved.
include(GNUInstallDirs)
set(AIRLIGHT_MODULE_FOLDER lib/airlight/modules)  # deeper than the folders for which CPack's package calls ldconfig
file(RELATIVE_PATH module_from_program /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${AIRLIGHT_MODULE_FOLDER})
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/compare_module.cpp PROPERTIES
                            COMPILE_DEFINITIONS "AIRLIGHT_MODULE_FROM_PROGRAM=\"${module_from_program}\"")
