#include "gui/data/data_page.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "base/control.hpp"
#include "gui/data/data_words.hpp"
#include "gui/data/frf_grid_model.hpp"
#include "gui/look/named.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/plot/indicators.hpp"
#include "gui/scene/scene_edit.hpp"
#include "gui/work/worker.hpp"
#include "ident/scene/scene_files.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_curves = 40;
constexpr std::size_t most_values = std::size_t{4} << 20;  ///< of FRFs that are read for sums: 64 MB
constexpr int file_role = Qt::UserRole;

/// Where a file has the FRF of a curve, or nothing.
std::optional<std::pair<std::size_t, std::size_t>> entry_in(const LoadedFile& file, const frf::Dof& response,
                                                            const frf::Dof& reference) {
  const std::size_t r = frf::find_coordinate(file.header.response, response),
                    c = frf::find_coordinate(file.header.reference, reference);
  if (r == frf::npos || c == frf::npos) return std::nullopt;
  return std::pair(r, c);
}

struct Wanted {
  std::size_t file, response, reference;
};

}  // namespace

DataPage::DataPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Data"));
  plot_ = new FrfPlot(tr("Choose FRFs in the grid: click, drag, Ctrl+click, or whole rows and columns by their names."));
  plot_->let_exclude();
  for (const View view : {View::sum, View::cmif}) plot_->offer(view);
  worker_ = new Worker(this);
  add_left();
  connect(worker_, &Worker::failed, this, [this](const InputError& error) { about_->setText(QString::fromUtf8(error.what())); });
  connect(plot_, &FrfPlot::band_chosen, this, &DataPage::exclude);
  connect(plot_, &FrfPlot::band_unwanted, this, &DataPage::include);
  connect(plot_, &FrfPlot::next_wanted, this, &DataPage::choose_next);
  connect(plot_, &FrfPlot::view_changed, this, [this] {
    if (is_indicator(plot_->view()) || is_indicator(read_for_)) read_curves();
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &DataPage::show_file);
  connect(everywhere_, &QCheckBox::toggled, this, &DataPage::read_curves);
  connect(figure_, &QComboBox::currentIndexChanged, this,
          [this] { model_->set_figure(static_cast<GridFigure>(figure_->currentData().toInt())); });
}

void DataPage::add_left() {
  tree_ = named(new QTreeWidget, "files", tr("Files"), tr("Files of the scene"));
  tree_->setHeaderHidden(true);
  about_ = named(new QLabel, "about_file", tr("About the file"));
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::PlainText);
  figure_ = named(new QComboBox, "grid_figure", tr("Colour by"), tr("Quantity that colours the cells"));
  figure_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  everywhere_ = named(new QCheckBox(tr("in all files")), "everywhere", tr("Draw the chosen FRFs of all files that have them"),
                      tr("Draw the chosen FRFs of all files that have them, one over the other"));
  auto* joint = named(new QPushButton(tr("Rows are the joint")), "use_as_joint", tr("Take the chosen rows as joint DOFs"),
                      tr("Write the DOFs of the chosen rows into [joint] dofs"));
  model_ = new FrfGridModel(this);
  table_ = named(new QTableView, "grid", tr("FRFs of the file: responses down, references across"));
  table_->setModel(model_);
  table_->setTabKeyNavigation(false);
  table_->horizontalHeader()->setDefaultSectionSize(62);
  table_->verticalHeader()->setDefaultSectionSize(22);
  model_->set_theme(theme_of(palette()));
  auto* row = new QHBoxLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{figure_, everywhere_, joint}) row->addWidget(each);
  row->addStretch(1);
  auto* lower = new QWidget;
  auto* column = new QVBoxLayout(lower);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(about_);
  column->addLayout(row);
  column->addWidget(table_, 1);
  auto* left = named(new QSplitter(Qt::Horizontal), "files_and_grid", tr("Files and grid"));
  left->addWidget(tree_);
  left->addWidget(lower);
  left->setStretchFactor(1, 1);
  left->setSizes({190, 600});
  auto* both = named(new QSplitter(Qt::Vertical), "grid_and_plot", tr("Files and plot"));
  both->addWidget(left);
  both->addWidget(plot_);
  both->setStretchFactor(1, 1);
  both->setSizes({300, 460});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(both);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &DataPage::read_curves);
  connect(joint, &QPushButton::clicked, this, &DataPage::use_as_joint);
}

bool DataPage::is_busy() const { return worker_->is_busy(); }

void DataPage::set_scene(const ident::Scene& scene, const std::string& signature) {
  scene_ = scene;
  plot_->set_bands(scene.frequency.exclude_hz, scene.frequency.range_hz);
  std::vector<frf::Dof> joint;
  for (const auto& each : scene.joints) joint.insert(joint.end(), each.dofs.begin(), each.dofs.end());
  model_->set_joint(joint);
  std::vector<std::filesystem::path> inputs;
  for (const auto& file : ident::files_of(scene)) inputs.push_back(file.path);
  plot_->protect(std::move(inputs));
  if (signature == signature_) return;
  signature_ = signature;
  worker_->cancel();
  worker_->add([this, data = scene.data](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, files = open_files(data, watch.interrupted)]() mutable {
      files_ = std::move(files);
      show_files();
      Q_EMIT files_opened();
    };
  });
}

void DataPage::show_files() {
  const std::size_t before = chosen_;
  tree_->clear();
  model_->clear();
  plot_->set_curves({});
  QTreeWidgetItem* const groups[] = {new QTreeWidgetItem(tree_, {tr("substructures")}),
                                     new QTreeWidgetItem(tree_, {tr("assembly")})};
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const LoadedFile& file = files_[i];
    auto* item = new QTreeWidgetItem(groups[file.is_assembly ? 1 : 0], {QString::fromStdString(file.name)});
    item->setData(0, file_role, static_cast<qulonglong>(i));
    item->setToolTip(0, QString::fromStdString(file.error));
  }
  for (QTreeWidgetItem* group : groups) group->setFlags(Qt::ItemIsEnabled);
  colour_files();
  tree_->expandAll();
  if (!files_.empty()) choose_file(before < files_.size() ? before : 0);
}

/// Those that cannot be read, in the colour of errors.
void DataPage::colour_files() {
  for (QTreeWidgetItemIterator item(tree_); *item != nullptr; ++item) {
    const QVariant number = (*item)->data(0, file_role);
    if (number.isValid() && !files_[number.toULongLong()].error.empty())
      (*item)->setForeground(0, colours(theme_of(palette())).error);
  }
}

void DataPage::choose_file(std::size_t file) {
  for (QTreeWidgetItemIterator item(tree_); *item != nullptr; ++item) {
    const QVariant number = (*item)->data(0, file_role);
    if (number.isValid() && number.toULongLong() == file) tree_->setCurrentItem(*item);
  }
}

void DataPage::show_file() {
  const QTreeWidgetItem* const item = tree_->currentItem();
  if (item == nullptr || !item->data(0, file_role).isValid()) return;
  chosen_ = item->data(0, file_role).toULongLong();
  const LoadedFile& file = files_[chosen_];
  model_->clear();
  if (!file.error.empty()) return about_->setText(QString::fromStdString(file.error));
  about_->setText(about(file.header));
  model_->set_file(file.header);
  // An FRF is read before the figures, for which all of them are: seconds for gigabytes of text.
  table_->selectionModel()->select(model_->index(0, 0), QItemSelectionModel::ClearAndSelect);
  worker_->add([this, file, chosen = chosen_](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, chosen, figures = figures_of(file, watch.interrupted)] { show_figures(chosen, figures); };
  });
}

void DataPage::show_figures(std::size_t file, std::vector<EntryFigures> figures) {
  if (file != chosen_ || file >= files_.size()) return;
  model_->set_figures(std::move(figures));
  const QVariant before = figure_->currentData();
  figure_->clear();
  for (const GridFigure figure : model_->known_figures()) figure_->addItem(text_of(figure), static_cast<int>(figure));
  figure_->setCurrentIndex(std::max(0, figure_->findData(before)));
}

void DataPage::choose_frfs(const std::vector<std::pair<int, int>>& entries) {
  QItemSelection selection;
  for (const auto& [row, column] : entries) selection.select(model_->index(row, column), model_->index(row, column));
  table_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

/// FRFs to read: all that are drawn, or as many as memory allows where they are summed.
std::size_t DataPage::most_wanted() const {
  if (!is_indicator(plot_->view())) return most_curves;
  return std::max(most_curves, most_values / std::max<std::size_t>(1, files_[chosen_].header.lines()));
}

void DataPage::read_curves() {
  std::vector<Wanted> wanted;
  for (const QModelIndex& index : table_->selectionModel()->selectedIndexes()) {
    const auto r = static_cast<std::size_t>(index.row()), c = static_cast<std::size_t>(index.column());
    wanted.push_back({chosen_, r, c});
    const frf::FrfHeader& own = files_[chosen_].header;
    for (std::size_t file = 0; file < files_.size() && everywhere_->isChecked(); ++file) {
      if (file == chosen_ || !files_[file].error.empty()) continue;
      if (const auto entry = entry_in(files_[file], own.response[r], own.reference[c]))
        wanted.push_back({file, entry->first, entry->second});
    }
    if (wanted.size() >= most_wanted()) break;
  }
  const std::size_t number = ++wanted_;
  read_for_ = plot_->view();
  worker_->add([this, wanted, number, view = read_for_, files = files_](const Worker::Watch& watch) -> Worker::Deliver {
    std::vector<Curve> curves;
    for (const Wanted& each : wanted) {
      stop_if(watch.interrupted);
      curves.push_back(read_curve(files[each.file], each.response, each.reference));
    }
    return [this, number, drawn = indicators(std::move(curves), view, watch.interrupted)] {
      if (number == wanted_) plot_->set_curves(drawn);
    };
  });
}

void DataPage::exclude(double low_hz, double high_hz) {
  Q_EMIT edit_wanted("frequency", "exclude", written(with_range(scene_.frequency.exclude_hz, {low_hz, high_hz})));
}

void DataPage::include(double low_hz, double high_hz) {
  std::vector<ident::Range> left = scene_.frequency.exclude_hz;
  std::erase(left, ident::Range{low_hz, high_hz});
  Q_EMIT edit_wanted("frequency", "exclude", left.empty() ? std::string() : written(left));
}

/// Row by row, as the grid has them; from the last chosen FRF.
void DataPage::choose_next(int step) {
  const QModelIndexList chosen = table_->selectionModel()->selectedIndexes();
  const int columns = model_->columnCount({}), all = columns * model_->rowCount({});
  if (all == 0) return;
  const int now = chosen.isEmpty() ? (step > 0 ? -1 : all) : chosen.back().row() * columns + chosen.back().column();
  const int next = std::clamp(now + step, 0, all - 1);
  choose_frfs({{next / columns, next % columns}});
  table_->scrollTo(model_->index(next / columns, next % columns));
}

void DataPage::use_as_joint() {
  std::vector<int> rows;
  for (const QModelIndex& index : table_->selectionModel()->selectedIndexes()) rows.push_back(index.row());
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<frf::Dof> dofs;
  for (const int row : rows) dofs.push_back(model_->header().response[static_cast<std::size_t>(row)]);
  if (!dofs.empty()) Q_EMIT edit_wanted("joint", "dofs", written(dofs));
}

void DataPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || model_ == nullptr) return;
  model_->set_theme(theme_of(palette()));
  colour_files();
}

}  // namespace jointid::gui
