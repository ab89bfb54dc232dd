#include "gui/page/later.hpp"

#include <QSignalBlocker>
#include <QTabWidget>

namespace jointid::gui {

void LaterTab::hold_place(QTabWidget& tabs, const QString& title, const QString& hint, const std::function<void()>& seen) {
  tabs_ = &tabs;
  place_ = new QWidget;
  place_->setAccessibleName(hint);
  content_ = place_;
  tabs.addTab(place_, title);
  tabs.setTabToolTip(tabs.count() - 1, hint);
  QObject::connect(&tabs, &QTabWidget::currentChanged, place_, [this, seen] {
    if (tabs_->currentWidget() == place_) seen();
  });
}

void LaterTab::put(QWidget& page) {
  const int at = tabs_->indexOf(place_);
  const bool is_in_front = tabs_->currentIndex() == at;
  const QSignalBlocker quiet(tabs_);
  tabs_->insertTab(at, &page, tabs_->tabText(at));
  tabs_->setTabToolTip(at, tabs_->tabToolTip(at + 1));
  tabs_->setTabVisible(at, tabs_->isTabVisible(at + 1));
  if (is_in_front) tabs_->setCurrentIndex(at);
  tabs_->removeTab(at + 1);
  place_->deleteLater();
  content_ = &page;
}

void LaterTab::set_tab_visible(bool on) {
  const int at = tabs_->indexOf(content_);
  tabs_->setTabVisible(at, on || at == tabs_->currentIndex());
}

}  // namespace jointid::gui
