#include "gui/forms/choice_row.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <string>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"

namespace jointid::gui {
namespace {

constexpr int letters_of_choice = 8;  // the choice grows with the form

}  // namespace

ChoiceRow::ChoiceRow(const char* name, const QString& title, bool with_buttons, QWidget* parent) : QWidget(parent) {
  choice_ = named(new QComboBox, name, title);
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(letters_of_choice);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(choice_, 1);
  connect(choice_, &QComboBox::activated, this, &ChoiceRow::changed);
  if (with_buttons) {
    add_ = push_button((std::string(name) + "_add").c_str(), tr("Add"), tr("Add another one to the text"));
    remove_ = push_button((std::string(name) + "_remove").c_str(), tr("Remove"), tr("Remove this one from the text; undo brings it back"));
    row->addWidget(add_);
    row->addWidget(remove_);
    connect(add_, &QPushButton::clicked, this, &ChoiceRow::more_wanted);
    connect(remove_, &QPushButton::clicked, this, &ChoiceRow::fewer_wanted);
  }
}

void ChoiceRow::show_names(const QStringList& names, int fewest) {
  const QSignalBlocker quiet(choice_);
  const int before = choice_->currentIndex();
  choice_->clear();
  choice_->addItems(names);
  choice_->setCurrentIndex(names.isEmpty() ? -1 : std::clamp(before, 0, static_cast<int>(names.size()) - 1));
  if (remove_ != nullptr) remove_->setEnabled(names.size() > fewest);
}

void ChoiceRow::choose(int number) { choice_->setCurrentIndex(number); }

int ChoiceRow::chosen() const { return choice_->currentIndex(); }

QString ChoiceRow::chosen_name() const { return choice_->currentText(); }

}  // namespace jointid::gui
