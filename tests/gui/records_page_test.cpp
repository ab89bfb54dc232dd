#include "gui/records/records_page.hpp"

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>
#include <cmath>
#include <random>

#include "command_files.hpp"
#include "gui/data/data_page.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/main_window.hpp"
#include "gui/plot/chart.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// Two waves of different size in three channels, 400 samples at 100 Hz.
std::string waves() {
  std::string text = "time [s],left [m],middle [m],right [m]\n";
  for (int i = 0; i < 400; ++i) {
    const double t = 0.01 * i, large = std::sin(7.0 * t), small = 0.2 * std::cos(31.0 * t);
    text +=
        QStringLiteral("%1,%2,%3,%4\n").arg(t, 0, 'g', 17).arg(large + small).arg(1.4 * large).arg(large - small).toStdString();
  }
  return text;
}

/// A contact with μ(V) = 0.3 + 0.2 exp(−8V) under 2 N, with a little noise, in both directions.
std::string slips() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 0.002);
  std::string text = "v [m/s],F [N]\n";
  for (int i = 0; i < 600; ++i) {
    const double v = 0.6 * std::sin(0.05 * i), law = 0.3 + 0.2 * std::exp(-8.0 * std::abs(v));
    text +=
        QStringLiteral("%1,%2\n").arg(v, 0, 'g', 12).arg(2.0 * std::copysign(law, v) + noise(random), 0, 'g', 12).toStdString();
  }
  return text;
}

struct Records {
  QTemporaryDir folder;
  RecordsPage page;

  Records() {
    page.resize(1000, 700);
    page.show();
  }
  QString write(const char* name, const std::string& text) {
    const QString file = folder.filePath(name);
    write_file(file, text);
    return file;
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  bool open(const QStringList& files) {
    page.open(files);
    return rests();
  }
  bool run() {
    find<QPushButton>(page, "records_run")->click();
    return rests();
  }
  void fill(const char* name, const char* text) { find<QLineEdit>(page, name)->setText(QString::fromLatin1(text)); }
  void choose(const char* name, const char* column) { find<QComboBox>(page, name)->setCurrentText(QString::fromLatin1(column)); }
};

void expect_as_the_command(Records& records) {
  expect_the_commands_files(records.page, records.folder);
  expect_every_choice_drawn(records.page);
}

TEST(RecordsPage, FindsProperModesAsTheCommandDoes) {
  Records records;
  ASSERT_TRUE(records.open({records.write("waves.csv", waves())}));
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("left, middle, right"));
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("400 samples of 3 channels"));
  expect_as_the_command(records);
  // Two of the channels, and a second file as further samples.
  find<ChoiceButton>(records.page, "records_pod_channels")->choose({"left", "right"});
  ASSERT_TRUE(records.open({records.folder.filePath("waves.csv"), records.write("more.csv", waves())}));
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("800 samples of 2 channels"));
  EXPECT_THAT(records.page.command_line().toStdString(), HasSubstr("--channels 'left,right'"));
  expect_as_the_command(records);
}

TEST(RecordsPage, FindsDelayAndDimensionAsTheCommandDoes) {
  Records records;
  ASSERT_TRUE(records.open({records.write("waves.csv", waves())}));
  records.page.tools()->setCurrentIndex(1);
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("left"));  // three channels, and none is chosen
  EXPECT_EQ(records.page.shown(), nullptr);
  records.choose("records_delay_channel", "left");
  records.fill("records_delay_delay", "9");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.command_line().toStdString(), HasSubstr("--channel 'left' --delay '9'"));
  expect_as_the_command(records);
}

TEST(RecordsPage, FindsTheLawOfAContactAsTheCommandDoes) {
  Records records;
  ASSERT_TRUE(records.open({records.write("slips.csv", slips())}));
  records.page.tools()->setCurrentIndex(2);
  records.choose("records_friction_velocity", "v");
  records.choose("records_friction_force", "F");
  records.fill("records_friction_load", "2");
  records.fill("records_friction_stick-speed", "0.01");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("falls with speed"));
  expect_as_the_command(records);
}

TEST(RecordsPage, FindsDisplacementsAsTheCommandDoes) {
  Records records;
  ASSERT_TRUE(records.open({records.write("waves.csv", waves())}));
  records.page.tools()->setCurrentIndex(3);
  records.fill("records_strain_length", "0.4");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("--thickness"));
  records.fill("records_strain_thickness", "0.001");
  records.fill("records_strain_gauges", "0.05,0.1,here");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("'here' is no number"));
  records.fill("records_strain_gauges", "0.05,0.1,0.2");
  records.fill("records_strain_points", "0.3,0.4");
  records.fill("records_strain_shapes", "2");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("3 gauges, 2 shapes"));
  expect_as_the_command(records);
}

TEST(RecordsPage, FindsLateChannelsAsTheCommandDoes) {
  Records records;
  ASSERT_TRUE(records.open({records.write("waves.csv", waves())}));
  records.page.tools()->setCurrentIndex(4);
  records.choose("records_align_reference", "middle");
  records.fill("records_align_frequency", "1.1140846");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("against middle"));
  EXPECT_THAT(records.page.status().toStdString(), testing::Not(HasSubstr("no harmonic")));
  expect_as_the_command(records);
  records.fill("records_align_frequency", "3.7");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("is the frequency right"));
}

TEST(RecordsPage, SaysWhatIsWrong) {
  Records records;
  EXPECT_FALSE(find<QPushButton>(records.page, "records_run")->isEnabled());
  ASSERT_TRUE(records.open({records.write("slips.csv", slips())}));
  records.page.tools()->setCurrentIndex(2);
  records.choose("records_friction_velocity", "v");
  for (const auto& [field, text, said] :
       {std::tuple("records_friction_load", "2", "--force"), std::tuple("records_friction_load", "much", "'much' is no number"),
        std::tuple("records_friction_load", "-2", "not above 0"), std::tuple("records_friction_load", "2", "--stick-speed")}) {
    records.fill(field, text);
    ASSERT_TRUE(records.run());
    EXPECT_THAT(records.page.status().toStdString(), HasSubstr(said));
    EXPECT_EQ(records.page.shown(), nullptr);
    records.choose("records_friction_force", "F");
  }
  records.page.tools()->setCurrentIndex(1);
  records.choose("records_delay_channel", "v");
  records.fill("records_delay_samples", "50");
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("from 100 to 200000"));
  ASSERT_TRUE(records.open({records.write("a.csv", waves()), records.write("b.csv", waves())}));
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("2 were opened"));
  ASSERT_TRUE(records.open({records.write("text.csv", "")}));
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("text.csv"));
}

TEST(RecordsPage, NoOutputReplacesAnInput) {
  Records records;
  const QString file = records.write("waves.csv", waves()), modes = records.write("modes.csv", "a\n1\n2\n1\n");
  ASSERT_TRUE(records.open({file}));
  find<QLineEdit>(records.page, "records_pod_compare")->setText(modes);
  ASSERT_TRUE(records.run());
  ASSERT_NE(records.page.shown(), nullptr) << records.page.status().toStdString();
  for (const QString& input : {file, modes}) {
    const std::string before = read_file(input);
    records.page.write(input, "csv");
    EXPECT_EQ(read_file(input), before);
    EXPECT_THAT(records.page.status().toStdString(), HasSubstr(input.section('/', -1).toStdString()));
  }
}

TEST(RecordsPage, CanBeCancelledAndDestroyedAtAnyMoment) {
  for (const int wait : {0, 2, 10}) {
    Records records;
    ASSERT_TRUE(records.open({records.write("waves.csv", waves())}));
    records.page.tools()->setCurrentIndex(1);
    records.choose("records_delay_channel", "left");
    records.page.run();
    QTest::qWait(wait);
    records.page.cancel();
    ASSERT_TRUE(records.rests());
    records.page.run();
    QTest::qWait(wait);
  }
}

TEST(RecordsPage, HasATabAndAKey) {
  MainWindow window;
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  ASSERT_NE(window.current(), nullptr);
  QTest::keyClick(&window, Qt::Key_4, Qt::ControlModifier);
  EXPECT_EQ(window.current()->pages()->currentWidget(), window.current()->records_page());
}

/// Three impacts a second apart at 256 Hz, the third with a second peak; the motion is twice the force, a sample later.
std::string impacts() {
  std::string text = "time,hammer,a\n";
  const auto force = [](int i) {
    const int in = i % 256;
    const bool twice = i / 256 == 2 && in >= 60 && in <= 62;
    return in == 20 || in == 22 || twice ? 5.0 : in == 21 ? 10.0 : 0.0;
  };
  for (int i = 0; i < 768; ++i) {
    const double after = i > 0 ? 2.0 * force(i - 1) : 0.0;
    text += QStringLiteral("%1,%2,%3\n").arg(i / 256.0, 0, 'g', 17).arg(force(i), 0, 'g', 17).arg(after, 0, 'g', 17).toStdString();
  }
  return text;
}

struct Impacts : Records {
  Impacts() {
    page.choose_tool("frf");
    EXPECT_TRUE(open({write("hits.csv", impacts())}));
    fill("records_frf_channel", "hammer=1:+Z N; a=2:+Z m/s^2");
    fill("records_frf_block", "0.9");
    fill("records_frf_pretrigger", "0.05");
  }
};

TEST(RecordsPage, MakesFrfsAsTheCommandDoes) {
  Impacts records;
  ASSERT_TRUE(records.run());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("2 of 3 segments averaged"));
  expect_as_the_command(records);
}

TEST(RecordsPage, RejectedImpactsHaveTheirReasonAndTracesTheirWindows) {
  Impacts records;
  ASSERT_TRUE(records.run());
  const Findings& found = *records.page.shown();
  const CellRows& segments = found.tables.front().second;
  ASSERT_EQ(segments.cells.size(), 3U);
  QString third;
  for (const Cell& cell : segments.cells[2]) third += cell.text + ' ';
  EXPECT_THAT(third.toStdString(), HasSubstr("double"));
  ASSERT_EQ(found.plots.size(), 2U);
  const auto& record = found.plots[1].second.choices.front().plots;
  ASSERT_EQ(record.size(), 2U);  // a channel each
  const auto& force = std::get<report::CurvePlot>(record.front());
  EXPECT_EQ(force.series.size(), 3U);  // record, averaged, left out
  EXPECT_THAT(force.y.label, HasSubstr("(N)"));
}

TEST(RecordsPage, CoherenceFollowsWhatIsSet) {
  Impacts records;
  ASSERT_TRUE(records.run());
  auto* const keep = find<QCheckBox>(records.page, "records_frf_keep-faulty");
  keep->click();
  ASSERT_TRUE(records.rests());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("3 of 3 segments averaged"));
  records.fill("records_frf_block", "-1");
  Q_EMIT find<QLineEdit>(records.page, "records_frf_block")->editingFinished();
  ASSERT_TRUE(records.rests());
  EXPECT_THAT(records.page.status().toStdString(), HasSubstr("--block"));
}

TEST(RecordsPage, FrfsGoStraightIntoTheScene) {
  const QTemporaryDir folder;
  write_file(folder.filePath("hits.csv"), impacts());
  MainWindow window;
  window.show();
  window.open({folder.filePath("hits.csv")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.count() == 1; }, 20000));
  Project& project = *window.current();
  RecordsPage& page = *project.records_page();
  page.choose_tool("frf");
  find<QLineEdit>(page, "records_frf_channel")->setText("hammer=1:+Z N; a=2:+Z m/s^2");
  find<QLineEdit>(page, "records_frf_block")->setText("0.9");
  const auto rests = [&] { return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000); };
  ASSERT_TRUE(rests());
  page.run();
  ASSERT_TRUE(rests());
  page.write_frfs(folder.filePath("part.h5"));
  find<QComboBox>(page, "records_role")->setCurrentIndex(1);
  page.write_frfs(folder.filePath("both.h5"));
  EXPECT_THAT(project.editor()->text(), HasSubstr("substructures = [\"part.h5\"]"));
  EXPECT_THAT(project.editor()->text(), HasSubstr("assembly = [\"both.h5\"]"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return project.data_page()->files().size() == 2; }, 20000));
  EXPECT_EQ(project.data_page()->files().front().error, "");
  project.editor()->document()->setModified(false);
}

}  // namespace
}  // namespace jointid::gui
