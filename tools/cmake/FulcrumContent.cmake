# Content beside the program: scenario files copied, models made. Target: content.

set(FULCRUM_CONTENT_DIR ${CMAKE_BINARY_DIR}/content)
file(GLOB content_generator CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tools/content/*.cpp)
add_executable(make_piping ${content_generator})
target_link_libraries(make_piping PRIVATE fulcrum::options Eigen3::Eigen tinygltf)
target_include_directories(make_piping PRIVATE ${CMAKE_SOURCE_DIR})
set_target_properties(make_piping PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tools)

set(piping ${FULCRUM_CONTENT_DIR}/scenarios/piping)
add_custom_command(
  OUTPUT ${piping}/piping.glb ${piping}/spanner.glb
  COMMAND ${CMAKE_COMMAND} -E make_directory ${piping}
  COMMAND make_piping ${piping}
  DEPENDS make_piping
  COMMENT "Making the models of piping"
  VERBATIM)
set(content_files ${piping}/piping.glb ${piping}/spanner.glb)

file(GLOB_RECURSE texts RELATIVE ${CMAKE_SOURCE_DIR}/content CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/content/*.yaml)
foreach(text IN LISTS texts)
  add_custom_command(
    OUTPUT ${FULCRUM_CONTENT_DIR}/${text}
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/content/${text} ${FULCRUM_CONTENT_DIR}/${text}
    DEPENDS ${CMAKE_SOURCE_DIR}/content/${text}
    VERBATIM)
  list(APPEND content_files ${FULCRUM_CONTENT_DIR}/${text})
endforeach()
add_custom_target(content ALL DEPENDS ${content_files})
