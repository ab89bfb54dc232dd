#include "gui/plan/plan_page.hpp"

#include <gmock/gmock.h>

#include <QLineEdit>
#include <QTest>

#include "gui/plan/candidate_rows.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

std::string cell(const CellRows& rows, std::size_t row, std::size_t column) { return rows.cells[row][column].text.toStdString(); }

TEST(CandidateRows, TheBestStandsFirst) {
  tasks::BoundReport report;
  report.with_more = {{"1:+Y", {0.9}, 0.9, 0.9}, {"2:+Y", {0.5}, 0.6, 0.5}, {"all candidates", {0.4}, 0.4, 0.4}};
  const CellRows rows = candidate_rows(report);
  ASSERT_EQ(rows.cells.size(), 3U);
  EXPECT_EQ(cell(rows, 0, 0), "all candidates");
  EXPECT_EQ(cell(rows, 1, 0), "2:+Y");
  EXPECT_EQ(cell(rows, 1, 1), "0.5");
  EXPECT_EQ(cell(rows, 2, 0), "1:+Y");
}

TEST(CandidateRows, DofsAreReadAsTheCommandReadsThem) {
  EXPECT_EQ(parse_dofs(" 3:+Y, 4:RZ,").size(), 2U);
  EXPECT_THROW(parse_dofs("3:+Q"), InputError);
}

struct Predicting {
  Measured rig{"rig1"};
  PlanPage page;

  Predicting() {
    page.set_scene(ident::read_scene(rig.scene().toStdString()));
    page.set_file(rig.scene());
    page.resize(700, 500);
    page.show();
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
};

TEST(PlanPage, PredictsBoundsAndRanksCandidates) {
  Predicting predicting;
  const ident::Scene scene = ident::read_scene(predicting.rig.scene().toStdString());
  const std::string candidate = ident::make_plan(scene)->coordinates.responses.front().name();
  predicting.page.candidates()->setText(QString::fromStdString(candidate));
  QTest::keyClick(predicting.page.candidates(), Qt::Key_Return);
  ASSERT_TRUE(predicting.rests());
  EXPECT_GT(predicting.page.bounds()->cells()->rowCount(), 0) << predicting.page.status().toStdString();
  ASSERT_EQ(predicting.page.ranking()->cells()->rowCount(), 1) << predicting.page.status().toStdString();
  EXPECT_EQ(predicting.page.ranking()->cells()->index(0, 0).data().toString().toStdString(), candidate);
  EXPECT_THAT(predicting.page.command_line().toStdString(), testing::EndsWith("--bound --candidates " + ("'" + candidate + "'")));
}

TEST(PlanPage, AWrongCandidateIsSaidToBeWrong) {
  Predicting predicting;
  predicting.page.candidates()->setText("3:+Q");
  predicting.page.predict();
  EXPECT_THAT(predicting.page.status().toStdString(), testing::HasSubstr("3:+Q"));
  EXPECT_FALSE(predicting.page.is_busy());
}

TEST(PlanPage, MayBeDestroyedWhileItPredicts) {
  Predicting predicting;
  predicting.page.predict();
}

}  // namespace
}  // namespace jointid::gui
