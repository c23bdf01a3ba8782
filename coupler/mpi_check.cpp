#include "coupler/mpi_check.h"

#include <mpi.h>

#include <string>

#include "coupler/base/errors.h"

namespace footfall {

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw PartnerError(std::string(call) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

}  // namespace footfall
