// main() of tests that draw.

#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  // Mesa crashes on shaders that it has kept for a processor with other vector widths: it keeps those of
  // tests where the build says, not beside those of whoever runs them by hand.
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no thread runs yet.
  if (getenv("MESA_SHADER_CACHE_DIR") == nullptr) setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
