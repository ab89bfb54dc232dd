#include "gui/compare/compare_page.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "gui/look/choice_button.hpp"
#include "gui/look/paths.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/scene/read_scene.hpp"
#include "study/trial_data.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// Problem A1 with two weightings and two Δ, few trials.
struct Comparing {
  Measured measured{"A1"};
  ComparePage page;
  ident::Scene scene = ident::read_scene(as_path(measured.scene()));

  Comparing() {
    scene.noise = ident::NoiseSection{.model = "gaussian", .level = 0.01, .frf_model = {.level = 0.01}};
    page.resize(900, 700);
    page.show();
    page.set_file(measured.scene());
    page.set_scene(scene);
    find<QSpinBox>(page, "compare_trials")->setValue(4);
    find<ChoiceButton>(page, "compare_weightings")->choose({"WA", "WB"});
    find<ChoiceButton>(page, "compare_deltas")->choose({"0", "0.1"});
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
};

TEST(ComparePage, FindsWhatTheLibraryFinds) {
  Comparing comparing;
  find<QPushButton>(comparing.page, "compare")->click();
  ASSERT_TRUE(comparing.rests());
  const auto& found = comparing.page.comparison().combinations;
  ASSERT_EQ(found.size(), 4U) << comparing.page.status().toStdString();
  study::Alternatives lists;
  lists.weightings = {weighting::Weighting::wa, weighting::Weighting::wb};
  lists.deltas = {0.0, 0.1};
  const auto expected = study::compare(comparing.scene, study::combinations(comparing.scene.identify, lists),
                                       study::load_trial_data, {.trials = 4});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].matrices[0].rms_relative_error.median, expected.combinations[i].matrices[0].rms_relative_error.median);
    EXPECT_EQ(found[i].way.weighting, expected.combinations[i].way.weighting);
  }
  EXPECT_EQ(comparing.page.table()->cells()->rowCount(), 4);
  std::size_t points = 0;
  for (const auto& group : comparing.page.chart()->scatter().groups) points += group.points.size();
  EXPECT_EQ(points, 4U);
}

TEST(ComparePage, FrfsOfModesAreWays) {
  Comparing comparing;
  find<ChoiceButton>(comparing.page, "compare_weightings")->choose({"WA"});
  find<ChoiceButton>(comparing.page, "compare_deltas")->choose({"0"});
  find<ChoiceButton>(comparing.page, "compare_regenerated")->choose({"none", "substructures"});
  comparing.page.run();
  ASSERT_TRUE(comparing.rests());
  const auto& found = comparing.page.comparison().combinations;
  ASSERT_EQ(found.size(), 2U) << comparing.page.status().toStdString();
  EXPECT_EQ(found[1].way.regenerate, (ident::Regeneration{true, false}));
  EXPECT_NE(found[0].matrices[0].rms_relative_error.median, found[1].matrices[0].rms_relative_error.median);
}

TEST(ComparePage, PictureAndTableChooseTogetherAndOpenAWay) {
  Comparing comparing;
  comparing.page.run();
  ASSERT_TRUE(comparing.rests());
  QSignalSpy opened(&comparing.page, &ComparePage::way_opened);
  comparing.page.table()->selectRow(2);
  EXPECT_FALSE(comparing.page.chart()->readout().isEmpty());
  Q_EMIT comparing.page.table()->activated(comparing.page.table()->model()->index(2, 0));
  QTest::keyClick(comparing.page.chart()->canvas(), Qt::Key_Return);
  ASSERT_EQ(opened.count(), 2);
  for (const QList<QVariant>& each : opened) {
    EXPECT_EQ(each.front().value<study::Way>().weighting, comparing.page.comparison().combinations[2].way.weighting);
    EXPECT_EQ(each.front().value<study::Way>().delta, comparing.page.comparison().combinations[2].way.delta);
  }
}

TEST(ComparePage, CancelKeepsTheWaysThatAreDone) {
  Comparing comparing;
  find<QSpinBox>(comparing.page, "compare_trials")->setValue(400);
  comparing.page.run();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !comparing.page.comparison().combinations.empty(); }, 60000));
  comparing.page.cancel();
  ASSERT_TRUE(comparing.rests());
  EXPECT_GE(comparing.page.comparison().combinations.size(), 1U);
  EXPECT_THAT(comparing.page.status().toStdString(), testing::AllOf(HasSubstr("Cancelled"), HasSubstr("finished way")));
}

TEST(ComparePage, SaysWhatASceneLacks) {
  Comparing comparing;
  comparing.scene.truth.clear();
  comparing.page.set_scene(comparing.scene);
  comparing.page.run();
  ASSERT_TRUE(comparing.rests());
  EXPECT_THAT(comparing.page.status().toStdString(), HasSubstr("truth"));
  comparing.page.set_scene({});
  EXPECT_FALSE(find<QPushButton>(comparing.page, "compare")->isEnabled());
}

TEST(ComparePage, CanBeDestroyedWhileItCompares) {
  for (const int wait : {0, 20, 100}) {
    Comparing comparing;
    comparing.page.run();
    QTest::qWait(wait);
  }
}

TEST(ComparePage, TheCommandNamesTheSameWays) {
  Comparing comparing;
  comparing.page.set_file("/a b/c.toml");
  find<ChoiceButton>(comparing.page, "compare_equations")->choose({"nn", "nn nj"});
  find<ChoiceButton>(comparing.page, "compare_regenerated")->choose({"none", "substructures"});
  find<QPushButton>(comparing.page, "compare_command")->click();
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(),
            "jointid compare '/a b/c.toml' --trials 4 --seed 1 --equations 'nn;nn nj' "
            "--weightings WA,WB --deltas 0,0.1 --regenerate none,substructures");
}

}  // namespace
}  // namespace jointid::gui
