// What is wrong with a scene, in one sentence that names the file, the place in it and the value.
#pragma once

#include <stdexcept>

namespace dgd_demos {

class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace dgd_demos
