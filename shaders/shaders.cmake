# GLSL -> SPIR-V, loops rotated -> validated -> optimised -> validated -> embedded as C++ arrays.
set(AIRLIGHT_SHADERS_FROM "" CACHE PATH
    "Another build of this tree, whose shaders, frozen modules and objects of tests are taken as they are")
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)
# Bindings keep their names, so that those of a plan match the GLSL as written, not what the optimiser finds in use.
# Functions inlined, variables in registers. Loops are unrolled once the constants are known (core/gpu/specialize.cpp):
# unrolled here, modules would be three times as large, and most of it for constants that a pipeline does not have.
set(AIRLIGHT_SPIRV_OPT_FLAGS
    --wrap-opkill --eliminate-dead-branches --merge-return --inline-entry-points-exhaustive --eliminate-dead-functions
    --eliminate-dead-code-aggressive --private-to-local --eliminate-local-single-block --eliminate-local-single-store
    --eliminate-dead-code-aggressive --scalar-replacement=100 --convert-local-access-chains
    --eliminate-local-single-block --eliminate-local-single-store --eliminate-dead-code-aggressive --ssa-rewrite
    --eliminate-dead-code-aggressive --redundancy-elimination --simplify-instructions --eliminate-dead-code-aggressive
    --merge-blocks --preserve-bindings --preserve-spec-constants)

if(NOT AIRLIGHT_SHADERS_FROM)
  add_executable(rotate_loops ${PROJECT_SOURCE_DIR}/shaders/rotate_loops.cpp
                 ${PROJECT_SOURCE_DIR}/core/gpu/rotate_loops.cpp)
  target_include_directories(rotate_loops SYSTEM PRIVATE ${SPIRV_HEADERS_INCLUDE_DIR})
  target_link_libraries(rotate_loops PRIVATE airlight_flags)
endif()

# Reads test_ROOM.objects of another build, as Ninja names the files. Without the encoding CMake would end a line at a
# letter beyond ASCII: airlight_objects(VARIABLE FILE).
function(airlight_objects result file)
  file(STRINGS ${file} objects ENCODING UTF-8)
  list(TRANSFORM objects REPLACE "/\\./" "/")
  set(${result} "${objects}" PARENT_SCOPE)
endfunction()

# Libraries of pure data do not depend on a build's flags. The other build makes them, or checks that they exist.
if(AIRLIGHT_SHADERS_FROM)
  set(taken airlight_shaders airlight_ready)
  if(AIRLIGHT_TESTS)
    list(APPEND taken airlight_test_shaders)
  endif()
  list(TRANSFORM taken REPLACE "(.+)" "${AIRLIGHT_SHADERS_FROM}/lib\\1.a" OUTPUT_VARIABLE taken_files)
  if(AIRLIGHT_TESTS AND AIRLIGHT_TOOL)
    list(APPEND taken test_cli)  # starts the tool that it is told to (tests.cmake)
    file(GLOB lists CONFIGURE_DEPENDS ${AIRLIGHT_SHADERS_FROM}/test_*.objects)
    foreach(file IN LISTS lists)
      get_filename_component(test ${file} NAME_WE)
      airlight_objects(objects ${file})
      list(APPEND taken ${test})
      list(APPEND taken_files ${objects})
    endforeach()
    list(REMOVE_DUPLICATES taken)
  endif()
  add_custom_target(taken_shaders COMMAND ${CMAKE_COMMAND} --build ${AIRLIGHT_SHADERS_FROM} --target ${taken}
                    BYPRODUCTS ${taken_files} COMMENT "Shaders of ${AIRLIGHT_SHADERS_FROM}" VERBATIM)
endif()
function(airlight_take_shaders target)
  add_library(${target} STATIC IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${AIRLIGHT_SHADERS_FROM}/lib${target}.a)
  add_dependencies(${target} taken_shaders)
endfunction()

# A static library TARGET that defines `std::span<const EmbeddedShader> FUNCTION()` in namespace airlight: every source
# given, by file name without extension. Includes are looked up in shaders/.
function(airlight_embed_shaders target function)
  if(AIRLIGHT_SHADERS_FROM)
    airlight_take_shaders(${target})
    return()
  endif()
  set(directory ${PROJECT_BINARY_DIR}/embedded/${target})
  file(MAKE_DIRECTORY ${directory})
  set(arrays)
  set(declarations)
  set(entries)
  foreach(source IN LISTS ARGN)
    get_filename_component(name ${source} NAME_WE)
    set(base ${directory}/${name})
    # .spv first: glslang names it in the depfile, and Ninja insists on the first output.
    add_custom_command(
      OUTPUT ${base}.spv ${base}.cpp
      COMMAND ${GLSLANG} --quiet -V --target-env vulkan1.2 -I${PROJECT_SOURCE_DIR}/shaders --depfile ${base}.d
              -o ${base}.spv ${source}
      COMMAND rotate_loops ${base}.spv
      COMMAND ${SPIRV_VAL} --target-env vulkan1.2 --scalar-block-layout ${base}.spv
      COMMAND ${SPIRV_OPT} ${AIRLIGHT_SPIRV_OPT_FLAGS} --target-env=vulkan1.2 --scalar-block-layout ${base}.spv
              -o ${base}.opt.spv
      COMMAND ${SPIRV_VAL} --target-env vulkan1.2 --scalar-block-layout ${base}.opt.spv
      COMMAND ${CMAKE_COMMAND} -DIN=${base}.opt.spv -DOUT=${base}.cpp -DNAME=${name}
              -P ${PROJECT_SOURCE_DIR}/shaders/embed.cmake
      DEPENDS ${source} ${PROJECT_SOURCE_DIR}/shaders/embed.cmake rotate_loops
      DEPFILE ${base}.d
      COMMENT "Shader ${name}"
      VERBATIM)
    list(APPEND arrays ${base}.cpp)
    string(APPEND declarations "extern const EmbeddedShader kShader_${name};\n")
    string(APPEND entries " kShader_${name},")
  endforeach()
  list(LENGTH ARGN count)
  # Written when configuring, but only if its text changes, so that a configure run does not rebuild it.
  file(CONFIGURE OUTPUT ${directory}/table.cpp @ONLY CONTENT "#include <array>

#include \"core/gpu/embedded_shaders.h\"

namespace airlight {
@declarations@
std::span<const EmbeddedShader> @function@();
std::span<const EmbeddedShader> @function@() {
  static const std::array<EmbeddedShader, @count@> shaders{@entries@};
  return shaders;
}
}  // namespace airlight
")
  add_library(${target} STATIC ${directory}/table.cpp ${arrays})
  target_link_libraries(${target} PUBLIC airlight_flags)
  airlight_compile_together(${target})
endfunction()

file(GLOB shader_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/passes/*.comp)
airlight_embed_shaders(airlight_shaders embedded_shaders ${shader_sources})
