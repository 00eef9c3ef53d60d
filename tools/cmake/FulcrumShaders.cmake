# fulcrum_shaders(TARGET FOLDER): compiles the folder's .vert and .frag to SPIR-V and builds the words into the
# target, which then finds them through engine/render/embedded_shaders.h. Nothing has to be installed beside the
# program. A changed header in the folder compiles again what includes it.

find_program(FULCRUM_GLSLANG glslangValidator REQUIRED)

function(fulcrum_shaders target folder)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  file(MAKE_DIRECTORY ${out})
  file(GLOB shaders CONFIGURE_DEPENDS ${folder}/*.vert ${folder}/*.frag)
  set(includes "")
  set(cases "")
  set(words "")
  foreach(shader IN LISTS shaders)
    cmake_path(GET shader FILENAME name)
    string(MAKE_C_IDENTIFIER ${name} symbol)
    add_custom_command(
      OUTPUT ${out}/${name}.inc
      COMMAND ${FULCRUM_GLSLANG} --quiet --target-env vulkan1.3 --vn ${symbol} --depfile ${out}/${name}.d
              -o ${out}/${name}.inc ${shader}
      DEPENDS ${shader}
      DEPFILE ${out}/${name}.d
      COMMENT "Compiling shader ${name}"
      VERBATIM)
    list(APPEND words ${out}/${name}.inc)
    string(APPEND includes "#include \"${name}.inc\"\n")
    string(APPEND cases "  if (name == \"${name}\") return ${symbol};\n")
  endforeach()
  file(CONFIGURE OUTPUT ${out}/embedded_shaders.cpp @ONLY CONTENT [[
// Written by tools/cmake/FulcrumShaders.cmake.
#include "engine/render/embedded_shaders.h"

namespace {
@includes@}  // namespace

namespace fulcrum::render {
std::span<const std::uint32_t> embedded_shader(std::string_view name) {
@cases@  return {};
}
}  // namespace fulcrum::render
]])
  # The words are no translation unit of their own: the object depends on them, and a target is where they are made.
  set_source_files_properties(${out}/embedded_shaders.cpp PROPERTIES OBJECT_DEPENDS "${words}" SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${out}/embedded_shaders.cpp ${words})
  target_include_directories(${target} PRIVATE ${out})
  # A Debug build compiles the folder again while it runs, whenever a file of it changes.
  target_compile_definitions(${target} PRIVATE $<$<CONFIG:Debug>:FULCRUM_SHADER_FOLDER="${folder}">)
endfunction()
