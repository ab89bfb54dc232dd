#include "gui/look/choice_button.hpp"

#include <QMenu>

#include "gui/look/named.hpp"

namespace jointid::gui {

ChoiceButton::ChoiceButton(const char* name, const QString& title, const QStringList& words, QWidget* parent)
    : ChoiceButton(name, title, words, tr("as in the scene"), tr("Choices to compare. None: as in the scene"), parent) {}

ChoiceButton::ChoiceButton(const char* name, const QString& title, const QStringList& words, const QString& none,
                           const QString& hint, QWidget* parent)
    : QToolButton(parent), title_(title), none_(none) {
  named(this, name, title, hint);
  setFocusPolicy(Qt::StrongFocus);
  setPopupMode(QToolButton::InstantPopup);
  setMenu(named(new QMenu(this), "choices", title));
  set_words(words);
}

void ChoiceButton::set_words(const QStringList& words) {
  const QStringList before = chosen();
  menu()->clear();  // and the actions, which it owns
  actions_.clear();
  for (const QString& word : words) {
    QAction* const action = menu()->addAction(word);
    action->setCheckable(true);
    action->setChecked(before.contains(word));
    actions_ << action;
    connect(action, &QAction::toggled, this, &ChoiceButton::show_choice);
  }
  show_choice();
}

QStringList ChoiceButton::chosen() const {
  QStringList words;
  for (const QAction* action : actions_) {
    if (action->isChecked()) words << action->text();
  }
  return words;
}

void ChoiceButton::choose(const QStringList& words) {
  for (QAction* action : actions_) action->setChecked(words.contains(action->text()));
}

void ChoiceButton::show_choice() {
  const QStringList words = chosen();
  setText(title_ + ": " + (words.isEmpty() ? none_ : words.join(QStringLiteral(", "))));
}

}  // namespace jointid::gui
