#pragma once

#include <QPointer>
#include <QString>
#include <QWidget>
#include <functional>
#include <utility>

class QTabWidget;

namespace jointid::gui {

/// An empty tab until its page is made.
class LaterTab {
 public:
  /// Whether the tab is seen; the one in front always is.
  void set_tab_visible(bool on);

 protected:
  void hold_place(QTabWidget& tabs, const QString& title, const QString& hint, const std::function<void()>& seen);
  /// The page in place of the empty tab.
  void put(QWidget& page);

 private:
  QTabWidget* tabs_ = nullptr;
  QPointer<QWidget> place_;
  QWidget* content_ = nullptr;  ///< the empty tab or the page
};

/// A page that is made when its tab is first seen, or when it is asked for: opening a scene does not wait for pages that nobody looks at.
template <class Page>
class Later : public LaterTab {
 public:
  /// `make`: the page with its connections; `tell`: what it is to know of the scene, again with every change of it.
  void place(QTabWidget& tabs, const QString& title, const QString& hint, std::function<Page*()> make,
             std::function<void(Page&)> tell) {
    tell_ = std::move(tell);
    make_ = [this, make = std::move(make)] {
      page_ = make();
      put(*page_);
      tell_(*page_);
    };
    hold_place(tabs, title, hint, [this] { get(); });
  }
  Page* get() {
    if (page_ == nullptr) make_();
    return page_;
  }
  /// Null before the page is made.
  Page* made() const { return page_; }
  void tell() {
    if (page_ != nullptr) tell_(*page_);
  }

 private:
  std::function<void()> make_;
  std::function<void(Page&)> tell_;
  Page* page_ = nullptr;
};

}  // namespace jointid::gui
