#include "ident/check/trial/mistaken_units.hpp"

#include <array>
#include <cmath>

namespace jointid::ident {
namespace {

struct Mistaken {
  double factor;
  const char* words;
};

constexpr std::array<Mistaken, 9> mistaken_units = {{{9.80665, "g in place of m/s²"},
                                                     {1e-3, "mm in place of m"},
                                                     {1e-6, "µm in place of m"},
                                                     {0.0254, "inches in place of m"},
                                                     {0.3048, "feet in place of m"},
                                                     {1.0 / 4.4482216, "pounds of force in place of N"},
                                                     {386.0886, "g taken for in/s²"},
                                                     {9806.65, "g taken for mm/s²"},
                                                     {0.01, "cm in place of m"}}};

}  // namespace

UnitFactor nearest_unit(double measured, double tolerance) {
  for (const Mistaken& unit : mistaken_units) {
    if (std::abs(std::log(measured / unit.factor)) < tolerance) return {unit.factor, unit.words};
    if (std::abs(std::log(measured * unit.factor)) < tolerance) return {1.0 / unit.factor, std::string("the reverse of ") + unit.words};
  }
  return {measured, {}};
}

}  // namespace jointid::ident
