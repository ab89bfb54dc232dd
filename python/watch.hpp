#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "ident/result/control.hpp"

namespace jointid::python {

/// Does `work` on a thread of its own while the calling one, which has the interpreter's lock, lets other Python threads run,
/// looks for Ctrl-C every 20 ms and calls progress(stage, done, total) unless it is None, at most every 100 ms. What Ctrl-C or
/// `progress` raise ends the work, through Control::interrupted, and is thrown here, 1.5 s later at most: work that does not end
/// by then goes on by itself, so that it must own all that it uses. What the work throws is thrown here.
void run_watched(const pybind11::object& progress, std::function<void(const ident::Control&)> work);

/// The same of work that has a result.
template <class Work>
auto watched(const pybind11::object& progress, std::size_t threads, Work work) {
  using Result = decltype(work(std::declval<const ident::Control&>()));
  auto result = std::make_shared<std::optional<Result>>();
  run_watched(progress, [result, threads, work = std::move(work)](const ident::Control& control) {
    ident::Control own = control;
    own.threads = threads;
    result->emplace(work(own));
  });
  return std::move(**result);
}

/// How many runs go on that were left to themselves.
int runs_left() noexcept;

}  // namespace jointid::python
