#!/usr/bin/env bash
# What is integrated knows nothing of MPI: no object of the given static libraries names it, no given program loads it; and programs load the reference BLAS.
#   libraries.sh WITH_MPI.a LIBRARY.a|PROGRAM ...
# WITH_MPI.a does use MPI: a check that finds nothing there finds nothing anywhere.
set -u
failed=0
# SUNDIALS 7 takes MPI's constant for "no communicator".
mpi_in() { nm -C "$1" 2> /dev/null | grep -E '\b(MPI_|ompi_)' | grep -v 'U ompi_mpi_comm_null$'; }
names_mpi() { mpi_in "$1" | grep -q .; }
names_mpi "$1" || { echo "$1 names no MPI: this check is blind"; failed=1; }
shift
for file; do
  [[ -e $file ]] || { echo "$file is missing"; failed=1; continue; }
  if [[ $file == *.a ]]; then
    names_mpi "$file" && { echo "$file names MPI:"; mpi_in "$file" | sort -u | head -5; failed=1; }
  else
    ldd "$file" | grep -E 'libmpi|libopen-(rte|pal)' && { echo "$file loads MPI"; failed=1; }
    ldd "$file" | grep 'libblas' | grep -v '/blas/libblas' && { echo "$file does not load the reference BLAS: its digits depend on the machine"; failed=1; }
  fi
done
exit $failed
