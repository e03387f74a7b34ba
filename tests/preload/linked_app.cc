// An app that is linked against Bullet. Usage: linked_app ARRANGEMENT (worlds.h)
#include "worlds.h"

int main(int argc, char** argv) { return argc == 2 ? RunWorlds(argv[1]) : 2; }
