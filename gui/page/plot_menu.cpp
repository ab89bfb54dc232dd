#include "gui/page/plot_menu.hpp"

#include <QComboBox>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/plot/chart.hpp"

namespace jointid::gui {
namespace {

std::vector<report::CurvePlot> curve_plots(const report::Choice& choice) {
  std::vector<report::CurvePlot> out;
  for (const report::Plot& plot : choice.plots) {
    if (const auto* curves = std::get_if<report::CurvePlot>(&plot)) out.push_back(*curves);
  }
  return out;
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
  column->addWidget(chart_, 1);
  connect(menu_, &QComboBox::currentIndexChanged, this, &PlotMenu::show_choice);
}

void PlotMenu::show_groups(std::vector<Named> groups) {
  const QString before = menu_->currentText();
  const QSignalBlocker quiet(menu_);
  menu_->clear();
  choices_.clear();
  for (auto& [name, group] : groups) {
    for (report::Choice& choice : group.choices) {
      const bool alone = choice.name.empty();
      menu_->addItem(alone ? name : name.isEmpty() ? q(choice.name) : name + ": " + q(choice.name));
      choices_.push_back(std::move(choice));
    }
  }
  menu_->setCurrentIndex(choices_.empty() ? -1 : std::max(0, menu_->findText(before)));
  show_choice();
}

void PlotMenu::show_choice() {
  const int chosen = menu_->currentIndex();
  if (chosen < 0) return chart_->clear();
  chart_->draw(curve_plots(choices_[static_cast<std::size_t>(chosen)]));
}

}  // namespace jointid::gui
