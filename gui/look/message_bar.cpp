#include "gui/look/message_bar.hpp"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include "gui/look/named.hpp"
#include "gui/look/status_label.hpp"

namespace jointid::gui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  named(this, "message_bar", tr("Message"));
  setFrameShape(QFrame::StyledPanel);
  label_ = named(new StatusLabel, "message", tr("Message"));
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  action_ = named(new QPushButton, "message_action", tr("Action that the message offers"));
  auto* close = named(new QToolButton, "message_close", tr("Close the message"));
  close->setText(QStringLiteral("×"));
  close->setAutoRaise(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  row->addWidget(label_, 1);
  row->addWidget(action_);
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  connect(action_, &QPushButton::clicked, this, [this] {
    hide();
    if (act_) act_();
  });
  hide();
}

QString MessageBar::text() const { return isHidden() ? QString() : label_->text(); }

void MessageBar::say(const QString& text) {
  action_->hide();
  show_text(text, false);
}

void MessageBar::warn(const QString& text) {
  action_->hide();
  show_text(text, true);
}

void MessageBar::ask(const QString& text, const QString& action, std::function<void()> act) {
  show_action(action, std::move(act));
  show_text(text, true);
}

void MessageBar::offer(const QString& text, const QString& action, std::function<void()> act) {
  show_action(action, std::move(act));
  show_text(text, false);
}

void MessageBar::show_action(const QString& action, std::function<void()> act) {
  act_ = std::move(act);
  action_->setText(action);
  action_->show();
}

void MessageBar::show_text(const QString& text, bool bad) {
  label_->set_bad(bad);
  label_->setText(text);
  show();
  QAccessibleEvent event(label_, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

}  // namespace jointid::gui
