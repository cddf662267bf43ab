# core/choice: which method and quality a scene needs. core/chart: methods timed and measured against the truth.
file(GLOB choice_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/choice/*.cpp)
add_library(airlight_choice STATIC ${choice_sources})
target_link_libraries(airlight_choice PUBLIC airlight_measure airlight_gpu)

file(GLOB chart_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
add_library(airlight_chart STATIC ${chart_sources})
target_link_libraries(airlight_chart PUBLIC airlight_choice airlight_scene airlight_output)
