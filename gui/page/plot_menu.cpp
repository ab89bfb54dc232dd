#include "gui/page/plot_menu.hpp"

#include <QComboBox>
#include <QStackedWidget>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/plot/chart.hpp"

namespace jointid::gui {
namespace {

/// Curves below each other are one drawing, histograms beside each other one, points are drawings of their own.
std::vector<std::pair<QString, PlotMenu::Drawing>> drawings_of(const report::Choice& choice) {
  std::vector<report::CurvePlot> curves;
  std::vector<report::HistogramPlot> histograms;
  std::vector<std::pair<QString, PlotMenu::Drawing>> out;
  for (const report::Plot& plot : choice.plots) {
    if (const auto* curve = std::get_if<report::CurvePlot>(&plot)) curves.push_back(*curve);
    if (const auto* counts = std::get_if<report::HistogramPlot>(&plot)) histograms.push_back(*counts);
  }
  if (!curves.empty()) out.emplace_back(QString(), curves);
  if (!histograms.empty()) out.emplace_back(QString(), histograms);
  for (const report::Plot& plot : choice.plots) {
    const auto* points = std::get_if<report::ScatterPlot>(&plot);
    if (points != nullptr) out.emplace_back(choice.plots.size() > 1 ? q(points->title) : QString(), *points);
  }
  return out;
}

QString joined(const QStringList& names) {
  QStringList all = names;
  all.removeAll(QString());
  return all.join(QStringLiteral(": "));
}

}  // namespace

PlotMenu::PlotMenu(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent) : QWidget(parent) {
  setAccessibleName(accessible_name);
  menu_ = named(new QComboBox, (std::string(name) + "_menu").c_str(), tr("What is drawn"));
  menu_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  chart_ = new Chart(name, accessible_name, hint);
  chart_->let_zoom();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row_of({menu_}, {}));
  map_ = new HeatChart((std::string(name) + "_map").c_str(), accessible_name, hint);
  drawn_ = named(new QStackedWidget, (std::string(name) + "_drawn").c_str(), accessible_name);
  drawn_->addWidget(chart_);
  drawn_->addWidget(map_);
  column->addWidget(drawn_, 1);
  connect(menu_, &QComboBox::currentIndexChanged, this, &PlotMenu::show_choice);
  show_choice();
}

void PlotMenu::show_groups(const std::vector<Named>& groups, const std::vector<NamedMap>& maps) {
  const QString before = menu_->currentText();
  const QSignalBlocker quiet(menu_);
  menu_->clear();
  choices_.clear();
  for (const auto& [name, group] : groups) {
    for (const report::Choice& choice : group.choices) {
      for (auto& [title, drawing] : drawings_of(choice)) {
        menu_->addItem(joined({name, q(choice.name), title}));
        choices_.push_back(std::move(drawing));
      }
    }
  }
  for (const auto& [name, map] : maps) {
    menu_->addItem(name);
    choices_.emplace_back(map);
  }
  menu_->setCurrentIndex(choices_.empty() ? -1 : std::max(0, menu_->findText(before)));
  show_choice();
}

void PlotMenu::show_choice() {
  const int chosen = menu_->currentIndex();
  menu_->setVisible(menu_->count() > 0);
  const Drawing* const choice = chosen < 0 ? nullptr : &choices_[static_cast<std::size_t>(chosen)];
  const auto* const map = choice == nullptr ? nullptr : std::get_if<HeatPlot>(choice);
  drawn_->setCurrentIndex(map != nullptr ? 1 : 0);
  if (choice == nullptr) return chart_->clear();
  const auto draw = [this](const auto& drawing) {
    if constexpr (std::is_same_v<std::decay_t<decltype(drawing)>, HeatPlot>)
      map_->draw(drawing);
    else
      chart_->draw(drawing);
  };
  std::visit(draw, *choice);
}

}  // namespace jointid::gui
