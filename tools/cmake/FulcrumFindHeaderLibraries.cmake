# Libraries whose Debian packages ship no CMake configuration, or one that does not link as it is.

find_package(PkgConfig REQUIRED)
pkg_check_modules(FULCRUM_IMGUI REQUIRED IMPORTED_TARGET imgui)
add_library(imgui INTERFACE)
target_link_libraries(imgui INTERFACE PkgConfig::FULCRUM_IMGUI)

pkg_check_modules(FULCRUM_TINYGLTF REQUIRED IMPORTED_TARGET tinygltf)
add_library(tinygltf INTERFACE)
target_link_libraries(tinygltf INTERFACE PkgConfig::FULCRUM_TINYGLTF)

add_library(glslang_compiler INTERFACE)
target_link_libraries(glslang_compiler INTERFACE glslang::glslang glslang::SPIRV glslang::glslang-default-resource-limits)
