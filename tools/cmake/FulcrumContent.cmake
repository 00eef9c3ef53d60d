# Content beside the program: scenario files copied, models made. Targets: content_texts, content_NAME with the models of
# one scenario, and content, which is all of it.

set(FULCRUM_CONTENT_DIR ${CMAKE_BINARY_DIR}/content)

file(GLOB content_mesh CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tools/content/mesh/*.cpp)
add_library(content_mesh STATIC ${content_mesh} ${CMAKE_SOURCE_DIR}/engine/assets/gltf_builder.cpp)
target_link_libraries(content_mesh PUBLIC fulcrum::options fulcrum::haptics_math PRIVATE tinygltf)
target_include_directories(content_mesh PUBLIC ${CMAKE_SOURCE_DIR})

# fulcrum_models(SCENARIO MODEL...): the program make_SCENARIO of the folder of that name, and the models it makes.
set(content_targets "")
function(fulcrum_models scenario)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tools/content/${scenario}/*.cpp)
  add_executable(make_${scenario} ${sources})
  target_link_libraries(make_${scenario} PRIVATE content_mesh)
  set_target_properties(make_${scenario} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tools)
  set(folder ${FULCRUM_CONTENT_DIR}/scenarios/${scenario})
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE models)
  add_custom_command(
    OUTPUT ${models}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND make_${scenario} ${folder}
    DEPENDS make_${scenario}
    COMMENT "Making the models of ${scenario}"
    VERBATIM)
  add_custom_target(content_${scenario} DEPENDS ${models})
  set(content_targets ${content_targets} content_${scenario} PARENT_SCOPE)
endfunction()

fulcrum_models(tutorial stations.glb bench.glb numbers.glb blade.glb)
fulcrum_models(piping piping.glb spanner.glb)
fulcrum_models(teeth jaw.glb explorer.glb)
fulcrum_models(ear ear.glb ear_open.glb needle.glb)
fulcrum_models(plate plate.glb stand.glb marks.glb table.glb stylus.glb)
fulcrum_models(knock boards.glb pegs_steel.glb pegs_wood.glb pegs_rubber.glb bench.glb bar.glb)
fulcrum_models(stick ball.glb stand.glb table.glb stick.glb)
fulcrum_models(sweep tablet.glb marks.glb desk.glb finger.glb)
fulcrum_models(nut cover.glb wall.glb nut.glb)

file(GLOB_RECURSE texts RELATIVE ${CMAKE_SOURCE_DIR}/content CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/content/*.yaml
     ${CMAKE_SOURCE_DIR}/content/schema/*.json ${CMAKE_SOURCE_DIR}/content/references/*)
foreach(text IN LISTS texts)
  add_custom_command(
    OUTPUT ${FULCRUM_CONTENT_DIR}/${text}
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/content/${text} ${FULCRUM_CONTENT_DIR}/${text}
    DEPENDS ${CMAKE_SOURCE_DIR}/content/${text}
    VERBATIM)
  list(APPEND copies ${FULCRUM_CONTENT_DIR}/${text})
endforeach()
add_custom_target(content_texts DEPENDS ${copies})
foreach(target IN LISTS content_targets)
  add_dependencies(${target} content_texts)
endforeach()
add_custom_target(content ALL DEPENDS ${copies})
add_dependencies(content ${content_targets})
