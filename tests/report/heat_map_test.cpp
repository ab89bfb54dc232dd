#include "report/page/heat_map.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tasks/solution_details.hpp"

namespace jointid::report {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

const std::vector<frf::Dof> rows = {frf::Dof::parse("1:+Y"), frf::Dof::parse("2:-Y")},
                            columns = {frf::Dof::parse("1:+Y"), frf::Dof::parse("3:+X")};

TEST(ErrorMap, TotalsAreRootMeanSquaresOfWhatIsThere) {
  const HeatMap map = error_map("title", rows, columns, {3.0, 4.0, missing, 1.0});
  EXPECT_THAT(map.rows, ElementsAre("1:+Y", "2:-Y"));
  EXPECT_THAT(map.row_totals, ElementsAre(DoubleNear(std::sqrt(12.5), 1e-12), 1.0));
  EXPECT_THAT(map.column_totals, ElementsAre(3.0, DoubleNear(std::sqrt(8.5), 1e-12)));
  EXPECT_TRUE(std::isnan(error_map("", rows, columns, {missing, missing, 1.0, 1.0}).row_totals[0]));
}

TEST(ErrorMap, WorstFrfsComeFirstAndThoseWithoutErrorsNotAtAll) {
  EXPECT_THAT(tasks::worst_first({1.0, missing, 5.0, 5.0}), ElementsAre(2U, 3U, 0U));
  const Table table = worst_frfs(error_map("", rows, columns, {0.1, missing, 2.5, 0.2}));
  ASSERT_EQ(table.rows().size(), 3U);
  EXPECT_THAT(table.rows()[0], ElementsAre("2:-Y / 1:+Y", "2.50"));
  EXPECT_THAT(table.rows()[2], ElementsAre("1:+Y / 1:+Y", "0.10"));
}

}  // namespace
}  // namespace jointid::report
