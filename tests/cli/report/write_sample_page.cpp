#include "base/temporary_file.hpp"
#include "tests/report/sample_page.hpp"

/// Writes the page with one of everything to the file named by the argument.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  jointid::write_text(argv[1], jointid::report::sample_page().html());
  return 0;
}
