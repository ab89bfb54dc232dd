#include "cli/text/interrupt.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace jointid::cli {
namespace {

TEST(Interrupt, TheFirstSignalAsksTheSecondEnds) {
  EXPECT_FALSE(interrupted());
  EXPECT_EXIT(
      {
        catch_interrupts();
        std::raise(SIGINT);
        if (interrupted()) std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace jointid::cli
