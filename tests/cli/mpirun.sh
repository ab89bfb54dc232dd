# For the tests under mpirun, which source it.

# end_of PROCESS: waits for an mpirun after Ctrl-C, and has its exit code. Its processes are killed after a second; then Open MPI's mpirun
# itself now and then waits for ever for a thread of its own (PMIx_server_finalize): after half a minute it is killed too.
end_of() {
  for ((i = 0; i < 300; ++i)); do
    kill -0 "$1" 2> /dev/null || break
    sleep 0.1
  done
  kill -KILL "$1" 2> /dev/null || true
  wait "$1"
}
