#include "gui/plan/plan_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/forms/list_completer.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/job_progress.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/look/status_label.hpp"
#include "gui/plan/candidate_rows.hpp"
#include "gui/solve/solution_tables.hpp"
#include "gui/solve/solve_job.hpp"
#include "gui/table/cell_table.hpp"

namespace jointid::gui {

PlanPage::PlanPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Test planning"));
  worker_ = new Worker(this);
  status_ = named(new StatusLabel, "bound_status", tr("Status of the prediction"));
  progress_ = new JobProgress("bound_progress");
  bounds_ = new CellTable("bound_table", tr("Smallest standard errors, and the effect of leaving out data"));
  ranking_ = new CellTable("candidate_table", tr("Candidates, best first"));
  auto* both = named(new QSplitter(Qt::Vertical), "bounds_and_candidates", tr("Bounds and candidates"));
  both->addWidget(bounds_);
  both->addWidget(ranking_);
  both->setSizes({400, 260});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addLayout(status_row(status_, progress_));
  all->addWidget(scrolled(both), 1);
  say(tr("This page shows the smallest standard errors that FRFs of a model or of an earlier test allow. It takes the joint of "
         "[truth] or [identify] start, and the noise of [noise] or of the files."),
      false);
  connect(worker_, &Worker::failed, this, [this](const InputError& error) {
    say(QString::fromUtf8(error.what()), true);
    Q_EMIT failed(error);
  });
  connect(worker_, &Worker::cancelled, this, [this] { say(tr("Cancelled: nothing is predicted."), false); });
  connect(worker_, &Worker::busy_changed, this, [this](bool busy) {
    progress_->set_busy(busy);
    cancel_->setEnabled(busy);
    predict_->setEnabled(!busy && scene_.has_value());
  });
  connect(worker_, &Worker::progressed, progress_, &JobProgress::show_share);
  set_scene({});
}

QWidget* PlanPage::make_top() {
  auto* top = named(new QWidget, "plan_top", tr("Predicting"));
  predict_ = push_button("predict", tr("Predict"), tr("Predict the smallest standard errors and rank the candidates (F7)"));
  cancel_ = push_button("predict_cancel", tr("Cancel"), tr("Stop and show the results so far"));
  cancel_->setEnabled(false);
  candidates_ = named(new QLineEdit, "candidates", tr("Candidates"),
                      tr("DOFs of the files that count as not measured. The plan predicts the benefit of each"));
  candidates_->setPlaceholderText(tr("candidates, not measured so far: 3:+Y, 4:+RZ"));
  completer_ = new ListCompleter(*candidates_, tr("DOFs to choose from"));
  candidates_->setCompleter(completer_);
  auto* command = push_button("predict_command", tr("Copy as command"), tr("Copy the command line with the same prediction"));
  auto* tables = push_button("predict_save", tr("Tables…"), tr("Save both tables as CSV"));
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({predict_, cancel_}, {tables, command}));
  rows->addWidget(candidates_);
  connect(predict_, &QPushButton::clicked, this, &PlanPage::predict);
  connect(candidates_, &QLineEdit::returnPressed, this, &PlanPage::predict);
  connect(cancel_, &QPushButton::clicked, this, &PlanPage::cancel);
  connect(command, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(tables, &QPushButton::clicked, this, &PlanPage::save_tables);
  return top;
}

void PlanPage::set_scene(std::optional<ident::Scene> scene) {
  scene_ = std::move(scene);
  predict_->setEnabled(scene_.has_value() && !is_busy());
}

void PlanPage::set_dofs(const QStringList& dofs) { completer_->set_words(dofs); }

void PlanPage::cancel() { worker_->cancel(); }

bool PlanPage::is_busy() const { return worker_->is_busy(); }

QString PlanPage::status() const { return status_->text(); }

void PlanPage::say(const QString& text, bool bad) {
  status_->set_bad(bad);
  status_->setText(text);
}

void PlanPage::predict() {
  if (!scene_ || is_busy()) return;
  std::vector<frf::Dof> candidates;
  try {
    candidates = parse_dofs(candidates_->text());
  } catch (const InputError& error) {
    return say(QString::fromUtf8(error.what()), true);
  }
  say(tr("Predicting …"), false);
  worker_->add([this, scene = *scene_, candidates](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, report = predict_bound(scene, candidates, watch)] { show_report(report); };
  });
}

void PlanPage::show_report(const tasks::BoundReport& report) {
  tasks::BoundReport without = report;
  without.with_more.clear();
  bounds_->show_rows(bound_rows(without));
  ranking_->show_rows(candidate_rows(report));
  say(report.interrupted ? tr("Cancelled: some changes of the data are not predicted.") : tr("Bounds are predicted."),
      report.interrupted);
}

void PlanPage::save_tables() {
  const QString file =
      choose_file_to_save(this, tr("Save the tables"), QStringLiteral("bounds.csv"), tr("Tables (*.csv)"), QStringLiteral("csv"));
  if (file.isEmpty()) return;
  try {
    write_output(file, (bounds_->text(',') + '\n' + ranking_->text(',')).toStdString(), inputs_of(scene_));
  } catch (const InputError& error) {
    say(QString::fromUtf8(error.what()), true);
  }
}

QString PlanPage::command_line() const {
  QString names = candidates_->text().remove(' ');
  if (!names.isEmpty()) names = QStringLiteral(" --candidates ") + shell_word(names);
  return QStringLiteral("jointid plan %1 --bound").arg(shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_)) + names;
}

}  // namespace jointid::gui
