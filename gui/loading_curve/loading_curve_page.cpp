#include "gui/loading_curve/loading_curve_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QItemSelectionModel>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "gui/loading_curve/loading_curve_choices.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/file_drop.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/page/job_line.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/table/cell_table.hpp"
#include "report/loading_curve/loading_curve_plots.hpp"
#include "report/loading_curve/loading_curve_tables.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_curves = 60, amplitudes_listed = 16;

QString status_text(const tasks::LoadingCurveResult& report) {
  QStringList lines;
  if (!report.fits.empty()) {
    const friction::Fit& best = report.fits.front();
    lines << (tasks::some_usable(report) ? LoadingCurvePage::tr("Best law by AIC: %1, %2").arg(q(best.law), q(best.title))
                                         : q(name(best.status)) + ": " + q(best.message));
    for (const std::string& finding : best.findings) lines << q(finding);
  }
  for (const std::string& note : report.data.notes) lines << q(note);
  return lines.join('\n');
}

/// Before anything is fitted; nothing where columns have to be chosen first, or no curve can be read.
report::PlotGroup measured_curves(const tasks::LoadingCurveTask& task) {
  tasks::LoadingCurveResult measured;
  try {
    measured.data = tasks::read_curves(task);
  } catch (const InputError&) {
    return {};
  }
  return report::curves_and_residuals(measured, most_curves);
}

}  // namespace

LoadingCurvePage::LoadingCurvePage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Loading curves"));
  let_drop_files(*this, [this](const QStringList& files) { open(files); });
  line_ = new JobLine("curve", tr("Status of the fits"), tr("Stop and keep the fitted laws"));
  choices_ = new LoadingCurveChoices;
  plots_ = new PlotMenu("curve_plots", tr("Measured and fitted curves"),
                        tr("Drop a measured curve here, or choose it: columns of displacement and force, from rest or in "
                           "cycles,\nor k_e and d_e over amplitude. Fit draws the laws over it, with their residuals below."));
  auto* both = named(new QSplitter(Qt::Vertical), "curves_and_laws", tr("Curves and laws"));
  both->addWidget(plots_);
  both->addWidget(make_tables());
  both->setStretchFactor(0, 1);
  both->setSizes({430, 220});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(choices_);
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect(line_, &JobLine::failed, this, &LoadingCurvePage::failed);
  connect(line_, &JobLine::busy_changed, this, &LoadingCurvePage::show_buttons);
  connect(laws_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) { show_law(index.row()); });
  show_buttons();
}

QWidget* LoadingCurvePage::make_top() {
  auto* top = named(new QWidget, "curve_top", tr("Fitting laws"));
  auto* choose = push_button("curve_files", tr("Files…"), tr("Choose measured curves: text, MATLAB or HDF5 with columns"));
  fit_ = push_button("curve_fit", tr("Fit"), tr("Fit the laws to the curves"));
  command_ = push_button("curve_command", tr("Copy as command"), tr("Copy the command line with the same fit"));
  names_ = named(new QLabel, "curve_names", tr("Files"));
  names_->setTextFormat(Qt::PlainText);
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({choose, fit_, line_->cancel_button(), names_}, {command_}));
  connect(choose, &QPushButton::clicked, this, [this] {
    const QStringList files = choose_files_to_open(this);
    if (!files.isEmpty()) open(files);
  });
  connect(fit_, &QPushButton::clicked, this, &LoadingCurvePage::run);
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  return top;
}

QTabWidget* LoadingCurvePage::make_tables() {
  laws_ = new CellTable("laws", tr("Laws, best by AIC first; a row shows its parameters"));
  laws_->setSelectionBehavior(QAbstractItemView::SelectRows);
  parameters_ = new CellTable("law_parameters", tr("Parameters of the law with intervals"));
  equivalents_ = new CellTable("law_equivalents", tr("k_e and d_e of the law over amplitude"));
  loops_ = new CellTable("loops", tr("Loops one by one"));
  tables_ = named(new QTabWidget, "curve_tables", tr("Laws and numbers"));
  tables_->addTab(laws_, tr("Laws"));
  tables_->addTab(parameters_, tr("Parameters"));
  tables_->addTab(equivalents_, tr("k_e and d_e"));
  tables_->addTab(loops_, tr("Loops"));
  return tables_;
}

bool LoadingCurvePage::is_busy() const { return line_->is_busy(); }

QString LoadingCurvePage::status() const { return line_->status(); }

void LoadingCurvePage::cancel() { line_->cancel(); }

void LoadingCurvePage::show_buttons() {
  fit_->setEnabled(!files_.isEmpty() && !is_busy());
  command_->setEnabled(!files_.isEmpty());
}

/// The columns of the first file are offered.
void LoadingCurvePage::open(const QStringList& files) {
  files_ = files;
  QStringList names;
  for (const QString& file : files_) names << QFileInfo(file).fileName();
  names_->setText(names.join(QStringLiteral(", ")));
  line_->worker().add([this, path = as_path(files_.front()), task = task()](const Worker::Watch&) -> Worker::Deliver {
    QStringList columns;
    for (const frf::NumberColumn& column : frf::read_columns(path).columns) columns << q(column.name);
    return [this, columns, measured = measured_curves(task)] {
      choices_->offer(columns);
      plots_->show_groups({{tr("curve"), measured}});
      line_->say(tr("Columns: %1. Columns that you do not choose are found by name.").arg(columns.join(QStringLiteral(", "))));
    };
  });
  show_buttons();
}

tasks::LoadingCurveTask LoadingCurvePage::task() const {
  tasks::LoadingCurveTask out = choices_->task();
  for (const QString& file : files_) out.files.push_back(as_path(file));
  return out;
}

void LoadingCurvePage::run() {
  if (files_.isEmpty() || is_busy()) return;
  line_->say(tr("Fitting …"));
  line_->worker().add([this, task = task()](const Worker::Watch& watch) -> Worker::Deliver {
    tasks::check(task);
    tasks::FittingWatch fitting;
    fitting.interrupted = watch.interrupted;
    fitting.progress = [&watch](const std::string& stage) { watch.progress(stage.c_str(), 0, 0); };
    fitting.so_far = [this, &watch](const tasks::LoadingCurveResult& report) {
      watch.show([this, shared = std::make_shared<const tasks::LoadingCurveResult>(report)] { show_report(shared); });
    };
    return [this, found = std::make_shared<const tasks::LoadingCurveResult>(tasks::fit_loading_curves(task, fitting))] {
      show_report(found);
      line_->say(status_text(*found), !tasks::some_usable(*found));
    };
  });
}

void LoadingCurvePage::show_report(std::shared_ptr<const tasks::LoadingCurveResult> report) {
  report_ = std::move(report);
  plots_->show_groups({{tr("curve"), report::curves_and_residuals(*report_, most_curves)},
                       {tr("k_e, d_e and energy"), report::equivalents_plots(*report_)},
                       {tr("slip"), report::slip_distribution(*report_)},
                       {tr("loops in sequence"), report::loops_in_turn(*report_)}});
  laws_->show_rows(rows_of(report::laws_table(*report_)));
  loops_->show_rows(rows_of(report::loops_table(*report_)));
  tables_->setTabVisible(tables_->indexOf(loops_), !report_->of_loops.empty());
  show_law(0);
}

void LoadingCurvePage::show_law(int row) {
  if (!report_ || row < 0 || static_cast<std::size_t>(row) >= report_->fits.size()) return;
  const friction::Fit& fit = report_->fits[static_cast<std::size_t>(row)];
  parameters_->show_rows(fit.curves.empty() ? CellRows() : rows_of(report::parameters_table(*report_, fit)));
  equivalents_->show_rows(fit.curves.empty() ? CellRows()
                                             : rows_of(report::equivalents_table(fit.curves.front(), amplitudes_listed)));
  tables_->setTabText(tables_->indexOf(parameters_), tr("Parameters of %1").arg(q(fit.law)));
}

QString LoadingCurvePage::command_line() const { return loading_curve_command(task()); }

}  // namespace jointid::gui
