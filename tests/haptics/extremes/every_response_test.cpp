// The responses that every test of this folder with a TEST_P is run for.

#include <gtest/gtest.h>

#include "tests/haptics/extremes/closed_loop.h"

namespace fulcrum::test {
namespace {

INSTANTIATE_TEST_SUITE_P(Extremes, EveryResponse,
                         testing::Values(ContactResponse::penalty, ContactResponse::voxel,
                                         ContactResponse::quasi_static, ContactResponse::constraint),
                         EveryResponse::name);
INSTANTIATE_TEST_SUITE_P(Extremes, EveryResponseThatRests,
                         testing::Values(ContactResponse::penalty, ContactResponse::quasi_static,
                                         ContactResponse::constraint),
                         EveryResponse::name);

}  // namespace
}  // namespace fulcrum::test
