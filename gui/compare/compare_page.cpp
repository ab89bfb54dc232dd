#include "gui/compare/compare_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QItemSelectionModel>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/compare/compare_choices.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/page/job_line.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"
#include "report/result/comparison_plots.hpp"
#include "report/result/comparison_tables.hpp"
#include "report/text/words.hpp"

namespace jointid::gui {

ComparePage::ComparePage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Compare"));
  line_ = new JobLine("compare", tr("Status of the comparison"), tr("Stop and keep the finished ways"));
  line_->set_cancelled_text(tr("Cancelled: no way was finished."));
  choices_ = new CompareChoices;
  chart_ = new Chart("error_against_time", tr("Error against run time"),
                     tr("Choose what to compare, then press Compare. The diagram shows the error and the run time of every "
                        "way.\nThe scene needs [truth] and [noise]. A click on a point opens that solution."));
  table_ = new CellTable("ways", tr("Ways, by their error and run time"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  auto* both = named(new QSplitter(Qt::Vertical), "chart_and_ways", tr("Diagram and table"));
  both->addWidget(chart_);
  both->addWidget(table_);
  both->setStretchFactor(0, 1);
  both->setSizes({420, 240});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(choices_);
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect(line_, &JobLine::failed, this, &ComparePage::failed);
  connect(line_, &JobLine::busy_changed, this, [this](bool busy) { run_->setEnabled(!busy && scene_.has_value()); });
  connect(chart_, &Chart::chosen, this, [this](std::size_t group, std::size_t point) {
    if (const auto found = combination_at(group, point)) table_->selectRow(static_cast<int>(*found));
  });
  connect(chart_, &Chart::opened, this, &ComparePage::open_point);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) { choose_row(index.row()); });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    Q_EMIT way_opened(comparison_.combinations[static_cast<std::size_t>(index.row())].way);
  });
  set_scene({});
}

QWidget* ComparePage::make_top() {
  auto* top = named(new QWidget, "compare_top", tr("Comparing"));
  run_ = push_button("compare", tr("Compare"), tr("Compare all ways on the same trials with simulated noise"));
  trials_ = number_box("compare_trials", tr("trials"), 1, 200);
  seed_ = number_box("compare_seed", tr("seed"), 0, 1);
  matrix_choice_ = named(new QComboBox, "compare_matrix", tr("Matrix whose error is shown"));
  matrix_choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* command = push_button("compare_command", tr("Copy as command"),
                              tr("Copy the command line that compares the same ways on the same trials"));
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({run_, line_->cancel_button(), trials_, seed_}, {command}));
  rows->addLayout(row_of({matrix_choice_}, {}));
  connect(run_, &QPushButton::clicked, this, &ComparePage::run);
  connect(command, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(matrix_choice_, &QComboBox::activated, this, &ComparePage::show_matrix);
  return top;
}

bool ComparePage::is_busy() const { return line_->is_busy(); }

QString ComparePage::status() const { return line_->status(); }

void ComparePage::set_scene(std::optional<ident::Scene> scene) {
  scene_ = std::move(scene);
  run_->setEnabled(scene_.has_value() && !is_busy());
}

void ComparePage::run() {
  if (!scene_ || is_busy()) return;
  ComparisonWish wish{*scene_, choices_->alternatives(), static_cast<std::size_t>(trials_->value()),
                      static_cast<std::uint64_t>(seed_->value())};
  line_->say(tr("Comparing …"));
  line_->worker().add([this, wish](const Worker::Watch& watch) -> Worker::Deliver {
    const auto so_far = [&](const study::Comparison& comparison) {
      watch.show([this, comparison] { show_comparison(comparison); });
    };
    return [this, comparison = run_comparison(wish, watch, so_far)] {
      show_comparison(comparison);
      const int ways = static_cast<int>(comparison.combinations.size());
      QString text = comparison.interrupted ? tr("Cancelled: %n finished way(s).", nullptr, ways)
                                            : tr("%n way(s) on the same trials.", nullptr, ways);
      for (const std::string& line : report::left_out_lines(comparison.left_out)) {
        text += "\n" + tr("left out: ") + QString::fromStdString(line);
      }
      line_->say(text, comparison.interrupted);
    };
  });
}

void ComparePage::cancel() { line_->cancel(); }

void ComparePage::show_comparison(const study::Comparison& comparison) {
  comparison_ = comparison;
  const int before = matrix_choice_->currentIndex();
  matrix_choice_->clear();
  for (const auto& matrix : comparison_.combinations.front().matrices) {
    matrix_choice_->addItem(QString::fromStdString(report::words(restrictions::key(matrix.kind))));
  }
  matrix_choice_->setCurrentIndex(before >= 0 && before < matrix_choice_->count() ? before : 0);
  show_matrix();
}

std::size_t ComparePage::matrix() const { return static_cast<std::size_t>(std::max(0, matrix_choice_->currentIndex())); }

void ComparePage::show_matrix() {
  if (comparison_.combinations.empty()) return;
  chart_->draw(report::error_against_time(comparison_.combinations, matrix()));
  table_->show_rows(rows_of(report::figures_table(comparison_.combinations, matrix())));
}

std::optional<std::size_t> ComparePage::combination_at(std::size_t group, std::size_t point) const {
  const report::Point& at = chart_->scatter().groups[group].points[point];
  for (std::size_t i = 0; i < comparison_.combinations.size(); ++i) {
    const study::Combination& each = comparison_.combinations[i];
    if (report::point_of(each, matrix()) == std::pair(at.x, at.y)) return i;
  }
  return std::nullopt;
}

void ComparePage::choose_row(int row) {
  if (row < 0 || static_cast<std::size_t>(row) >= comparison_.combinations.size()) return;
  const auto& groups = chart_->scatter().groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t p = 0; p < groups[g].points.size(); ++p) {
      if (combination_at(g, p) == static_cast<std::size_t>(row)) return chart_->choose(g, p);
    }
  }
}

void ComparePage::open_point(std::size_t group, std::size_t point) {
  if (const auto found = combination_at(group, point)) Q_EMIT way_opened(comparison_.combinations[*found].way);
}

QString ComparePage::command_line() const {
  return QStringLiteral("jointid compare %1 --trials %2 --seed %3%4")
      .arg(shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_))
      .arg(trials_->value())
      .arg(seed_->value())
      .arg(choices_->options());
}

}  // namespace jointid::gui
