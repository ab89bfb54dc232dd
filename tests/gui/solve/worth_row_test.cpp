#include "gui/solve/worth_row.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <set>

#include "gui/look/paths.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/scene/read_scene.hpp"
#include "tests/gui/widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

std::vector<tasks::WorthAnswer> answers(tasks::Light light) {
  using tasks::WorthQuestion;
  return {{WorthQuestion::determined, light, "One.", "K(1,2)"},
          {WorthQuestion::passive, light, "Two."},
          {WorthQuestion::noise, light, "Three."},
          {WorthQuestion::better_than_none, light, "Four."}};
}

TEST(WorthRow, ASignSaysWhatTheColourDoes) {
  WorthRow row;
  EXPECT_TRUE(row.isHidden());
  std::set<QString> texts, styles;
  for (const auto light : {tasks::Light::good, tasks::Light::doubtful, tasks::Light::bad, tasks::Light::unknown}) {
    row.show_answers(answers(light));
    texts.insert(row.lights().front()->text());
    styles.insert(row.lights().front()->styleSheet());
    EXPECT_THAT(row.lights().front()->text().toStdString(), HasSubstr("determined"));
    EXPECT_EQ(row.lights().front()->toolTip(), "One.");
  }
  EXPECT_EQ(texts.size(), 4U);
  EXPECT_EQ(styles.size(), 4U);
  EXPECT_FALSE(row.isHidden());
  row.show_answers({});
  EXPECT_TRUE(row.isHidden());
}

TEST(WorthRow, AClickAsksForThePlaceOfItsAnswer) {
  WorthRow row;
  row.show_answers(answers(tasks::Light::doubtful));
  std::vector<std::string> chosen;
  QObject::connect(&row, &WorthRow::chosen, [&](const tasks::WorthAnswer& answer) { chosen.push_back(answer.text); });
  for (QPushButton* light : row.lights()) light->click();
  EXPECT_THAT(chosen, testing::ElementsAre("One.", "Two.", "Three.", "Four."));
}

/// A page that has solved A1.
struct SolvedPage {
  Measured measured{"A1"};
  SolvePage page;

  SolvedPage() {
    page.resize(900, 700);
    page.show();
    page.set_file(measured.scene());
    page.set_scene(ident::read_scene(as_path(measured.scene())));
    page.solve();
    rests();
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  QWidget* shown() const { return page.results()->currentWidget(); }
};

TEST(WorthRow, LeadsToTheRowOrTheCurve) {
  SolvedPage solved;
  ASSERT_EQ(solved.page.runs().size(), 1U);
  const std::vector<tasks::WorthAnswer>& found = solved.page.runs().front().worth;
  ASSERT_EQ(found.size(), 4U);
  const std::vector<QPushButton*>& lights = solved.page.worth()->lights();
  lights[0]->click();
  EXPECT_EQ(solved.shown(), solved.page.unknowns());
  const QModelIndex row = solved.page.unknowns()->currentIndex();
  EXPECT_EQ(row.siblingAtColumn(0).data().toString().toStdString(), found[0].unknown);
  lights[3]->click();
  ASSERT_TRUE(solved.rests());
  EXPECT_TRUE(solved.page.plot()->isVisible());
  EXPECT_EQ(solved.page.plot()->view(), View::difference);
  ASSERT_FALSE(solved.page.plot()->curves().empty());
  EXPECT_EQ(solved.page.plot()->curves().front().response.name(), found[3].frf->response.name());
  EXPECT_EQ(solved.page.plot()->curves().front().reference.name(), found[3].frf->reference.name());
  EXPECT_EQ(solved.page.status().toStdString(), found[3].text);
}

TEST(WorthRow, LeadsToTheCellOfTheMatrix) {
  SolvedPage solved;
  ASSERT_EQ(solved.page.runs().size(), 1U);
  tasks::WorthAnswer answer{tasks::WorthQuestion::passive, tasks::Light::bad, "Not passive."};
  answer.element = tasks::MatrixElement{.kind = restrictions::Kind::stiffness, .row = 2, .column = 2};
  Q_EMIT solved.page.worth()->chosen(answer);
  EXPECT_TRUE(solved.page.matrix()->isVisible());
  EXPECT_EQ(solved.page.matrix()->currentIndex(), solved.page.matrix()->cells()->index(2, 2));
}

}  // namespace
}  // namespace jointid::gui
