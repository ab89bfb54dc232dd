/* To be preloaded: ends the process with code 99 where it initialises MPI. */
#include <stdio.h>
#include <unistd.h>

static int trap(const char* name) {
  fprintf(stderr, "%s was called\n", name);
  _exit(99);
}

int MPI_Init(int* argc, char*** argv) {
  (void)argc;
  (void)argv;
  return trap("MPI_Init");
}

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  (void)argc;
  (void)argv;
  (void)required;
  (void)provided;
  return trap("MPI_Init_thread");
}
