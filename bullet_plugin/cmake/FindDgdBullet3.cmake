# Finds Bullet, in float, in double, or in both. The build uses this file, and so does the installed package. (Bullet's
# own BulletConfig.cmake has one precision at a time, and names every library of Bullet's.) In this order:
#
#   - the targets of a Bullet that the same build has added, by add_subdirectory() or FetchContent;
#   - the prefixes in Bullet_ROOT, a list, of the environment if it is no variable, and nowhere else if it is set;
#   - where CMake looks for everything, CMAKE_PREFIX_PATH first.
#
# Headers and libraries are always of one prefix. Debian's libbullet-dev has the libraries in double next to those
# in float, with the suffix -float64; a Bullet built from source has one precision, which is read from its symbols. Both
# precisions must be of one version.
#
#   dgd_bullet3::float             headers, BulletCollision and LinearMath, float
#   dgd_bullet3::float64           the same in double; defines BT_USE_DOUBLE_PRECISION, which the headers must see
#   dgd_bullet3::dynamics_float    the above and BulletDynamics, for programs
#   dgd_bullet3::dynamics_float64
#
# A Bullet that was built with threads (BULLET2_MULTITHREADING) defines BT_THREADSAFE as well: parts of its locks are in
# its headers.
#
# Components: float and float64; without any, one of them is enough. Sets DgdBullet3_VERSION, and for each precision
# DgdBullet3_<precision>_FOUND, _PREFIX and _SUFFIX, the last one that of its libraries' names.
include(FindPackageHandleStandardArgs)

# The version of the headers in a folder, such as 3.24.
function(_dgd_bullet3_read_version include_dir result)
  set(version "")
  if(EXISTS "${include_dir}/LinearMath/btScalar.h")
    file(STRINGS "${include_dir}/LinearMath/btScalar.h" line REGEX "^#define BT_BULLET_VERSION [0-9]+" LIMIT_COUNT 1)
    if(line MATCHES "([0-9]+)([0-9][0-9])$")
      set(version "${CMAKE_MATCH_1}.${CMAKE_MATCH_2}")
    endif()
  endif()
  set(${result} "${version}" PARENT_SCOPE)
endfunction()

# The libraries are files or targets. Bullet's static ones do not list what they link, so that the linker scans them until
# nothing is missing.
function(_dgd_bullet3_add_targets precision threadsafe include_dir collision linear_math dynamics)
  add_library(dgd_bullet3::${precision} INTERFACE IMPORTED)
  target_include_directories(dgd_bullet3::${precision} INTERFACE "${include_dir}")
  target_link_libraries(
    dgd_bullet3::${precision} INTERFACE "$<LINK_GROUP:RESCAN,${collision},${linear_math}>")
  if(precision STREQUAL "float64")
    target_compile_definitions(dgd_bullet3::${precision} INTERFACE BT_USE_DOUBLE_PRECISION)
  endif()
  if(threadsafe)
    target_compile_definitions(dgd_bullet3::${precision} INTERFACE BT_THREADSAFE=1)
  endif()
  add_library(dgd_bullet3::dynamics_${precision} INTERFACE IMPORTED)
  target_link_libraries(
    dgd_bullet3::dynamics_${precision} INTERFACE "$<LINK_GROUP:RESCAN,${dynamics},${collision},${linear_math}>"
                                                 dgd_bullet3::${precision})
endfunction()

# The precision of a library of Bullet's, by a symbol that has btScalar in its arguments; empty if it has no such symbol.
function(_dgd_bullet3_read_precision library result)
  file(STRINGS "${library}" symbol REGEX "_ZN17btConvexHullShapeC[12]EPK[df]ii" LIMIT_COUNT 1)
  set(precision "")
  if(symbol MATCHES "EPKdii")
    set(precision float64)
  elseif(symbol MATCHES "EPKfii")
    set(precision float)
  endif()
  set(${result} "${precision}" PARENT_SCOPE)
endfunction()

# Whether a library of Bullet's LinearMath has threads, by a class that it has only then.
function(_dgd_bullet3_read_threadsafe library result)
  file(STRINGS "${library}" symbol REGEX "btThreadSupportInterface" LIMIT_COUNT 1)
  set(${result} "${symbol}" PARENT_SCOPE)
endfunction()

# A Bullet of the same build.
macro(_dgd_bullet3_use_targets)
  get_target_property(_dgd_bullet3_source BulletCollision SOURCE_DIR)
  get_filename_component(_dgd_bullet3_include "${_dgd_bullet3_source}" DIRECTORY)
  get_property(_dgd_bullet3_flags DIRECTORY "${_dgd_bullet3_source}" PROPERTY COMPILE_DEFINITIONS)
  set(_dgd_bullet3_precision float)
  if("BT_USE_DOUBLE_PRECISION" IN_LIST _dgd_bullet3_flags)
    set(_dgd_bullet3_precision float64)
  endif()
  set(_dgd_bullet3_threadsafe "${_dgd_bullet3_flags}")
  list(FILTER _dgd_bullet3_threadsafe INCLUDE REGEX "^BT_THREADSAFE=1$")
  _dgd_bullet3_read_version("${_dgd_bullet3_include}" DgdBullet3_VERSION)
  set(DgdBullet3_${_dgd_bullet3_precision}_FOUND TRUE)
  set(DgdBullet3_${_dgd_bullet3_precision}_PREFIX "${_dgd_bullet3_include}")
  set(DgdBullet3_${_dgd_bullet3_precision}_SUFFIX "")
  if(NOT TARGET dgd_bullet3::${_dgd_bullet3_precision})
    _dgd_bullet3_add_targets(
      ${_dgd_bullet3_precision} "${_dgd_bullet3_threadsafe}" "${_dgd_bullet3_include}" BulletCollision LinearMath
      BulletDynamics)
  endif()
endmacro()

# Bullet in one prefix, or where CMake looks for everything: adds the precisions that are there and were not found yet.
macro(_dgd_bullet3_look_in)
  find_path(_dgd_bullet3_include btBulletCollisionCommon.h ${ARGN} PATH_SUFFIXES include/bullet bullet NO_CACHE)
  if(_dgd_bullet3_include)
    get_filename_component(_dgd_bullet3_prefix "${_dgd_bullet3_include}/../.." ABSOLUTE)
    foreach(_dgd_bullet3_suffix "" "-float64")
      foreach(_dgd_bullet3_name BulletCollision LinearMath BulletDynamics)
        find_library(
          _dgd_bullet3_${_dgd_bullet3_name} "${_dgd_bullet3_name}${_dgd_bullet3_suffix}"
          PATHS "${_dgd_bullet3_prefix}"
          PATH_SUFFIXES "lib/${CMAKE_LIBRARY_ARCHITECTURE}" lib lib64
          NO_DEFAULT_PATH NO_CACHE)
      endforeach()
      if(_dgd_bullet3_BulletCollision AND _dgd_bullet3_LinearMath AND _dgd_bullet3_BulletDynamics)
        _dgd_bullet3_read_precision("${_dgd_bullet3_BulletCollision}" _dgd_bullet3_precision)
        _dgd_bullet3_read_version("${_dgd_bullet3_include}" _dgd_bullet3_version)
        if(DgdBullet3_VERSION AND NOT _dgd_bullet3_version STREQUAL DgdBullet3_VERSION)
          message(WARNING "Bullet ${_dgd_bullet3_version} in ${_dgd_bullet3_prefix} is left out: the other is "
                          "${DgdBullet3_VERSION}")
        elseif(_dgd_bullet3_precision AND NOT DgdBullet3_${_dgd_bullet3_precision}_FOUND)
          set(DgdBullet3_VERSION "${_dgd_bullet3_version}")
          set(DgdBullet3_${_dgd_bullet3_precision}_FOUND TRUE)
          set(DgdBullet3_${_dgd_bullet3_precision}_PREFIX "${_dgd_bullet3_prefix}")
          set(DgdBullet3_${_dgd_bullet3_precision}_SUFFIX "${_dgd_bullet3_suffix}")
          _dgd_bullet3_read_threadsafe("${_dgd_bullet3_LinearMath}" _dgd_bullet3_threadsafe)
          if(NOT TARGET dgd_bullet3::${_dgd_bullet3_precision})
            _dgd_bullet3_add_targets(
              ${_dgd_bullet3_precision} "${_dgd_bullet3_threadsafe}" "${_dgd_bullet3_include}"
              "${_dgd_bullet3_BulletCollision}" "${_dgd_bullet3_LinearMath}" "${_dgd_bullet3_BulletDynamics}")
          endif()
        endif()
      endif()
      foreach(_dgd_bullet3_name BulletCollision LinearMath BulletDynamics)
        unset(_dgd_bullet3_${_dgd_bullet3_name})
      endforeach()
    endforeach()
  endif()
  unset(_dgd_bullet3_include)
endmacro()

set(DgdBullet3_VERSION "")
foreach(_dgd_bullet3_precision float float64)
  set(DgdBullet3_${_dgd_bullet3_precision}_FOUND FALSE)
endforeach()
# Remembered: whoever configures this folder again may have another environment.
if(NOT Bullet_ROOT AND DEFINED ENV{Bullet_ROOT})
  set(Bullet_ROOT "$ENV{Bullet_ROOT}" CACHE STRING "Prefixes of Bullet, instead of where CMake looks for everything")
endif()
set(_dgd_bullet3_roots ${Bullet_ROOT})
if(TARGET BulletCollision AND TARGET LinearMath)
  _dgd_bullet3_use_targets()
elseif(_dgd_bullet3_roots)
  foreach(_dgd_bullet3_root IN LISTS _dgd_bullet3_roots)
    if(NOT IS_DIRECTORY "${_dgd_bullet3_root}" OR NOT IS_ABSOLUTE "${_dgd_bullet3_root}")
      message(WARNING "Bullet_ROOT names ${_dgd_bullet3_root}, which is no absolute path of a folder")
    endif()
    _dgd_bullet3_look_in(PATHS "${_dgd_bullet3_root}" NO_DEFAULT_PATH)
  endforeach()
else()
  _dgd_bullet3_look_in()
endif()

set(_dgd_bullet3_found "")
foreach(_dgd_bullet3_precision float float64)
  if(DgdBullet3_${_dgd_bullet3_precision}_FOUND)
    list(APPEND _dgd_bullet3_found
         "${_dgd_bullet3_precision} in ${DgdBullet3_${_dgd_bullet3_precision}_PREFIX}")
  endif()
endforeach()
list(JOIN _dgd_bullet3_found ", " DgdBullet3_LOCATION)
set(_dgd_bullet3_reason
    "Debian's package is libbullet-dev. Bullet_ROOT names the prefix of a Bullet that is installed elsewhere.")
if(_dgd_bullet3_roots)
  list(JOIN _dgd_bullet3_roots " or " _dgd_bullet3_words)
  string(PREPEND _dgd_bullet3_reason
         "In ${_dgd_bullet3_words} there must be include/bullet/btBulletCollisionCommon.h, and in lib BulletCollision, \
LinearMath and BulletDynamics. ")
endif()
if(DgdBullet3_LOCATION)
  string(PREPEND _dgd_bullet3_reason "There is Bullet ${DgdBullet3_VERSION}: ${DgdBullet3_LOCATION}. ")
endif()
find_package_handle_standard_args(
  DgdBullet3
  REQUIRED_VARS DgdBullet3_LOCATION
  VERSION_VAR DgdBullet3_VERSION
  HANDLE_COMPONENTS
  REASON_FAILURE_MESSAGE "${_dgd_bullet3_reason}")
