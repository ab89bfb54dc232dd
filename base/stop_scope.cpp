#include "base/stop_scope.hpp"

#include "base/control.hpp"

namespace jointid {
namespace {

thread_local const StopScope::Ask* asked = nullptr;

}  // namespace

StopScope::StopScope(const Ask* interrupted) noexcept : before_(asked) { asked = interrupted; }

StopScope::~StopScope() { asked = before_; }

const StopScope::Ask* StopScope::current() noexcept { return asked; }

void stop_point() {
  if (asked != nullptr) stop_if(*asked);
}

}  // namespace jointid
