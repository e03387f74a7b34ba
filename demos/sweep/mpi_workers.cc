#include "sweep/mpi_workers.h"

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "sweep/local_workers.h"

namespace dgd_demos {
namespace {

enum Tag {
  kRun = 1,     // A run as JSON; an empty text after the last one.
  kRecord = 2,  // A record as its line.
};

void Send(const std::string& text, int rank, Tag tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
}

// Receives the message that a probe has found.
std::string Receive(const MPI_Status& status) {
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), ' ');
  MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

// Waits in naps: MPI's own wait spins, at the cost of a processor that the runs can use.
bool WaitFor(Tag tag, std::chrono::milliseconds patience, MPI_Status& status) {
  constexpr std::chrono::milliseconds kNap(2);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  do {
    int is_there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there != 0) return true;
    std::this_thread::sleep_for(kNap);
  } while (std::chrono::steady_clock::now() < deadline);
  return false;
}

// A rank that cannot carry out a run, as on a machine without the program, returns a record of that.
RunRecord CarryOut(const RunSpec& run) try {
  LocalWorkers worker(1);
  worker.Start(run);
  for (;;) {
    if (const std::optional<RunRecord> record = worker.Wait(std::chrono::seconds(1))) return *record;
  }
} catch (const std::exception& error) {
  return {run.number, RunRecord::Status::kFailed, error.what(), "", {}};
}

class MpiWorkers : public Workers {
 public:
  explicit MpiWorkers(int size) : size_(size) {
    for (int rank = 1; rank < size; ++rank) idle_.push_back(rank);
  }
  ~MpiWorkers() override {
    for (int rank = 1; rank < size_; ++rank) Send("", rank, kRun);
  }

  int idle() const override { return static_cast<int>(idle_.size()); }
  void Start(const RunSpec& run) override {
    Send(run.ToJson().dump(), idle_.back(), kRun);
    idle_.pop_back();
  }
  std::optional<RunRecord> Wait(std::chrono::milliseconds patience) override {
    MPI_Status status;
    if (!WaitFor(kRecord, patience, status)) return std::nullopt;
    const std::string line = Receive(status);
    idle_.push_back(status.MPI_SOURCE);
    return ParseRunRecord(line);
  }

 private:
  int size_;
  std::vector<int> idle_;  // Ranks without a run.
};

}  // namespace

bool IsStartedByMpi() {
  // Open MPI sets the first for the processes that it starts, MPICH and Slurm the second.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* size = std::getenv(name);
    if (size != nullptr && std::atoi(size) > 1) return true;
  }
  return false;
}

MpiSession::MpiSession() {
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiSession::~MpiSession() { MPI_Finalize(); }

std::unique_ptr<Workers> MakeMpiWorkers(const MpiSession& session) {
  return std::make_unique<MpiWorkers>(session.size());
}

void ServeRuns() {
  for (;;) {
    MPI_Status status;
    while (!WaitFor(kRun, std::chrono::seconds(1), status)) {
    }
    const std::string run = Receive(status);
    if (run.empty()) return;
    Send(ToLine(CarryOut(RunSpec::FromJson(nlohmann::json::parse(run)))), 0, kRecord);
  }
}

}  // namespace dgd_demos
