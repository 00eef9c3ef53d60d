# cmake --install: the haptic core for other programs, found by find_package(fulcrum); the program with its content for
# people.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/fulcrum)
foreach(room IN ITEMS haptics_math haptics_core haptics_bake options)
  set_target_properties(fulcrum_${room} PROPERTIES EXPORT_NAME ${room})
endforeach()
foreach(room IN ITEMS haptics_math haptics_core haptics_bake)
  target_include_directories(fulcrum_${room} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fulcrum>)
endforeach()
# The inline functions of the core give a program that uses it the same bits as they give us.
target_compile_options(fulcrum_haptics_math INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
install(TARGETS fulcrum_haptics_math fulcrum_haptics_core fulcrum_haptics_bake fulcrum_options sleef EXPORT fulcrum
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT fulcrum NAMESPACE fulcrum:: FILE fulcrumTargets.cmake DESTINATION ${package})
configure_package_config_file(${CMAKE_SOURCE_DIR}/tools/cmake/fulcrumConfig.cmake.in ${CMAKE_BINARY_DIR}/fulcrumConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/fulcrumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/fulcrumConfig.cmake ${CMAKE_BINARY_DIR}/fulcrumConfigVersion.cmake DESTINATION ${package})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/haptics DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fulcrum
        FILES_MATCHING PATTERN "*.h")

function(fulcrum_install_program)
  install(TARGETS fulcrum fulcrum-studies fulcrum-import RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(OpenXR_FOUND)
    install(TARGETS fulcrum-xr RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  install(DIRECTORY ${FULCRUM_CONTENT_DIR}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fulcrum/content)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CONTRIBUTING.md
          DESTINATION ${CMAKE_INSTALL_DOCDIR})
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs ${CMAKE_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
