#pragma once

#include "gui/work/worker.hpp"
#include "ident/result/control.hpp"

namespace jointid::gui {

/// A worker's watch as the library knows it.
inline ident::Control control_of(const Worker::Watch& watch) {
  ident::Control control;
  control.interrupted = watch.interrupted;
  control.progress = watch.progress;
  return control;
}

}  // namespace jointid::gui
