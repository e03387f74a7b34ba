// The ranks of an MPI program, on as many machines as it was started on: rank 0 hands out the runs, each other rank
// carries out one after the other, in a process of its own, and sends back the record. Only rank 0 needs the study's
// folder; all need its worlds.
#pragma once

#include <memory>

#include "sweep/workers.h"

namespace dgd_demos {

/// Whether this process was started by mpirun or the like, with more than one rank, and can take part.
bool IsStartedByMpi();

/// MPI, from here to the end of its life. To be made once in a process.
class MpiSession {
 public:
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

 private:
  int rank_ = 0, size_ = 1;
};

/// Of rank 0: all other ranks. Its end is theirs, too.
std::unique_ptr<Workers> MakeMpiWorkers(const MpiSession& session);

/// Of all other ranks: carries out runs until rank 0 has no more.
void ServeRuns();

}  // namespace dgd_demos
