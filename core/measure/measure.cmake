# Metrics, comparison, reports and pictures of errors.
file(GLOB measure_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)

embed_text(embedded_page ${CMAKE_CURRENT_LIST_DIR}/page.html core/measure/page.h airlight::measure page_template)

add_library(airlight_measure STATIC ${measure_sources} ${embedded_page})
target_link_libraries(airlight_measure PUBLIC airlight_gpu PRIVATE airlight_output OpenEXR::OpenEXR
                                                                  nlohmann_json::nlohmann_json)
