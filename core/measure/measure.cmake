# Metrics, comparison, reports and pictures of errors.
file(GLOB measure_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)

set(page ${CMAKE_CURRENT_LIST_DIR}/page.html)
set(embedded_page ${PROJECT_BINARY_DIR}/embedded_page.cpp)
add_custom_command(
  OUTPUT ${embedded_page}
  COMMAND ${CMAKE_COMMAND} -DOUT=${embedded_page} -DPAGE=${page} -P ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  DEPENDS ${page} ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  VERBATIM)

add_library(airlight_measure STATIC ${measure_sources} ${embedded_page})
target_link_libraries(airlight_measure PUBLIC airlight_gpu PRIVATE airlight_output OpenEXR::OpenEXR
                                                                  nlohmann_json::nlohmann_json)
