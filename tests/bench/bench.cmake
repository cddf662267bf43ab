# airlight_bench: times every pass on a device and checks its pictures. It links only airlight_gpu and Google Benchmark,
# so the folder that it is built into runs on any x86-64 Linux with a Vulkan loader and driver.
find_package(benchmark CONFIG REQUIRED)

set(bench_folder ${PROJECT_BINARY_DIR}/airlight_bench)
file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/bench/*.cpp)
add_executable(airlight_bench ${bench_sources})
target_link_libraries(airlight_bench PRIVATE airlight_gpu benchmark::benchmark)
set_target_properties(airlight_bench PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${bench_folder})
add_custom_command(TARGET airlight_bench POST_BUILD
                   COMMAND ${CMAKE_COMMAND} -E copy_if_different ${PROJECT_SOURCE_DIR}/tests/bench/checksums.txt
                           ${bench_folder})
set_property(TARGET airlight_bench APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/tests/bench/checksums.txt)

# Debian 12's libbenchmark-dev has no static library (its only archive holds main() alone): the shared one travels
# beside the program. A static one, found through benchmark_DIR, is linked in. libstdc++ stays shared: Debian's
# libbenchmark asks for GCC 12's or later in any case, and the static one raises the glibc asked for from 2.35 to 2.36
# (_dl_find_object, arc4random), which shuts out machines that have the shared one.
get_target_property(benchmark_type benchmark::benchmark TYPE)
if(benchmark_type STREQUAL "SHARED_LIBRARY")
  set_target_properties(airlight_bench PROPERTIES BUILD_RPATH "\$ORIGIN")
  add_custom_command(TARGET airlight_bench POST_BUILD
                     COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:benchmark::benchmark>
                             ${bench_folder}/$<TARGET_SONAME_FILE_NAME:benchmark::benchmark>)
endif()
