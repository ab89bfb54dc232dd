#include "report/text/notes.hpp"

#include "base/text.hpp"

namespace jointid::report {

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "note: " + printable(note) + "\n";
  return text;
}

}  // namespace jointid::report
