// The ranks of an MPI program, on as many machines as it was started on: rank 0 hands out the runs; each other rank
// carries out one after the other, each in a process of its own, and sends back the record. Only rank 0 needs the
// study's folder; all ranks need its worlds.
#pragma once

#include <memory>

#include "sweep/workers.h"

namespace dgd_demos {

/// Whether mpirun or the like has started this process with more than one rank.
bool IsStartedByMpi();

/// MPI from construction to destruction; constructed once in a process.
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

/// Makes the workers of rank 0, which are all other ranks. Their ServeRuns() returns when the workers are destroyed.
std::unique_ptr<Workers> MakeMpiWorkers(const MpiSession& session);

/// Carries out runs until rank 0 has no more. Every other rank calls it.
void ServeRuns();

}  // namespace dgd_demos
