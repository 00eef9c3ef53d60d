# What every target shares, and fulcrum_room().

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# -O3 costs a third more time to compile and brings gcc 12's false alarms about std::string (its bug 105651).
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

find_program(FULCRUM_CCACHE ccache)
if(FULCRUM_CCACHE)
  # Precompiled headers need what follows to be cached at all.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${FULCRUM_CCACHE})
endif()

add_library(fulcrum_options INTERFACE)
target_compile_options(fulcrum_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast -Wnon-virtual-dtor -Werror
  # Same input, same bits: no fused multiply-add that one processor has and another has not.
  -ffp-contract=off)
add_library(fulcrum::options ALIAS fulcrum_options)

set(FULCRUM_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined or thread")
if(FULCRUM_SANITIZE)
  add_compile_options(-fsanitize=${FULCRUM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${FULCRUM_SANITIZE})
  if(FULCRUM_SANITIZE MATCHES undefined)
    # vptr: glslang is built without RTTI. The others look at every use of a pointer: most of what they find, the address
    # sanitizer finds too, and with Eigen they make the tests take 1.8 times as long.
    add_compile_options(-fno-sanitize=vptr,null,alignment,object-size,pointer-overflow)
  endif()
endif()

# The presets compile a target's files in batches of ten (CMAKE_UNITY_BUILD), about half the work of one by one, since most
# of it is reading headers and instantiating Eigen. Names in unnamed namespaces therefore differ within a target. The
# presets debug and tidy compile each file by itself.

# fulcrum_room(NAME PATHS folder... [REACHES target...] [PRIVATELY target...])
#
# A static library fulcrum_NAME of every .cpp below the folders. Its headers are seen as "folder/header.h"
# through an include root that holds these folders alone, so that another room's headers are found only by
# listing that room in REACHES. PRIVATELY: reached by the sources, not by the headers.
# engine/app keeps main() out of its library, so that tests can call what is below it; a folder `template` is for tests alone.
function(fulcrum_room name)
  cmake_parse_arguments(ROOM "" "" "PATHS;REACHES;PRIVATELY" ${ARGN})
  set(root ${CMAKE_BINARY_DIR}/rooms/${name})
  set(sources "")
  foreach(path IN LISTS ROOM_PATHS)
    cmake_path(GET path PARENT_PATH parent)
    file(MAKE_DIRECTORY ${root}/${parent})
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${path} ${root}/${path} SYMBOLIC)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.cpp)
    list(FILTER found EXCLUDE REGEX "/(main|template/[^/]*)\\.cpp$")
    list(APPEND sources ${found})
  endforeach()
  add_library(fulcrum_${name} STATIC ${sources})
  add_library(fulcrum::${name} ALIAS fulcrum_${name})
  target_include_directories(fulcrum_${name} PUBLIC $<BUILD_INTERFACE:${root}>)
  foreach(reached IN LISTS ROOM_REACHES)
    fulcrum_reach(${name} PUBLIC ${reached})
  endforeach()
  foreach(reached IN LISTS ROOM_PRIVATELY)
    fulcrum_reach(${name} PRIVATE ${reached})
  endforeach()
  target_link_libraries(fulcrum_${name} PRIVATE fulcrum::options)
endfunction()

# Eigen is half of what compiling the haptic core costs: read once for all rooms that know poses.
function(fulcrum_precompile_eigen room)
  target_precompile_headers(fulcrum_${room} PRIVATE <Eigen/Core> <Eigen/Geometry>)
endfunction()

# The rooms that follow use what the first has compiled.
function(fulcrum_reuse_eigen first)
  foreach(room IN LISTS ARGN)
    target_precompile_headers(fulcrum_${room} REUSE_FROM fulcrum_${first})
  endforeach()
endfunction()

function(fulcrum_reach name visibility target)
  if(TARGET fulcrum_${target})
    target_link_libraries(fulcrum_${name} ${visibility} fulcrum_${target})
  else()
    target_link_libraries(fulcrum_${name} ${visibility} ${target})
  endif()
endfunction()
