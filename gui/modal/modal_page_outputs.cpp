#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/page/job_line.hpp"

/// What leaves the page: command line and files.
namespace jointid::gui {

QString ModalPage::command_line() const {
  if (structure() == nullptr) return {};
  modalfit::FitOptions wanted = sought_ ? used_ : options();
  wanted.poles = picked_.now();
  return modal_command(sought_ ? of_run_ : *structure(), wanted);
}

void ModalPage::write(const QString& file, const std::function<void(const std::filesystem::path&)>& to) {
  if (!run_) return line_->say(tr("No modes are found yet."), true);
  try {
    check_output(file, inputs_of(structures_));
    to(as_path(file));
    line_->say(tr("Written to %1.").arg(file));
  } catch (const InputError& error) {
    line_->say(QString::fromUtf8(error.what()), true);
  }
}

void ModalPage::write_shapes(const QString& file) {
  write(file, [this](const std::filesystem::path& path) { tasks::write_shapes(*run_, path); });
}

void ModalPage::write_regenerated(const QString& file) {
  write(file, [this](const std::filesystem::path& path) { tasks::write_regenerated(*run_, path); });
}

}  // namespace jointid::gui
