#include "gui/work/worker.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <random>

#include "base/control.hpp"

namespace jointid::gui {
namespace {

using Deliver = Worker::Deliver;
using Watch = Worker::Watch;

Deliver wait_for_the_end(const Watch& watch) {
  while (!watch.interrupted()) std::this_thread::yield();
  throw Interrupted();
}

bool ends(const Worker& worker) {
  return QTest::qWaitFor([&] { return !worker.is_busy(); }, 5000);
}

TEST(Worker, DeliversInOrderInTheThreadOfTheWindow) {
  Worker worker;
  std::vector<int> got;
  const auto here = std::this_thread::get_id();
  for (int i = 0; i < 5; ++i) {
    worker.add([&, i](const Watch&) -> Deliver {
      EXPECT_NE(std::this_thread::get_id(), here);
      return [&, i] {
        EXPECT_EQ(std::this_thread::get_id(), here);
        got.push_back(i);
      };
    });
  }
  ASSERT_TRUE(ends(worker));
  EXPECT_EQ(got, (std::vector{0, 1, 2, 3, 4}));
}

TEST(Worker, TellsErrorsAndGoesOn) {
  Worker worker;
  std::string said;
  bool done = false;
  QObject::connect(&worker, &Worker::failed, [&](const InputError& error) { said = error.parts().problem; });
  worker.add([](const Watch&) -> Deliver { throw InputError({ErrorKind::data, "f", "p", "it is torn", ""}); });
  worker.add([&](const Watch&) -> Deliver { return [&] { done = true; }; });
  ASSERT_TRUE(ends(worker));
  EXPECT_EQ(said, "it is torn");
  EXPECT_TRUE(done);
}

TEST(Worker, TellsProgress) {
  Worker worker;
  std::vector<JobShare> told;
  QObject::connect(&worker, &Worker::progressed, [&](const JobShare& share) { told.push_back(share); });
  worker.add([](const Watch& watch) -> Deliver {
    watch.progress("reading", 1, 4);
    return {};
  });
  ASSERT_TRUE(ends(worker));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().stage.toStdString(), "reading");
  EXPECT_EQ(told.front().share, 0.25);
  EXPECT_FALSE(told.front().is_whole);
}

TEST(Worker, CancelsAtAnyMoment) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    Worker worker;
    QSignalSpy cancelled(&worker, &Worker::cancelled);
    worker.add(wait_for_the_end);
    worker.add(wait_for_the_end);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 500));
    worker.cancel();
    ASSERT_TRUE(ends(worker));
    EXPECT_EQ(cancelled.count(), 2);
  }
}

TEST(Worker, CanBeDestroyedWhileItWorks) {
  bool delivered = false;
  {
    Worker worker;
    worker.add(wait_for_the_end);
    worker.add([&](const Watch&) -> Deliver { return [&] { delivered = true; }; });
  }
  QTest::qWait(10);
  EXPECT_FALSE(delivered);
}

}  // namespace
}  // namespace jointid::gui
