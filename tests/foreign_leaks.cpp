/// What libraries lose for a file that they refuse, and what Qt and fontconfig keep until the program ends; leaks of ours are findings.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5\nleak:libmatio\nleak:libfontconfig\nleak:libQt6\nleak:libqoffscreen\n";
}
