#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <memory>

#include "gui/look/theme.hpp"

namespace jointid::gui {
namespace {

/// The one QApplication of the tests, without a screen unless one is asked for, and with settings of its own.
class Application : public testing::Environment {
 public:
  void SetUp() override {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    QApplication::setOrganizationName(QStringLiteral("jointid"));
    QApplication::setApplicationName(QStringLiteral("jointid-workbench-test"));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // those of a desktop take no keys of a test
    application_ = std::make_unique<QApplication>(count_, arguments_);
    apply(Theme::light, *application_);
  }
  void TearDown() override { application_.reset(); }

 private:
  int count_ = 1;
  char name_[9] = "test_gui";
  char* arguments_[2] = {name_, nullptr};
  QTemporaryDir settings_;
  std::unique_ptr<QApplication> application_;
};

const testing::Environment* const application = testing::AddGlobalTestEnvironment(new Application);

}  // namespace
}  // namespace jointid::gui
