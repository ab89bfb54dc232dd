#include "ident/scene/scene.hpp"

#include "base/error.hpp"

namespace jointid::ident {

std::string name(const Regeneration& regeneration) {
  if (!regeneration.any()) return "none";
  if (regeneration.substructures && regeneration.assembly) return "substructures+assembly";
  return regeneration.substructures ? "substructures" : "assembly";
}

Regeneration parse_regeneration(const std::string& text) {
  std::vector<std::string> words;
  for (const bool substructures : {false, true}) {
    for (const bool assembly : {false, true}) {
      const Regeneration one{substructures, assembly};
      if (text == name(one)) return one;
      words.push_back(name(one));
    }
  }
  const std::string near = nearest_word(text, words);
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "regenerate",
                    .problem = "'" + text + "' is no choice of systems",
                    .remedy = near.empty() ? "use none, substructures, assembly or substructures+assembly" : "did you mean " + near + "?"});
}

}  // namespace jointid::ident
