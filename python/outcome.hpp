#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "frf/set/frf_set.hpp"
#include "ident/result/control.hpp"

namespace jointid::python {

/// What a command found. Texts are made when somebody asks for them, by functions that own all that they use; one that is empty
/// is not to be had of this command.
struct Outcome {
  std::string status;   ///< as in the JSON; empty where the command has none
  std::string message;  ///< why, and what helps; empty when all is well
  bool usable = true;   ///< whether the numbers may be used: the command's exit code 0
  std::function<std::string()> json{}, text{}, csv{};
  std::function<std::string(const ident::Control&)> page{};  ///< may have to read and compute
  std::function<frf::FrfSet(const ident::Control&)> frfs{};  ///< those that were made or predicted, receptances
};

/// The best outcome so far of work that goes on: what is left of it where Ctrl-C ends it.
class SoFar {
 public:
  /// `make` owns all that it uses, and is called where the work is interrupted alone.
  void put(std::function<Outcome()> make) {
    const std::lock_guard lock(mutex_);
    make_ = std::move(make);
  }
  std::optional<Outcome> get() const {
    std::function<Outcome()> make;
    {
      const std::lock_guard lock(mutex_);
      make = make_;
    }
    return make ? std::optional(make()) : std::nullopt;
  }

 private:
  mutable std::mutex mutex_;
  std::function<Outcome()> make_;
};

}  // namespace jointid::python
