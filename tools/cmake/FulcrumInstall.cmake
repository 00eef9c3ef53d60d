# cmake --install: the haptic core for other programs; the program with its content for people.

include(GNUInstallDirs)

install(TARGETS fulcrum_haptics_math fulcrum_haptics_core fulcrum_haptics_bake fulcrum_options
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/haptics DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fulcrum
        FILES_MATCHING PATTERN "*.h")

function(fulcrum_install_program)
  install(TARGETS fulcrum RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${FULCRUM_CONTENT_DIR}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fulcrum/content)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
