// polytope_drop: fifty polytopes, or another scene, on Bullet's narrowphase and ours. See --help. It is `headless_sim
// run` with a scene that is there already.
#include "program_main.h"
#include "run/run_command.h"

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_demos::ParsePolytopeDropOptions(argc, argv), dgd_demos::Run);
}
