#include "gui/solve/solve_page.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QTabWidget>
#include <QToolButton>

#include "base/text.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/solve/difference_tab.hpp"
#include "gui/solve/frf_tab.hpp"
#include "gui/solve/joint_tab.hpp"
#include "gui/solve/kept_runs.hpp"
#include "gui/solve/run_tables.hpp"
#include "gui/solve/solution_tables.hpp"
#include "gui/solve/spring_table.hpp"
#include "gui/solve/worth_row.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/identify.hpp"
#include "report/page/solve_plots.hpp"
#include "tasks/joint/joint_layout.hpp"

namespace jointid::gui {

SolvePage::SolvePage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Solve"));
  line_ = new JobLine("solve", tr("Status of the solution"), tr("Stop and keep the best values so far (Shift+F5)"));
  worth_ = new WorthRow;
  plan_ = new CellTable("plan_table", tr("Plan"));
  bounds_ = new CellTable("bounds", tr("Cramér–Rao bounds"));
  unknowns_ = new CellTable("unknowns", tr("Unknowns"));
  springs_ = new CellTable("springs", tr("Springs: stiffness and loss factor"));
  findings_ = new CellTable("findings", tr("Findings"));
  run_table_ = new CellTable("run_table", tr("Comparison of runs"));
  joint_tab_ = new JointTab;
  frf_tab_ = new FrfTab(line_->worker());
  results_ = named(new QTabWidget, "results", tr("Plan and results"));
  results_->addTab(plan_, tr("Plan"));
  results_->addTab(bounds_, tr("Bounds"));
  results_->addTab(unknowns_, tr("Unknowns"));
  results_->addTab(springs_, tr("Springs"));
  results_->setTabVisible(results_->indexOf(springs_), false);
  results_->addTab(joint_tab_, tr("Joint"));
  results_->addTab(findings_, tr("Findings"));
  results_->addTab(frf_tab_, tr("Assembly FRFs"));
  results_->addTab(run_table_, tr("Runs"));
  iterations_menu_ =
      new PlotMenu("iterations", tr("Objective and unknowns over the iterations"),
                   tr("A method that iterates shows its objective and its unknowns here, iteration by iteration."));
  results_->addTab(iterations_menu_, tr("Iterations"));
  results_->setTabVisible(results_->indexOf(iterations_menu_), false);
  difference_tab_ = new DifferenceTab;
  results_->addTab(difference_tab_, tr("Differences"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(line_);
  all->addWidget(worth_);
  all->addWidget(results_, 1);
  connect(line_, &JobLine::failed, this, &SolvePage::failed);
  connect(worth_, &WorthRow::chosen, this, &SolvePage::show_place);
  connect(line_, &JobLine::busy_changed, this, [this](bool busy) {
    if (!busy && stale_) plan_if_quick();
  });
  set_scene({});
}

QWidget* SolvePage::make_top() {
  auto* top = named(new QWidget, "solve_top", tr("Solving"));
  solve_ = push_button("solve", tr("Solve"), tr("Identify the joint (F5)"));
  auto* bound_button =
      push_button("bound", tr("Bounds"), tr("The smallest standard errors that the data allow, and the effect of other data"));
  run_choice_ = named(new QComboBox, "runs", tr("Runs"), tr("Solutions of this scene, the newest last"));
  run_choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* command = push_button("copy_command", tr("Copy as command"), tr("Copy the command line with the same solution"));
  auto* table = push_button("save_table", tr("Table…"), tr("Save the visible table as CSV"));
  auto* page = push_button("save_report", tr("Report…"), tr("Save the page that `jointid solve --report` writes"));
  auto* json = push_button("save_json", tr("JSON…"), tr("Save the solution as `jointid solve --json` writes it"));
  auto* rows = new QGridLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({solve_, bound_button, line_->cancel_button()}, {command}), 0, 0);
  rows->addLayout(row_of({run_choice_, make_run_menu()}, {table, page, json}), 1, 0);
  connect(solve_, &QPushButton::clicked, this, &SolvePage::solve);
  connect(bound_button, &QPushButton::clicked, this, &SolvePage::bound);
  connect(run_choice_, &QComboBox::activated, this, &SolvePage::show_run);
  connect(command, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(table, &QPushButton::clicked, this, &SolvePage::save_table);
  connect(page, &QPushButton::clicked, this, &SolvePage::save_report);
  connect(json, &QPushButton::clicked, this, &SolvePage::save_json);
  return top;
}

FrfPlot* SolvePage::plot() const { return frf_tab_->plot(); }

CellTable* SolvePage::matrix() const { return joint_tab_->matrix(); }

bool SolvePage::is_busy() const { return line_->is_busy(); }

QString SolvePage::status() const { return line_->status(); }

void SolvePage::set_scene(std::optional<ident::Scene> scene) {
  scene_ = std::move(scene);
  solve_->setEnabled(scene_.has_value());
  plot()->protect(inputs_of(scene_));
  if (scene_) plot()->set_bands(scene_->frequency.exclude_hz, scene_->frequency.range_hz);
  stale_ = line_->is_busy();
  if (!stale_) plan_if_quick();
}

void SolvePage::plan_if_quick() {
  stale_ = false;
  if (scene_ && is_quick_to_plan(*scene_)) add_plan();
}

void SolvePage::plan() {
  renew_status_ = true;
  add_plan();
}

void SolvePage::add_plan() {
  if (!scene_) return;
  line_->worker().add([this, scene = *scene_](const Worker::Watch&) -> Worker::Deliver {
    try {
      const auto plan = ident::make_plan(scene);
      return [this, rows = plan_rows(*plan)] { show_plan(rows); };
    } catch (const InputError& error) {
      return [this, error] {
        renew_status_ = true;
        line_->say(QString::fromUtf8(error.what()), true);
        Q_EMIT failed(error);
      };
    }
  });
}

/// A plan that nobody asked for leaves what stands in the status, but for what a plan before it said was wrong.
void SolvePage::show_plan(const CellRows& rows) {
  plan_->show_rows(rows);
  if (line_->is_busy() || !renew_status_) return;
  renew_status_ = false;
  if (runs_.empty())
    line_->say(tr("Planned. F5 solves."));
  else
    show_status();
}

void SolvePage::bound() {
  if (!scene_) return;
  results_->setCurrentWidget(bounds_);
  renew_status_ = false;
  line_->say(tr("Predicting bounds …"));
  line_->worker().add([this, scene = *scene_](const Worker::Watch& watch) -> Worker::Deliver {
    const tasks::BoundReport report = predict_bound(scene, {}, watch);
    return [this, rows = bound_rows(report), cut = report.interrupted] {
      bounds_->show_rows(rows);
      line_->say(cut ? tr("Cancelled: some changes of the data are not predicted.") : tr("Bounds are predicted."), cut);
    };
  });
}

/// Says once of a joint with many unknowns that it has them.
bool SolvePage::is_doubtful() {
  const std::size_t unknowns = unknowns_of(*scene_);
  if (unknowns <= tasks::many_unknowns || unknowns == unknowns_warned_) return false;
  unknowns_warned_ = unknowns;
  line_->say(tr("The joint has %1 unknowns: few tests determine so many, and solving takes long. The joint assistant (Ctrl+J) makes "
                "springs of them. Solve again (F5) solves it as it is.")
                 .arg(unknowns),
             true);
  return true;
}

void SolvePage::solve() {
  if (!scene_ || is_doubtful()) return;
  renew_status_ = false;
  line_->say(tr("Solving …"));
  line_->worker().add([this, scene = *scene_, text = text_, file = file_](const Worker::Watch& watch) -> Worker::Deliver {
    Solved solved = solve_scene(scene, watch);
    solved.scene_text = text;
    solved.scene_file = as_path(file);
    QString lost;
    try {
      if (!file.isEmpty() && !text.empty()) keep_run(solved, file);
    } catch (const InputError& error) {
      lost = QString::fromUtf8(error.what());
    }
    return [this, solved, lost, rows = plan_rows(*solved.plan)] {
      plan_->show_rows(rows);
      add_run(solved);
      if (!lost.isEmpty()) line_->say(status() + QLatin1Char('\n') + tr("The run is not kept: %1").arg(lost));
    };
  });
}

void SolvePage::cancel() { line_->cancel(); }

const Solved* SolvePage::current() const {
  const int run = run_choice_->currentIndex();
  return run < 0 ? nullptr : &runs_[static_cast<std::size_t>(run)];
}

void SolvePage::add_run(Solved solved) {
  const std::size_t number = runs_.empty() ? 1 : std::stoul(runs_.back().name) + 1;
  solved.name = std::to_string(number) + ": " + ident::name(solved.solution.used.method);
  runs_.push_back(std::move(solved));
  if (results_->currentIndex() < 2) results_->setCurrentWidget(unknowns_);
  list_runs(runs_.size() - 1);
  Q_EMIT this->solved();
}

/// What came of the run in front.
void SolvePage::show_status() {
  const ident::Solution& solution = current()->solution;
  QString text = QString::fromStdString(ident::name(solution.status)).replace('_', ' ');
  if (!solution.message.empty()) text += ": " + QString::fromStdString(solution.message);
  if (solution.fit.asm_frf_error) {
    text += tr("\nassembly FRF error %1 dB").arg(QString::fromStdString(digits(*solution.fit.asm_frf_error, "%.3g")));
  }
  text += tr("; %1 s").arg(QString::fromStdString(digits(solution.runtime_s.total)));
  if (!current()->scene_text.empty() && current()->scene_text != text_)
    text += QLatin1Char('\n') + tr("The scene was another then: Run – Scene of this run.");
  if (const auto& changed = current()->changed; !changed.empty())
    text +=
        QLatin1Char('\n') +
        tr("Files that changed since this run: %1.").arg(q(comma_list(changed, [](const std::string& name) { return name; })));
  line_->say(text, !ident::is_usable(solution.status));
}

void SolvePage::show_run(int run) {
  show_status();
  const Solved& solved = runs_[static_cast<std::size_t>(run)];
  const ident::Solution& solution = solved.solution;
  if (solved.plan == nullptr && !solved.scene_text.empty()) ask_for_plan(static_cast<std::size_t>(run));
  scene_of_run_->setEnabled(!solved.scene_text.empty());
  remove_run_->setEnabled(true);
  const report::PlotGroup iterations = report::iteration_plots(solved.iterations);
  results_->setTabVisible(results_->indexOf(iterations_menu_), !iterations.choices.empty());
  iterations_menu_->show_groups({{tr("unknowns"), iterations}});
  worth_->show_answers(runs_[static_cast<std::size_t>(run)].worth);
  unknowns_->show_rows(unknown_rows(solution));
  const CellRows springs = spring_rows(solution);
  results_->setTabVisible(results_->indexOf(springs_), !springs.cells.empty());
  springs_->show_rows(springs);
  findings_->show_rows(finding_rows(solution));
  joint_tab_->show_run(runs_[static_cast<std::size_t>(run)]);
  frf_tab_->show_runs(runs_, static_cast<std::size_t>(run));
  run_table_->show_rows(run_rows(runs_, static_cast<std::size_t>(run)));
  difference_tab_->show_run(runs_, static_cast<std::size_t>(run));
  Q_EMIT run_shown(static_cast<std::size_t>(run));
}

/// The row, the cell or the curve that an answer is about, else the findings; and the answer itself.
void SolvePage::show_place(const tasks::WorthAnswer& answer) {
  line_->say(QString::fromStdString(answer.text), answer.light == tasks::Light::bad);
  if (!answer.unknown.empty()) {
    results_->setCurrentWidget(unknowns_);
    const QModelIndexList rows = unknowns_->cells()->match(unknowns_->cells()->index(0, 0), Qt::DisplayRole,
                                                           QString::fromStdString(answer.unknown), 1, Qt::MatchExactly);
    if (!rows.isEmpty()) unknowns_->setCurrentIndex(rows.front());
  } else if (answer.element) {
    results_->setCurrentWidget(joint_tab_);
    joint_tab_->show_element(*answer.element);
  } else if (answer.frf) {
    results_->setCurrentWidget(frf_tab_);
    frf_tab_->show_error(*answer.frf);
  } else {
    results_->setCurrentWidget(findings_);
  }
}

QString SolvePage::command_line() const {
  return QStringLiteral("jointid solve ") + shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_);
}

/// "rig1.json" of rig1.toml.
QString SolvePage::proposed_name(const QString& ending) const {
  return (file_.isEmpty() ? QStringLiteral("scene") : QFileInfo(file_).completeBaseName()) + ending;
}

void SolvePage::save(const QString& file, const std::string& text) {
  try {
    write_output(file, text, inputs_of(scene_));
  } catch (const InputError& error) {
    line_->say(QString::fromUtf8(error.what()), true);
  }
}

void SolvePage::save_json() {
  const Solved* const run = current();
  if (run == nullptr) return line_->say(tr("There is no solution yet."), true);
  const QString file = choose_file_to_save(this, tr("Save the solution"), proposed_name(QStringLiteral(".json")), tr("JSON (*.json)"),
                                           QStringLiteral("json"));
  if (!file.isEmpty()) save(file, json_of(*run));
}

void SolvePage::save_report() {
  if (current() == nullptr) return line_->say(tr("There is no solution yet."), true);
  const QString file = choose_file_to_save(this, tr("Save the report"), proposed_name(QStringLiteral(".html")), tr("Pages (*.html)"),
                                           QStringLiteral("html"));
  if (!file.isEmpty()) write_report(file);
}

void SolvePage::write_report(const QString& file) {
  const Solved* const run = current();
  if (run == nullptr) return;
  if (run->plan == nullptr) return line_->say(tr("The report needs the FRFs of this run, and they cannot be read."), true);
  line_->worker().add([this, file, solved = *run, inputs = inputs_of(scene_)](const Worker::Watch& watch) -> Worker::Deliver {
    write_output(file, report_of(solved, watch), inputs);
    return [this, file] { line_->say(tr("The report is written to %1.").arg(file)); };
  });
}

void SolvePage::save_table() {
  const auto* const table = results_->currentWidget()->findChild<CellTable*>();
  const auto* const shown = table != nullptr ? table : qobject_cast<CellTable*>(results_->currentWidget());
  if (shown == nullptr) return line_->say(tr("No table is visible. The plot has its own button."), true);
  const QString file = choose_file_to_save(this, tr("Save the table"), proposed_name(QStringLiteral("_%1.csv").arg(shown->objectName())),
                                           tr("Tables (*.csv)"), QStringLiteral("csv"));
  if (!file.isEmpty()) save(file, shown->text(',').toStdString());
}

}  // namespace jointid::gui
