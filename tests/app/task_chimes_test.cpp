// What of a task is heard.

#include "engine/app/run/task_chimes.h"

#include <gtest/gtest.h>

namespace fulcrum::test {
namespace {

using audio::Chime;

TEST(TaskChimes, TellEachThingOnce) {
  app::TaskChimes chimes;
  scenario::TaskState task;
  task.reached.resize(3);
  EXPECT_EQ(chimes.next(task), std::nullopt);
  task.reached[1] = 4;  // in whatever order
  EXPECT_EQ(chimes.next(task), Chime::checkpoint);
  EXPECT_EQ(chimes.next(task), std::nullopt);
  task.hard_touches = 1;
  EXPECT_EQ(chimes.next(task), Chime::hard_touch);
  EXPECT_EQ(chimes.next(task), std::nullopt);
  task.hard_touches = 2;
  task.reached[0] = 5;
  EXPECT_EQ(chimes.next(task), Chime::checkpoint);
  EXPECT_EQ(chimes.next(task), std::nullopt);
  task.reached[2] = 6;
  task.completed = true;
  EXPECT_EQ(chimes.next(task), Chime::completed);
  EXPECT_EQ(chimes.next(task), std::nullopt);
}

}  // namespace
}  // namespace fulcrum::test
