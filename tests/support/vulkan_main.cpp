// main() of tests that draw.

#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  // Processors with other vector widths crash on shaders that Mesa has cached for each other.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
