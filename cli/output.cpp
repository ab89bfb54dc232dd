#include "cli/output.hpp"

#include "frf/temporary_file.hpp"

namespace jointid::cli {

void write_target(const std::string& target, const std::string& text, std::ostream& out) {
  if (target == "-") {
    out << text;
  } else {
    frf::write_text(target, text);
  }
}

}  // namespace jointid::cli
