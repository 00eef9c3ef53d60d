# fulcrum_scene_tests(NAME): what every shipped scenario with models of its own is asked: make_NAME --check, its route and
# checkpoints, the bake, its hands (hands_test.sh) and the goldens of its views (picture_test.cpp).
function(fulcrum_scene_tests name)
  add_executable(${name}_tests picture_test.cpp ${CMAKE_SOURCE_DIR}/tests/support/scene_picture.cpp $<TARGET_OBJECTS:fulcrum_vulkan_main>)
  target_link_libraries(${name}_tests PRIVATE fulcrum::app fulcrum_image_compare GTest::gtest fulcrum::options)
  target_include_directories(${name}_tests PRIVATE ${CMAKE_SOURCE_DIR})
  fulcrum_precompile_tests(${name}_tests)
  target_compile_definitions(${name}_tests PRIVATE FULCRUM_GOLDENS="${CMAKE_CURRENT_SOURCE_DIR}/golden"
                             FULCRUM_FAILURES="${CMAKE_BINARY_DIR}/tests/failures/${name}")
  add_dependencies(${name}_tests content)

  add_test(NAME ${name}.Models COMMAND make_${name} --check)
  add_test(NAME ${name}.Route COMMAND bash ${CMAKE_SOURCE_DIR}/tests/support/route_test.sh)
  add_test(NAME ${name}.Bake COMMAND fulcrum explain ${name})
  add_test(NAME ${name}.Hands COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/hands_test.sh)
  add_test(NAME ${name}.Picture COMMAND ${name}_tests)
  foreach(test IN ITEMS Models Route Bake Hands Picture)
    set_tests_properties(${name}.${test} PROPERTIES TIMEOUT ${FULCRUM_TEST_LIMIT} ENVIRONMENT
      "XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/tests/cache;FULCRUM_CONTENT=${CMAKE_BINARY_DIR}/content;${FULCRUM_SHADERS};MAKE=$<TARGET_FILE:make_${name}>;FULCRUM=$<TARGET_FILE:fulcrum>;SCENARIO=${CMAKE_SOURCE_DIR}/content/scenarios/${name}")
  endforeach()
  # Under a sanitizer the build has run this program already, to make the models, and --check does that again.
  set_tests_properties(${name}.Models PROPERTIES LABELS "no-asan;no-tsan")
  set_tests_properties(${name}.Bake PROPERTIES FIXTURES_SETUP ${name}_baked FAIL_REGULAR_EXPRESSION "Repaired")
  set_tests_properties(${name}.Hands ${name}.Picture PROPERTIES FIXTURES_REQUIRED ${name}_baked)
endfunction()
