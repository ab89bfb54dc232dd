/// What libraries lose for a file that they refuse; leaks of ours are findings.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\nleak:libmatio\n"; }
