#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <typeinfo>
#include <vector>

#include "friction/law/generalized_slip.hpp"
#include "friction/law/laws.hpp"
#include "friction/path/parallel.hpp"
#include "friction/path/series.hpp"

namespace jointid::friction {

/// 0 … count − 1, whatever RapidCheck's size of the moment.
inline std::size_t any_of(std::size_t count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, count));
}

/// Uniform in [lower, upper].
inline double any_in(double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(any_of(1'000'001)) / 1e6;
}

inline double any_decade(double lower, double upper) { return std::pow(10.0, any_in(std::log10(lower), std::log10(upper))); }

/// Values with slip displacements between 1e-8 and 1e-6 m and stiffnesses between 1e6 and 1e8 N/m; of a law that is not listed,
/// where fits to such a joint begin.
inline std::vector<double> any_values(const std::string& law) {
  const double slip = any_decade(1e-8, 1e-6), stiffness = any_decade(1e6, 1e8);
  if (law == "ren") return {slip, any_in(0.01, 6.0), stiffness};
  if (law == "shoukry") return {stiffness * slip, 1.0 / slip};
  if (law == "burdekin") return {stiffness, -0.5 * stiffness / slip};
  if (law == "spring") return {stiffness};
  if (law == "iwan") return {stiffness * slip, stiffness, any_in(-0.95, 0.5), any_in(0.0, 3.0)};
  if (law == "bilinear") return {slip, stiffness};
  const LawStart& start = friction::law(law).start;
  return start.values({stiffness, stiffness * slip}, start.shapes[any_of(start.shapes.size())]);
}

inline std::string any_law() {
  const auto all = laws();
  return std::string(all[any_of(all.size())].name);
}

/// A displacement of the order of the slip displacement of `element`, from far below to far above.
inline double any_displacement(const Element& element) {
  const std::vector<double> kinks = element.kinks();
  const double scale = kinks.empty() ? 1e-7 : kinks[any_of(kinks.size())];
  return scale * any_decade(1e-2, 30.0);
}

inline std::unique_ptr<Element> any_single() {
  const std::string law = any_law();
  return make_element(law, any_values(law));
}

inline std::unique_ptr<Element> any_table() {
  std::vector<SlipPoint> table = {{0.0, any_decade(1e-8, 1e-6)}};
  for (std::size_t more = 1 + any_of(6); more > 0; --more) {
    const auto [share, displacement] = table.back();
    table.push_back({more == 1 && any_of(2) ? 1.0 : any_in(share + 1e-3, 0.5 * (1.0 + share)), displacement * any_in(1.01, 3.0)});
  }
  return std::make_unique<GeneralizedSlip>(any_decade(1e6, 1e8), std::move(table));
}

/// A single law, a table, or an assembly of them.
inline std::unique_ptr<Element> any_element(int depth = 1) {
  const std::size_t kind = depth > 0 ? any_of(6) : 0;
  if (kind < 3) return any_single();
  if (kind == 3) return any_table();
  Parts parts;
  for (std::size_t more = 2 + any_of(2); more > 0; --more) parts.push_back(any_element(depth - 1));
  if (kind == 4) return std::make_unique<Parallel>(std::move(parts));
  return std::make_unique<Series>(std::move(parts));
}

/// For the log of a failure.
inline std::string describe(const Element& element) {
  std::ostringstream text;
  text.precision(17);
  text << typeid(element).name() << ':';
  for (const Parameter& parameter : element.parameters()) text << ' ' << parameter.name << '=' << parameter.value;
  text << "; kinks";
  for (const double kink : element.kinks()) text << ' ' << kink;
  text << '\n';
  return text.str();
}

/// Displacements of a history with reversals of every size.
inline std::vector<double> any_history(const Element& element) {
  std::vector<double> history;
  for (std::size_t more = 1 + any_of(40); more > 0; --more) {
    history.push_back(any_displacement(element) * (any_of(2) == 0 ? -1.0 : 1.0));
  }
  return history;
}

}  // namespace jointid::friction
