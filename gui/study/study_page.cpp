#include "gui/study/study_page.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/page/job_line.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"

namespace jointid::gui {

StudyPage::StudyPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Study"));
  line_ =
      new JobLine("study", tr("Status of the study"), tr("Stop and keep the finished trials. The next run continues from there"));
  line_->set_cancelled_text(tr("Cancelled: no trial was finished."));
  chart_ = new Chart("study_histograms", tr("Histograms of the unknowns"),
                     tr("Run shows the estimates of all trials as histograms.\nThe noise is that of [noise], or that of the "
                        "coherences of the files."));
  table_ = new CellTable("study_unknowns", tr("Statistics of the unknowns"));
  table_->hide();
  auto* both = named(new QSplitter(Qt::Vertical), "chart_and_statistics", tr("Histograms and table"));
  both->addWidget(chart_);
  both->addWidget(table_);
  both->setStretchFactor(0, 1);
  both->setSizes({460, 200});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect(line_, &JobLine::failed, this, &StudyPage::failed);
  connect(line_, &JobLine::busy_changed, this, [this](bool busy) { run_->setEnabled(!busy && scene_.has_value()); });
  set_scene({}, {}, {});
}

QWidget* StudyPage::make_top() {
  auto* top = named(new QWidget, "study_top", tr("Studying"));
  run_ = push_button("study", tr("Run"), tr("Identify repeatedly with simulated noise"));
  trials_ = number_box("study_trials", tr("trials"), 1, 1000);
  seed_ = number_box("study_seed", tr("seed"), 0, 1);
  anew_ = named(new QCheckBox(tr("from the beginning")), "study_anew", tr("Do not continue a cancelled run"),
                tr("Discard the trials of a cancelled run, as after a change of the scene"));
  set_choice_ = named(new QComboBox, "study_set", tr("Which histograms"));
  set_choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* command = push_button("study_command", tr("Copy as command"), tr("Copy the command line that writes the same file"));
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({run_, line_->cancel_button(), trials_, seed_}, {command}));
  rows->addLayout(row_of({set_choice_, anew_}, {}));
  connect(run_, &QPushButton::clicked, this, &StudyPage::run);
  connect(command, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(set_choice_, &QComboBox::activated, this, &StudyPage::show_set);
  return top;
}

bool StudyPage::is_busy() const { return line_->is_busy(); }

void StudyPage::set_trials(int trials) { trials_->setValue(trials); }

QString StudyPage::status() const { return line_->status(); }

void StudyPage::set_scene(std::optional<ident::Scene> scene, const std::string& text, const QString& file) {
  scene_ = std::move(scene);
  text_ = text;
  file_ = file;
  run_->setEnabled(scene_.has_value() && !is_busy());
}

QString StudyPage::result_file() const {
  const QFileInfo scene(file_);
  return scene.absolutePath() + "/" + scene.completeBaseName() + ".study.h5";
}

bool StudyPage::can_go_on() const {
  return !anew_->isChecked() && std::filesystem::exists(study::journal_path(as_path(result_file())));
}

void StudyPage::run() {
  if (!scene_ || is_busy()) return;
  if (file_.isEmpty()) return line_->say(tr("Save the scene first. The results of the study are written beside it."), true);
  const StudyWish wish{*scene_,
                       text_,
                       as_path(result_file()),
                       static_cast<std::size_t>(trials_->value()),
                       static_cast<std::uint64_t>(seed_->value()),
                       anew_->isChecked()};
  line_->say(can_go_on() ? tr("Continuing …") : tr("Running …"));
  line_->worker().add([this, wish](const Worker::Watch& watch) -> Worker::Deliver {
    const auto so_far = [&](const StudyShown& shown) { watch.show([this, shown] { show_study(shown); }); };
    return [this, shown = run_study_job(wish, watch, so_far)] {
      show_study(shown);
      if (shown.complete)
        line_->say(QString::fromStdString(shown.text) + tr("\nall results: %1").arg(result_file()));
      else
        line_->say(tr("Cancelled: %1 of %2 trials are kept. Run continues from there.").arg(shown.done).arg(shown.trials), true);
    };
  });
}

void StudyPage::cancel() { line_->cancel(); }

void StudyPage::show_study(const StudyShown& shown) {
  histograms_ = shown.histograms;
  const QString before = set_choice_->currentText();
  set_choice_->clear();
  for (const HistogramSet& set : histograms_) set_choice_->addItem(QString::fromStdString(set.name));
  set_choice_->setCurrentIndex(std::max(0, set_choice_->findText(before)));
  show_set();
  table_->show_rows(rows_of(shown.unknowns));
  table_->setVisible(shown.complete);
}

void StudyPage::show_set() {
  const int chosen = set_choice_->currentIndex();
  if (chosen < 0) return chart_->clear();
  chart_->draw(histograms_[static_cast<std::size_t>(chosen)].plots);
}

QString StudyPage::command_line() const {
  return QStringLiteral("jointid study %1 --trials %2 --seed %3 --out %4%5")
      .arg(shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_))
      .arg(trials_->value())
      .arg(seed_->value())
      .arg(shell_word(result_file()), can_go_on() ? QStringLiteral(" --resume") : QString());
}

}  // namespace jointid::gui
