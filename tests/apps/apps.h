// The table of apps: it drives the command line, --help, the output and the tests.
#pragma once

#include <vector>

#include "apps/app.h"

namespace dgd_apps {

/// All of them, in the order of the table.
const std::vector<App>& Apps();

// Each in the file of its name.
App Chain();
App Conveyor();
App Drawing();
App Events();
App FarOut();
App Fracture();
App Gripper();
App Jaws();
App Ledge();
App Materials();
App Mug();
App MultiSpheres();
App Pusher();
App Ricochet();
App Rolling();
App Sensors();
App Sleeping();
App Sliding();
App SlopeForce();
App Tips();
App Tray();

}  // namespace dgd_apps
