#pragma once
// Who runs with whom under one mpirun: splits MPI_COMM_WORLD into the two programs.

#include <mpi.h>

#include <memory>
#include <vector>

#include "coupler/polling_wait.h"

namespace footfall {

// Throws PartnerError with MPI's own text unless code is MPI_SUCCESS.
void check_mpi(int code, const char* call);

// Splits the world by MPI_APPNUM, the number of the program on mpirun's command line
//   mpirun -np 2 liggghts_mbd ... : -np 1 mbd_solver ...
// With one program only there is no partner and world() is a duplicate of MPI_COMM_WORLD. Collective over
// MPI_COMM_WORLD: both programs construct one right after MPI_Init. Throws InputError when there are more than two
// programs.
class Communicator {
 public:
  Communicator();
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  MPI_Comm world() const { return own_; }  // the ranks of this program
  int rank() const { return rank_; }       // within world()
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  bool has_partner() const { return partner_root_ >= 0; }
  MPI_Comm exchange() const { return exchange_; }     // both programs, for transport_mpi alone
  int partner_root() const { return partner_root_; }  // rank of the partner's rank 0 in exchange(); -1 without one

  // null unless the whole job runs on this machine; seats: ranks in exchange()
  const Doorbell* doorbell() const { return doorbell_.get(); }
  const std::vector<int>& own_seats() const { return own_seats_; }  // of the ranks of this program

 private:
  MPI_Comm own_ = MPI_COMM_NULL;
  MPI_Comm exchange_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  int partner_root_ = -1;
  std::unique_ptr<Doorbell> doorbell_;
  std::vector<int> own_seats_;
};

}  // namespace footfall
