#pragma once

#include <rapidcheck.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "friction/path/parallel.hpp"
#include "tests/friction/random_element.hpp"

namespace jointid::response {

using friction::any_decade;
using friction::any_in;
using friction::any_of;

/// Any law that slips at about a hundredth, with a stiffness of about 100: for the structure of three masses of the golden cases.
inline std::shared_ptr<const friction::Element> any_joint() {
  const double slip = any_decade(2e-3, 3e-2), stiffness = any_decade(30.0, 300.0);
  switch (any_of(6)) {
    case 0:
      return friction::make_element("bilinear", std::vector<double>{slip, stiffness});
    case 1:
      return friction::make_element("ren", std::vector<double>{0.4 * slip, any_in(0.3, 2.5), stiffness});
    case 2:
      return friction::make_element("shoukry", std::vector<double>{stiffness * slip, 1.0 / slip});
    case 3:
      return friction::make_element("burdekin", std::vector<double>{stiffness, -0.25 * stiffness / slip});
    case 4:
      return friction::make_element("iwan",
                                    std::vector<double>{stiffness * slip, stiffness, any_in(-0.7, 0.3), any_in(0.0, 2.0)});
    default:
      return std::make_shared<friction::Parallel>(
          friction::Parts{friction::make_element("bilinear", std::vector<double>{slip, stiffness}),
                          friction::make_element("ren", std::vector<double>{0.3 * slip, 1.0, 0.5 * stiffness})});
  }
}

/// As many draws as RC_PARAMS=max_success asks for: of properties that take long, so that they have few draws, always the same.
inline std::uint64_t draws(std::uint64_t otherwise) {
  const char* parameters = std::getenv("RC_PARAMS");
  const std::string text = parameters != nullptr ? parameters : "", key = "max_success=";
  const std::size_t place = text.find(key);
  return place == std::string::npos ? otherwise : std::stoull(text.substr(place + key.size()));
}

}  // namespace jointid::response
