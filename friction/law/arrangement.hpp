#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "friction/law/law.hpp"
#include "friction/path/assembly.hpp"

namespace jointid::friction {

/// Laws side by side or one behind the other under one name: "parallel:ren:spring", "series:bilinear:ren".
struct ArrangementName {
  bool series = false;
  std::vector<std::string> parts;
};

/// Whether a name begins as an arrangement does.
bool is_arrangement(std::string_view name);

/// Throws InputError unless the name has two to four parts.
ArrangementName parse_arrangement(std::string_view name);

/// The law of an arrangement: the parameters of its parts, named "1.a", "1.k", "2.k" …; it owns what its Law refers to.
class ArrangementLaw {
 public:
  ArrangementLaw(std::string name, const ArrangementName& arrangement, const std::vector<const Law*>& parts);
  ArrangementLaw(const ArrangementLaw&) = delete;
  ArrangementLaw& operator=(const ArrangementLaw&) = delete;

  const Law& law() const { return law_; }

 private:
  std::string name_, title_;
  std::deque<std::string> names_;
  std::vector<LawParameter> parameters_;
  Law law_;
};

/// Parallel or Series of these elements.
std::unique_ptr<Element> arranged(bool series, Parts parts);

}  // namespace jointid::friction
