# Finds Bullet 3 in both precisions, as Debian's libbullet-dev ships it: one set of headers, libraries in float, and the
# same libraries in double with the suffix -float64. (Debian's own BulletConfig.cmake knows one precision at a time, and
# names every library of Bullet's.) The build uses this file, and so does the installed package.
#
#   dgd_bullet3::float             headers, BulletCollision and LinearMath, float
#   dgd_bullet3::float64           the same in double; defines BT_USE_DOUBLE_PRECISION, which the headers must see
#   dgd_bullet3::dynamics_float    the above and BulletDynamics, for programs
#   dgd_bullet3::dynamics_float64
include(FindPackageHandleStandardArgs)

find_path(DgdBullet3_INCLUDE_DIR btBulletCollisionCommon.h PATH_SUFFIXES bullet)
set(_dgd_bullet3_files DgdBullet3_INCLUDE_DIR)
foreach(_dgd_bullet3_suffix "" "-float64")
  foreach(_dgd_bullet3_library BulletDynamics BulletCollision LinearMath)
    set(_dgd_bullet3_file "DgdBullet3_${_dgd_bullet3_library}${_dgd_bullet3_suffix}_LIBRARY")
    find_library(${_dgd_bullet3_file} "${_dgd_bullet3_library}${_dgd_bullet3_suffix}")
    list(APPEND _dgd_bullet3_files ${_dgd_bullet3_file})
  endforeach()
endforeach()
mark_as_advanced(${_dgd_bullet3_files})
find_package_handle_standard_args(
  DgdBullet3
  REQUIRED_VARS ${_dgd_bullet3_files}
  REASON_FAILURE_MESSAGE "Debian has Bullet in both precisions in its package libbullet-dev.")

function(_dgd_bullet3_add_targets precision suffix)
  if(TARGET dgd_bullet3::${precision})
    return()
  endif()
  add_library(dgd_bullet3::${precision} INTERFACE IMPORTED)
  target_include_directories(dgd_bullet3::${precision} INTERFACE "${DgdBullet3_INCLUDE_DIR}")
  target_link_libraries(
    dgd_bullet3::${precision} INTERFACE "${DgdBullet3_BulletCollision${suffix}_LIBRARY}"
                                        "${DgdBullet3_LinearMath${suffix}_LIBRARY}")
  if(precision STREQUAL "float64")
    target_compile_definitions(dgd_bullet3::${precision} INTERFACE BT_USE_DOUBLE_PRECISION)
  endif()
  add_library(dgd_bullet3::dynamics_${precision} INTERFACE IMPORTED)
  target_link_libraries(
    dgd_bullet3::dynamics_${precision} INTERFACE "${DgdBullet3_BulletDynamics${suffix}_LIBRARY}"
                                                 dgd_bullet3::${precision})
endfunction()

if(DgdBullet3_FOUND)
  _dgd_bullet3_add_targets(float "")
  _dgd_bullet3_add_targets(float64 "-float64")
endif()
unset(_dgd_bullet3_files)
