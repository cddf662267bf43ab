find_package(GTest REQUIRED)
include(GoogleTest)

# Sanitized tests have their own prefix, since scripts/test runs both builds in one go.
set(test_prefix)
set(test_properties TIMEOUT 600 SKIP_RETURN_CODE 77)
if(AIRLIGHT_SANITIZE)
  set(test_prefix sanitized.)
  # GCC 12's leak checker now and then crashes on the threads that OpenImageIO leaves running at exit. Leaks are
  # therefore looked for only in rooms without OpenImageIO.
  set(test_properties_measure ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
  set(test_properties_foreign ${test_properties_measure})
  set(test_properties_cli ${test_properties_measure})
  # The plain build's tests already check the validation layer; here it would take a third of the time.
  foreach(room IN ITEMS methods cli choice stability)
    list(APPEND test_properties_${room} ENVIRONMENT_MODIFICATION "AIRLIGHT_VALIDATION=set:0")
  endforeach()
  # Left out: tests that only vary what the device computes or which numbers go through one formula. The sanitizers
  # check the host, whose branches (by gcov's count of branches taken) other tests of this room cover.
  set(left_out_methods
      # pictures and tables of the device against a closer one, a formula or path-trace
      FalseFriends.* OrdersTable.* OrdersByShells.* HalfResolution.* SunDisc.* Schlick.* *Agreement* Bloom.Is* Beam.*
      AerialVolume.LightGrows* AerialVolume.IsTheMarch* Layers.Transmittance* PhaseTables.OrdersAgrees*
      Spectral.Automatic* Spectral.GreyIsGrey Spectrum.PictureIs* Spectrum.Absolute* SpectralTruth.OrdersIsNear*
      TerrainSky.Shafts* TerrainSky.FarFrom* TerrainTruth.OrdersIsNear* Spans.Transmittance* SpectralTruth.OnePath*
      SphereSky.Shafts* TableText.Moments TableText.Factors Analytic.IsMonotone Analytic.OnTheDevice*
      Analytic.SingleScattering* Stokes.OrdersAgrees* Stokes.PathTraceMeets* Refraction.FirstOrder* Refraction.OrdersAgrees*
      Refraction.PathsTurn* CloudStack.TwoLevel* CloudStack.FieldsStand* CloudStack.ShadowsOf* CloudStack.IsPath*
      CloudPhotons.* CarvedClouds.Shaded* CarvedClouds.ShadeIn* CarvedClouds.ASheet*
      LayersOfClouds.SumUp* LayersOfClouds.ABlack* LayersOfClouds.QAndU* LayersOfClouds.AFilter* CloudSpans.UpTo*
      CloudWind.Moves* CloudWind.APeriod* Spectral.AField* CloudLattice.GoesEvenly* CloudLattice.IsThe* CloudLattice.Leaves*
      # scenes that differ in numbers and in the device's pipelines
      CloudStack.Refuses*
      Stability.Air* Stability.CameraAndSun* Stability.OneMedium* Stability.Rays* Stability.Sharpest*
      Stability.WhatWasRendered*
      # means of many paths: a few paths take the same ways
      PathTrace.WhatEntersLeaves PathTrace.ChannelsDoNotDisturb* PathTraceRun.StandardErrorIsHonest
      PathTraceRun.ReportsRising* Published/PathTraceSlab.*/2 Published/PathTraceSlab.*/3 Published/PathTraceSlab.*/5
      Published/PathTraceSlab.*/6
      # columns by quadrature: a tent and height fog, with tests of whole paths, take the ways of all profiles
      Profiles/PathTraceOpticalDepth.*/0 Profiles/PathTraceOpticalDepth.*/2 Profiles/PathTraceOpticalDepth.*/3
      Profiles/PathTraceOpticalDepth.*/4)
  list(JOIN left_out_methods ":" left_out_methods)
  set(test_filter_methods "-${left_out_methods}")
  # The device's numbers against those of physics, and the optimiser on every shader, ours and the tests' own; other
  # tests freeze shaders too.
  set(test_filter_gpu "-Parity.*:MarchParity.*:Specialize.LeavesNothingOpen*")
  # Other tests' formulas at thousands of steps.
  set(test_filter_physics "-March.AgreesWithBruteForce*:March.MoreSteps*:Distributions.ComeToTheSameLight*")
  # LeftBehind.EveryCommandSays* ends programs at a certain moment and starts them again where the signal came late.
  # Examples, pages, packages and keys run what other tests run.
  set(left_out_cli
      Examples.* Install.* Package.* Page.* *Keys.* LeftBehind.NothingPrepared* SpectralExr.IsRead*
      LeftBehind.EveryCommandSays* StabilityCommand.Leaves* Tolerance.ThatNothing*
      # The sanitizers themselves take terabytes of addresses.
      SmallSky.ALimitOnMemory*
      # The other tests of this room take 98 % of the branches that all of them take, by gcov's count.
      Chart.Gnuplot* Cli.AnExrRenders* Cli.BuiltIn* Cli.Default* Cli.EveryBuilt* Cli.FloatExr* Cli.JsonTells*
      Cli.NoVulkan* Cli.OnlyThe* Cli.ProbeBy* Cli.Thirty* Cli.Timings* Completion.BashOffers*
      CompositeTool.APictureOfAir* CompositeTool.Before* CompositeTool.FarThings* CompositeTool.Planar*
      CompositeTool.TheAerial* CompositeTool.WhereNothing* Diff.AllNan* Diff.Camera* Diff.DifferentPictures*
      Diff.EqualPictures* Diff.JunitTells* Diff.Limits* Diff.ToolItself* DiffExample.FailsWhere* DiffExample.Passes*
      DiffUpdate.TakesWhat* Exposed.ADayIs* Exposed.AFrame* Exposed.AShard* Exposed.LockHolds* Exposed.OfItself*
      Exposed.StopsAnd* Ffmpeg.* GroundTool.AMapOfOne* GroundTool.Nonsense* GroundTool.TheCamera*
      LeftBehind.NoTemporary* LeftBehind.Prepared* LeftBehind.Tables* Manual.* Maps.AColour* Maps.Layouts*
      Maps.ProbePrints* Maps.TheExr* Sampling.NeedsNo* Sampling.ThatIs* Sequence.AFrameIs* Sequence.Frames*
      Sequence.Preview* Sequence.QuietIs* Sequence.WhatBounds* SequenceWind.AFrame* SequenceResume.ASecond*
      SequenceResume.Killed* SequenceResume.Shards* SequenceResume.Stopped* SequenceResume.TwoRuns* SpectralExr.Carries*
      SphereTool.TilesAre* TerrainTool.Nonsense* TerrainTool.ThingsOf* TerrainTool.TilesAre* Tiles.APngIn*
      Tiles.ASequence* Tiles.AnEndIn* Tiles.EveryOutput* Tiles.LayersAre* Tiles.TheFile* Tolerance.IsMetAnd*
      Usage.Colour* Usage.EveryCommand* Usage.HelpIsAs* Usage.HelpLists* Usage.Negative* Words.ADashIs*
      Words.Limits* Words.Presets* Words.TheCamera*)
  list(JOIN left_out_cli ":" left_out_cli)
  set(test_filter_cli "-${left_out_cli}")
  set(test_filter_stability "-Method/Holds.*")
  # AddressSanitizer has a heap of its own.
  set(test_filter_plan "-HugePages.*")
endif()

# One process for each of these rooms: their tests take milliseconds, less than a program's start, which with
# OpenImageIO's libraries is a fifth of a second. Other rooms have a process for each suite, cli for each test.
set(rooms_together spectra plan scene composite output chart measure foreign sequence app)
if(AIRLIGHT_SANITIZE)
  # In this build a start takes up to half of a test that opens the device. Only the commands' tests, which start
  # programs of their own, run one by one. An error ends a part, and its output names the test.
  list(APPEND rooms_together physics gpu choice stability methods)
  set(shards_methods 3)
endif()

if(AIRLIGHT_QUICK_COMPILE)
  airlight_precompiled(airlight_test_headers "${airlight_test_options}" ${airlight_standard_headers} <gtest/gtest.h>)
  target_link_libraries(airlight_test_headers PRIVATE GTest::gtest)
  if(AIRLIGHT_SANITIZE AND NOT AIRLIGHT_SHADERS_FROM)
    airlight_precompiled(airlight_driver_headers "${airlight_test_options};-fno-sanitize=all" ${airlight_standard_headers}
                         <gtest/gtest.h>)
    target_link_libraries(airlight_driver_headers PRIVATE GTest::gtest)
  endif()
endif()

# `scripts/test --quick` runs the plain build's tests with the label `quick`: all but those that scripts/update-long
# measured as long.
set(quick)
if(NOT AIRLIGHT_SANITIZE)
  set(quick LABELS quick)
endif()
set(long_list ${PROJECT_SOURCE_DIR}/tests/long.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${long_list})
file(STRINGS ${long_list} long_lines REGEX "^[^#]" ENCODING UTF-8)
foreach(line IN LISTS long_lines)
  if(line MATCHES "^([^ ]+) ([^ ]+)")
    string(APPEND long_${CMAKE_MATCH_1} ":${CMAKE_MATCH_2}")  # as a filter
  endif()
endforeach()

# Uses the frozen modules of the build that the shaders come from. Sanitized, SPIRV-Tools' optimiser, which allocates by
# the million and is none of our code, took three quarters of the methods' tests. The tests of test_gpu and of
# LeftBehind freeze anew.
set(test_cache ${PROJECT_BINARY_DIR})
if(AIRLIGHT_SHADERS_FROM)
  set(test_cache ${AIRLIGHT_SHADERS_FROM})
endif()
# Part of every test program, and compiled once a build.
add_library(airlight_this_build OBJECT ${PROJECT_SOURCE_DIR}/tests/this_build.cpp)
target_link_libraries(airlight_this_build PRIVATE airlight_flags GTest::gtest)
target_compile_definitions(airlight_this_build PRIVATE AIRLIGHT_CACHE_FOLDER="${test_cache}/cache")

# Long tests start first, so that no core waits for them in the end. The plain build's start before the sanitized one's,
# which then finds the software device's pipelines in Mesa's cache: test_cost(VARIABLE ROOM).
function(test_cost result room)
  set(cost 1000)
  if(AIRLIGHT_SANITIZE)
    set(cost 0)
  endif()
  set(from_cheap_to_dear cli methods choice stability fuzz)
  list(FIND from_cheap_to_dear ${room} place)  # -1: cheaper than all of them
  math(EXPR cost "${cost} + 100 * ${place}")
  set(${result} COST ${cost} PARENT_SCOPE)
endfunction()

# The static libraries of ours that the targets link, directly or not: airlight_archives(VARIABLE TARGET...).
function(airlight_archives result)
  set(found)
  set(open ${ARGN})
  while(open)
    list(POP_FRONT open target)
    if(NOT TARGET "${target}" OR NOT target MATCHES "^airlight_" OR target IN_LIST found)
      continue()
    endif()
    get_target_property(imported ${target} IMPORTED)
    if(imported)
      continue()
    endif()
    list(APPEND found ${target})
    foreach(property IN ITEMS LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
      get_target_property(linked ${target} ${property})
      if(linked)
        list(APPEND open ${linked})
      endif()
    endforeach()
  endwhile()
  set(archives)
  foreach(target IN LISTS found)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
      list(APPEND archives ${target})
    endif()
  endforeach()
  set(${result} ${archives} PARENT_SCOPE)
endfunction()

# Every tests/ROOM/*_test.cpp of the rooms listed; one executable a room, so that a change rebuilds little. A sanitized
# build takes the objects of the tests from the other build, AIRLIGHT_SHADERS_FROM, as that build lists them: what the
# sanitizers check is the program's code. Its own copies of inline functions come first at the link. The physics stands
# in headers, so its tests are compiled anew.
function(airlight_test_program room)
  set(list_file test_${room}.objects)
  set(taken)
  if(AIRLIGHT_SANITIZE AND EXISTS "${AIRLIGHT_SHADERS_FROM}/${list_file}" AND NOT room STREQUAL "physics")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${AIRLIGHT_SHADERS_FROM}/${list_file})
    airlight_objects(taken ${AIRLIGHT_SHADERS_FROM}/${list_file})
  endif()
  if(taken)
    add_executable(test_${room} $<TARGET_OBJECTS:airlight_this_build> ${AIRLIGHT_PROGRAM_SOURCES} ${taken})
    add_dependencies(test_${room} taken_shaders)
    airlight_archives(archives ${ARGN})
    list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_FILE:\\1>")
    target_link_options(test_${room} PRIVATE -Wl,--whole-archive ${archives} -Wl,--no-whole-archive)
    target_link_libraries(test_${room} PRIVATE airlight_flags GTest::gtest GTest::gtest_main ${ARGN})
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${room}/*.cpp)
  if(room STREQUAL "app")
    list(APPEND sources ${PROJECT_SOURCE_DIR}/tests/cli/process.cpp)
  endif()
  add_executable(test_${room} ${sources} $<TARGET_OBJECTS:airlight_this_build> ${AIRLIGHT_PROGRAM_SOURCES})
  set_property(TARGET test_${room} APPEND PROPERTY LINK_DEPENDS ${long_list})  # tells which tests are long, once linked
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${list_file} CONTENT "$<JOIN:$<TARGET_OBJECTS:test_${room}>,\n>\n")
  target_link_libraries(test_${room} PRIVATE airlight_flags GTest::gtest GTest::gtest_main ${ARGN})
  set(options ${airlight_test_options})
  set(headers airlight_test_headers)
  if(room STREQUAL "physics" AND options)
    # The physics is code of the tests themselves: optimised it takes a quarter of the time to run.
    set(options -O1)
    set(headers)
  endif()
  target_compile_options(test_${room} PRIVATE ${options})
  if(AIRLIGHT_SANITIZE AND room STREQUAL "cli")
    # The program that these tests start is sanitized; the tests only start it and look at its output.
    target_compile_options(test_cli PRIVATE -fno-sanitize=all)
    set(headers airlight_driver_headers)
  endif()
  if(AIRLIGHT_QUICK_COMPILE AND headers)
    target_precompile_headers(test_${room} REUSE_FROM ${headers})
  endif()
  airlight_compile_together(test_${room})
  target_compile_definitions(test_${room} PRIVATE AIRLIGHT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()

# Adds test_ROOM and its tests for CTest.
function(airlight_test_room room)
  if(room STREQUAL "cli" AND AIRLIGHT_SHADERS_FROM)
    # These tests start the tool and look at its output: the other build's test_cli does this with this build's tool.
    add_executable(test_cli ${PROJECT_SOURCE_DIR}/tests/cli_of_another_build.cpp)
    target_compile_definitions(test_cli PRIVATE AIRLIGHT_DRIVER="${AIRLIGHT_SHADERS_FROM}/test_cli")
    add_dependencies(test_cli taken_shaders)
  else()
    airlight_test_program(${room} ${ARGN})
  endif()
  test_cost(cost ${room})
  if(room IN_LIST rooms_together)
    set(filter)
    if(test_filter_${room})
      set(filter "--gtest_filter=${test_filter_${room}}")
    endif()
    set(shards 1)
    if(shards_${room})
      set(shards ${shards_${room}})
    endif()
    foreach(shard RANGE 1 ${shards})
      set(name ${test_prefix}${room})
      if(shards GREATER 1)
        string(APPEND name .${shard}-of-${shards})
      endif()
      add_test(NAME ${name} COMMAND test_${room} ${filter})
      set_tests_properties(${name} PROPERTIES ${test_properties} ${test_properties_${room}} ${cost} ${quick})
      if(shards GREATER 1)
        math(EXPR index "${shard} - 1")
        set_property(TEST ${name} PROPERTY ENVIRONMENT GTEST_TOTAL_SHARDS=${shards} GTEST_SHARD_INDEX=${index})
      endif()
    endforeach()
    return()
  endif()
  if(room STREQUAL "cli")
    set(options TEST_PREFIX ${test_prefix}cli. DISCOVERY_TIMEOUT 60 PROPERTIES ${test_properties} ${test_properties_cli}
                ${cost})
    if(AIRLIGHT_SANITIZE)
      gtest_discover_tests(test_cli TEST_FILTER ${test_filter_cli} ${options})
    else()
      gtest_discover_tests(test_cli TEST_FILTER "-${long_cli}" ${options} ${quick})
      gtest_discover_tests(test_cli TEST_FILTER ":${long_cli}" ${options})
    endif()
    return()
  endif()
  # One process a suite: its tests share the device and its pipelines.
  set(suites ${PROJECT_BINARY_DIR}/test_${room}_suites.cmake)
  string(REPLACE ";" " " properties "${test_properties};${test_properties_${room}};${cost}")
  add_custom_command(TARGET test_${room} POST_BUILD
                     COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:test_${room}> -DPREFIX=${room}.
                             "-DPROPERTIES=${properties}" "-DLONG=${long_${room}}" -DOUT=${suites}
                             -P ${PROJECT_SOURCE_DIR}/tests/discover_suites.cmake
                     BYPRODUCTS ${suites} VERBATIM)
  file(WRITE ${suites}.all "include(\"${suites}\" OPTIONAL RESULT_VARIABLE found)
if(NOT found)
  add_test(${room}.was-not-built test_${room})
endif()
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${suites}.all)
endfunction()

airlight_test_room(spectra airlight_spectra)
airlight_test_room(physics airlight_gpu)
airlight_test_room(plan airlight_gpu)
file(GLOB test_shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/gpu/shaders/*.comp)
airlight_embed_shaders(airlight_test_shaders test_shaders ${test_shaders})
airlight_test_room(gpu airlight_gpu airlight_test_shaders Vulkan::Headers)
if(SPIRV-Tools-opt_FOUND)
  target_link_libraries(test_gpu PRIVATE SPIRV-Tools-opt)
  target_compile_definitions(test_gpu PRIVATE AIRLIGHT_SPIRV_TOOLS)
endif()
airlight_test_room(scene airlight_scene airlight_gpu nlohmann_json::nlohmann_json)
airlight_test_room(methods airlight_gpu airlight_scene airlight_output airlight_measure OpenEXR::OpenEXR Eigen3::Eigen)
# Without optimisation Eigen's loops take twenty times as long.
set_source_files_properties(tests/methods/slab.cpp PROPERTIES COMPILE_OPTIONS -O1 SKIP_PRECOMPILE_HEADERS ON
                                                              SKIP_UNITY_BUILD_INCLUSION ON)
airlight_test_room(composite airlight_composite)
airlight_test_room(output airlight_output OpenEXR::OpenEXR OpenColorIO::OpenColorIO PNG::PNG)
if(AIRLIGHT_TOOL)
  airlight_test_room(choice airlight_choice airlight_chart airlight_scene)
  airlight_test_room(chart airlight_chart)
  airlight_test_room(measure airlight_measure airlight_output OpenEXR::OpenEXR OpenImageIO::OpenImageIO)
  airlight_test_room(foreign airlight_foreign OpenEXR::OpenEXR)
  airlight_test_room(sequence airlight_sequence airlight_gpu ${ERFA_STATIC_LIBRARY})
  target_include_directories(test_sequence SYSTEM PRIVATE ${ERFA_INCLUDE_DIR})
  airlight_test_room(stability airlight_stability)
  airlight_test_room(app airlight_app)
  target_compile_definitions(test_app PRIVATE AIRLIGHT_BINARY="")  # starts none
  airlight_test_room(cli airlight_app nlohmann_json::nlohmann_json OpenEXR::OpenEXR)
endif()
if(TARGET airlight_library)
  airlight_test_room(library airlight_library)
endif()
# The Python package as Python sees it.
if(TARGET airlight_python AND TARGET airlight)
  add_test(NAME python COMMAND ${Python_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tests/python/airlight_test.py
                               $<TARGET_FILE:airlight>)
  set_tests_properties(python PROPERTIES TIMEOUT 300 LABELS quick ENVIRONMENT PYTHONPATH=${PROJECT_BINARY_DIR}/python)
endif()
if(TARGET test_foreign)
  add_dependencies(test_foreign airlight_foreign_module)
endif()
if(TARGET test_cli)
  add_dependencies(test_cli airlight)
  target_compile_definitions(test_cli PRIVATE AIRLIGHT_BINARY="$<TARGET_FILE:airlight>"
                                              AIRLIGHT_BUILD_DIR="${PROJECT_BINARY_DIR}")
endif()

# What scripts/cloud-truth runs; it opens no device.
if(AIRLIGHT_TOOL)
  add_executable(airlight_cloud_truth ${PROJECT_SOURCE_DIR}/tests/clouds/cloud_truth.cpp
                                      ${PROJECT_SOURCE_DIR}/tests/methods/column_light.cpp
                                      ${PROJECT_SOURCE_DIR}/core/render/ready/none.cpp ${AIRLIGHT_PROGRAM_SOURCES})
  target_link_libraries(airlight_cloud_truth PRIVATE airlight_gpu_core airlight_scene)
endif()

# Random input by number: presets by the token, EXRs by the byte, valid presets anywhere in their ranges. The counts are
# those that CI has time for; scripts/fuzz runs as long as one likes.
if(AIRLIGHT_TOOL)
  file(GLOB fuzz_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/fuzz/*.cpp)
  add_executable(airlight_fuzz ${fuzz_sources} ${AIRLIGHT_PROGRAM_SOURCES})
  target_link_libraries(airlight_fuzz PRIVATE airlight_flags airlight_app OpenEXR::OpenEXR)
  add_dependencies(airlight_fuzz airlight_foreign_module)
  target_compile_options(airlight_fuzz PRIVATE ${airlight_test_options})
  # Texts and EXRs begin only sanitized, which also finds what the plain build would. Scenes run plain first, so that
  # the software device's pipelines are in Mesa's cache.
  set(fuzz_cases texts:1000:3000 exrs:1000:4000 scenes:0:14 files:0:300 plates:0:300 methods:0:2)
  if(AIRLIGHT_SANITIZE)
    set(fuzz_cases texts:0:1000 exrs:0:1000 scenes:0:6 files:300:100 plates:300:100 methods:0:1)
  endif()
  test_cost(fuzz_cost fuzz)
  foreach(case IN LISTS fuzz_cases)
    string(REPLACE ":" ";" case ${case})
    list(GET case 0 kind)
    list(GET case 1 first)
    list(GET case 2 count)
    add_test(NAME ${test_prefix}fuzz.${kind} COMMAND airlight_fuzz ${kind} --first ${first} --count ${count})
    set(label)
    if(NOT "${long_fuzz}:" MATCHES ":${kind}:")
      set(label ${quick})
    endif()
    set_tests_properties(${test_prefix}fuzz.${kind} PROPERTIES ${test_properties} ${fuzz_cost} ${label}
                         ENVIRONMENT "AIRLIGHT_VALIDATION=0;ASAN_OPTIONS=detect_leaks=0")
  endforeach()
endif()

# Only where Slurm is installed: a cluster of one node for a quarter of a minute, most of it waiting.
find_program(SBATCH sbatch)
if(SBATCH AND AIRLIGHT_TOOL AND NOT AIRLIGHT_SANITIZE)
  add_test(NAME slurm COMMAND ${PROJECT_SOURCE_DIR}/scripts/test-slurm $<TARGET_FILE:airlight>)
  set_tests_properties(slurm PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()

# Only where Blender is installed: three pictures of a sphere, 10 seconds.
find_program(BLENDER blender)
if(BLENDER AND AIRLIGHT_TOOL AND NOT AIRLIGHT_SANITIZE)
  add_test(NAME blender COMMAND ${PROJECT_SOURCE_DIR}/scripts/test-blender $<TARGET_FILE:airlight>)
  set_tests_properties(blender PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()

find_program(CLANG_FORMAT clang-format)
if(CLANG_FORMAT AND NOT AIRLIGHT_SANITIZE)
  file(GLOB_RECURSE formatted CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/app/*.h ${PROJECT_SOURCE_DIR}/app/*.cpp
       ${PROJECT_SOURCE_DIR}/core/*.h ${PROJECT_SOURCE_DIR}/core/*.cpp ${PROJECT_SOURCE_DIR}/tests/*.h
       ${PROJECT_SOURCE_DIR}/tests/*.cpp)
  execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE clang_format_version)
  if(clang_format_version MATCHES "version 14[.]")
    add_test(NAME format COMMAND ${CLANG_FORMAT} --dry-run -Werror ${formatted})
  else()  # others break some lines elsewhere
    add_test(NAME format COMMAND sh -c "echo 'needs clang-format 14'; exit 77")
  endif()
  set_tests_properties(format PROPERTIES LABELS quick SKIP_RETURN_CODE 77)
endif()
