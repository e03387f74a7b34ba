#include "apps/apps.h"

namespace dgd_apps {

const std::vector<App>& Apps() {
  static const std::vector<App> apps = {
      Events(),  Sensors(),      Ricochet(), Materials(),  Rolling(),  Sliding(),  Ledge(),
      Tips(),    MultiSpheres(), Mug(),      SlopeForce(), Sleeping(), FarOut(),   Tray(),
      Gripper(), Jaws(),         Pusher(),   Conveyor(),   Chain(),    Fracture(), Drawing(),
  };
  return apps;
}

}  // namespace dgd_apps
