// Against a search of all samples.

#include "haptics/geometry/object_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "haptics/math/split_mix.h"

namespace fulcrum::test {
namespace {

Vec3 random_place(SplitMix& random) {
  return {random.uniform(), random.uniform(), random.uniform()};
}

TEST(ObjectMap, AnswersAsASearchOfAllSamples) {
  SplitMix random(1);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 257u, 5000u}) {
    std::vector<Vec3> samples;
    std::vector<std::int32_t> objects;
    for (std::size_t i = 0; i < count; ++i) {
      samples.push_back(random_place(random));
      objects.push_back(static_cast<std::int32_t>(i % 7));
    }
    const ObjectMap map(samples, objects);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = 3 * random_place(random) - Vec3::Ones();
      double least = std::numeric_limits<double>::infinity();
      std::int32_t object = -1;
      for (std::size_t k = 0; k < count; ++k) {
        const double d = (samples[k] - p).squaredNorm();
        if (d >= least) continue;
        least = d;
        object = objects[k];
      }
      ASSERT_EQ(map.nearest(p), object) << count << " samples";
    }
  }
}

TEST(ObjectMap, APointThatIsNotANumberGetsSomeObject) {
  const std::vector<Vec3> samples{Vec3::Zero(), Vec3::Ones()};
  const ObjectMap map(samples, std::vector<std::int32_t>{4, 5});
  const std::int32_t object = map.nearest(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(object == 4 || object == 5);
}

}  // namespace
}  // namespace fulcrum::test
