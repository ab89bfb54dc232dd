#pragma once

#include <functional>

namespace jointid {

/// Lets loops far below a caller end early: while one is alive, stop_point() of this thread asks its function. Other threads do not
/// ask, unless whoever begins them hands them current(). Commands that hand an interruption through their arguments
/// (Control::interrupted) keep what they have so far; this is for the work between two of their looks.
class StopScope {
 public:
  using Ask = std::function<bool()>;

  /// `interrupted` outlives this; any thread calls it. Null: nobody asks.
  explicit StopScope(const Ask* interrupted) noexcept;
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  /// Of this thread; null where there is none.
  static const Ask* current() noexcept;

 private:
  const Ask* before_;
};

/// Throws Interrupted where the caller of this thread asks to end. Some nanoseconds.
void stop_point();

}  // namespace jointid
