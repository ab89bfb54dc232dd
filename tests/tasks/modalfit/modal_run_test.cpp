#include "tasks/modalfit/modal_run.hpp"

#include <gmock/gmock.h>

#include "problems/case/modal_set.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

TEST(ModalRun, OfASetInMemoryIsThatOfItsFile) {
  const TestFolder folder;
  const auto file = problems::write(problems::make_modal_set("modes-pair"), folder, {.format = "h5"});
  modalfit::FitOptions options;
  options.range_hz = {95.0, 106.0};
  const ModalRun of_file = run_modal_files({file}, {}, options), in_memory = run_modal("pair", frf::load(*frf::open(file)), options);
  EXPECT_EQ(of_file.files, file.filename().string());
  EXPECT_EQ(in_memory.files, "pair");
  ASSERT_EQ(in_memory.fit.modes.size(), 2U);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(in_memory.fit.modes[r].pole.frequency_hz, of_file.fit.modes[r].pole.frequency_hz);
    EXPECT_NEAR(in_memory.fit.modes[r].pole.frequency_hz, 100.0 + static_cast<double>(r), 0.01);
  }
  EXPECT_EQ(in_memory.regenerated.values.size(), of_file.regenerated.values.size());
  EXPECT_GT(of_file.read_s, 0.0);
}

}  // namespace
}  // namespace jointid::tasks
