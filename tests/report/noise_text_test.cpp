#include "report/text/noise_text.hpp"

#include <gtest/gtest.h>

namespace jointid::report {
namespace {

TEST(NoiseText, NamesModelAndSize) {
  EXPECT_EQ(noise_text(ident::NoiseSection{"gaussian", 0.05, {}}), "gaussian, level 0.05");
  EXPECT_EQ(noise_text(ident::NoiseSection{"modal", 0.01, {}}), "modal, level 0.01");
  EXPECT_EQ(noise_text({}), "hammer, coherences and averages of the files");
}

TEST(NoiseText, NamesWhatIsAddedToIt) {
  ident::NoiseSection noise{"uniform", 0.05, {}};
  noise.frf_model.floor = 1e-3;
  noise.frf_model.gross = {0.02, 10.0};
  noise.frf_model.sign_errors = 0.01;
  noise.frf_model.position_errors = 0.002;
  noise.frf_model.reciprocal = false;
  EXPECT_EQ(noise_text(noise),
            "uniform, level 0.05, floor 0.001, gross errors 10 times as large on 2 %, sign errors 1 %, position errors 0.002 m, "
            "not reciprocal");
}

}  // namespace
}  // namespace jointid::report
