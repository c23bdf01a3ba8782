#pragma once
// Splits MPI_COMM_WORLD into the two programs that one mpirun has started.

#include <mpi.h>

#include <memory>
#include <vector>

#include "coupler/polling_wait.h"

namespace footfall {

// Throws PartnerError with MPI's own text unless result is MPI_SUCCESS. Every call of MPI goes through it.
void check_mpi(int result, const char* call);

// Splits the world by MPI_APPNUM, the number of the program on mpirun's command line:
//   mpirun -np 2 liggghts_mbd ... : -np 1 mbd_solver ...
// With one program only there is no partner, and world() is a duplicate of MPI_COMM_WORLD. Collective over
// MPI_COMM_WORLD: both programs construct one right after MPI_Init. Throws InputError for more than two programs.
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
  MPI_Comm exchange() const { return exchange_; }     // all ranks of both programs; for TransportMpi
  int partner_root() const { return partner_root_; }  // rank of the partner's root in exchange(); -1 without partner

  // Null unless all ranks run on this machine and each has a doorbell.
  const Doorbell* doorbell() const { return doorbell_.get(); }
  // Ranks of this program in exchange(), by which their doorbells are addressed.
  const std::vector<int>& own_ranks() const { return own_ranks_; }

 private:
  MPI_Comm own_ = MPI_COMM_NULL;
  MPI_Comm exchange_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  int partner_root_ = -1;
  std::unique_ptr<Doorbell> doorbell_;
  std::vector<int> own_ranks_;
};

}  // namespace footfall
