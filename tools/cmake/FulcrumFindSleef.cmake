# SLEEF: Debian ships no CMake package for it.
find_path(SLEEF_INCLUDE_DIR sleef.h)
find_library(SLEEF_LIBRARY sleef)
mark_as_advanced(SLEEF_INCLUDE_DIR SLEEF_LIBRARY)
if(NOT SLEEF_INCLUDE_DIR OR NOT SLEEF_LIBRARY)
  message(FATAL_ERROR "SLEEF is missing: install libsleef-dev. The haptic core takes sin, exp and their like from it, "
                      "so that the same run gives the same bits on every processor.")
endif()
add_library(sleef INTERFACE)
target_link_libraries(sleef INTERFACE ${SLEEF_LIBRARY})
target_include_directories(sleef SYSTEM INTERFACE ${SLEEF_INCLUDE_DIR})
