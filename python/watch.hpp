#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "ident/result/control.hpp"
#include "python/outcome.hpp"

namespace jointid::python {

/// Does `work` on a thread of its own while the calling one, which has the interpreter's lock, lets other Python threads run,
/// looks for Ctrl-C every 20 ms and calls progress(stage, done, total) unless it is None, at most every 100 ms. What Ctrl-C or
/// `progress` raise ends the work, through Control::interrupted, and is thrown here, 1.5 s later at most: work that does not end
/// by then goes on by itself, so that it must own all that it uses. What the work throws is thrown here. `partial(ended)` is called
/// where a KeyboardInterrupt is thrown, which gets what it returns as its attribute `partial`; `ended`: the work did.
using Partial = std::function<pybind11::object(bool ended)>;
void run_watched(const pybind11::object& progress, std::function<void(const ident::Control&)> work, const Partial& partial = {});

/// The same of work that has a result. Of an outcome what there is so far is kept.
template <class Work>
auto watched(const pybind11::object& progress, std::size_t threads, Work work) {
  constexpr bool keeps = std::is_invocable_v<Work, const ident::Control&, SoFar&>;
  const auto so_far = std::make_shared<SoFar>();
  const auto run = [work = std::move(work), so_far](const ident::Control& control) {
    if constexpr (keeps) return work(control, *so_far);
    else return work(control);
  };
  using Result = decltype(run(std::declval<const ident::Control&>()));
  const auto result = std::make_shared<std::optional<Result>>();
  Partial partial;
  if constexpr (std::is_same_v<Result, Outcome>) {
    partial = [result, so_far](bool ended) -> pybind11::object {
      if (ended && *result) return pybind11::cast(std::move(**result));
      auto kept = so_far->get();
      return kept ? pybind11::cast(std::move(*kept)) : pybind11::none();
    };
  }
  run_watched(
      progress,
      [result, threads, run](const ident::Control& control) {
        ident::Control own = control;
        own.threads = threads;
        result->emplace(run(own));
      },
      partial);
  return std::move(**result);
}

/// Whether `interrupted` has said so for that long: of work that may go on a little to save what it has.
std::function<bool()> lasting(std::function<bool()> interrupted, std::chrono::milliseconds time);

/// How many runs go on that were left to themselves.
int runs_left() noexcept;

}  // namespace jointid::python
