# Debian packages by cpack, one for each install component; bullet_plugin/package.sh makes them. Files that Debian's
# policy demands of a package, and that no other installation has, are made here.
if(NOT DgdBullet3_float_PREFIX STREQUAL "/usr" OR NOT DgdBullet3_float64_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "DGD_DEBIAN_PACKAGES needs Debian's libbullet-dev, on which the packages depend, and here is \
${DgdBullet3_LOCATION}")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime development tools)

# As debchange(1) finds out who makes a package.
set(maintainer "$ENV{DEBFULLNAME}")
set(address "$ENV{DEBEMAIL}")
if(NOT maintainer)
  set(maintainer "dgd-bullet contributors")
endif()
if(NOT address)
  cmake_host_system_information(RESULT host QUERY FQDN)
  set(address "root@${host}")
endif()
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${maintainer} <${address}>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_NAME dgd-bullet)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
    "${CMAKE_CURRENT_BINARY_DIR}/dgd_core" "${CMAKE_CURRENT_BINARY_DIR}/bullet_plugin"
    "${CMAKE_CURRENT_BINARY_DIR}/bullet_plugin/record")
# Each package's description begins with a synopsis of its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libdgd-bullet0.1)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_MULTIARCH same)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "growth distance as the narrowphase of Bullet - shared libraries
Finds where two convex bodies touch by the growth distance, the factor at
which both, each scaled about its centre, are in contact. It replaces
Bullet's GJK and EPA in its collision dispatcher, in float and in double.")

# For packages of programs that link the libraries, and for the dynamic linker. (CPack's GENERATE_SHLIBS warns of the
# modules of dgd-bullet-run, which no program links.)
set(shlibs "")
set(libraries dgd_core dgd_bullet dgd_bullet-float64)
if(DGD_BUILD_RECORD)
  list(APPEND libraries dgd_bullet_record dgd_bullet_record-float64)
endif()
foreach(library IN LISTS libraries)
  string(APPEND shlibs "lib${library} 0.1 libdgd-bullet0.1 (>= ${PROJECT_VERSION})\n")
endforeach()
file(CONFIGURE OUTPUT debian/shlibs CONTENT "@shlibs@" @ONLY)
file(CONFIGURE OUTPUT debian/triggers CONTENT "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_BINARY_DIR}/debian/shlibs" "${CMAKE_CURRENT_BINARY_DIR}/debian/triggers")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdgd-bullet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_MULTIARCH same)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libdgd-bullet0.1 (= ${version}), libbullet-dev")
# Users of dgd::core alone need it.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS libeigen3-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "growth distance as the narrowphase of Bullet - development files
Headers, and what CMake and pkg-config read, of a collision configuration for
Bullet that finds contacts by the growth distance, and of its solver.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME dgd-bullet-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libdgd-bullet0.1 (= ${version})")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS libosmesa6) # Loaded when a picture is drawn.
set(CPACK_COMPONENT_TOOLS_DESCRIPTION
    "growth distance as the narrowphase of Bullet - programs and scenes
dgd-bullet-run runs a program that uses Bullet's shared libraries on the
growth distance without rebuilding it; polytope_drop and headless_sim let
scenes fall on Bullet's own narrowphase and on this one, and compare them.")

file(READ LICENSE text)
string(REGEX MATCH "Copyright [(]c[)] ([^\n]*)" ignored "${text}")
set(copyright "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright [(]c[)] [^\n]*\n\n" "" text "${text}")
string(REGEX REPLACE "\n\n" "\n.\n" text "${text}")
string(REGEX REPLACE "\n$" "" text "${text}")
string(REPLACE "\n" "\n " text "${text}")
file(
  CONFIGURE
  OUTPUT debian/copyright
  CONTENT
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: dgd-bullet

Files: *
Copyright: @copyright@
License: Zlib
 @text@
"
  @ONLY)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(
  CONFIGURE
  OUTPUT debian/changelog
  CONTENT
    "dgd-bullet (@version@) unstable; urgency=low

  * Version @PROJECT_VERSION@, as built from its source.

 -- @CPACK_DEBIAN_PACKAGE_MAINTAINER@  @date@
"
  @ONLY)
# -n: no time of its own in the archive.
execute_process(COMMAND gzip -9nc "${CMAKE_CURRENT_BINARY_DIR}/debian/changelog"
                OUTPUT_FILE "${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.Debian.gz" COMMAND_ERROR_IS_FATAL ANY)
foreach(component IN ITEMS runtime development tools)
  string(TOUPPER ${component} upper)
  install(
    FILES "${CMAKE_CURRENT_BINARY_DIR}/debian/copyright" "${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}"
    COMPONENT ${component})
endforeach()

# The documentation of each package, in folders as in the source, so that links from page to page work.
set(documented_development . dgd_core bullet_plugin)
set(documented_tools . bullet_plugin demos scenes)
foreach(component IN ITEMS development tools)
  string(TOUPPER ${component} upper)
  foreach(folder IN LISTS documented_${component})
    install(
      FILES "${PROJECT_SOURCE_DIR}/${folder}/README.md"
      DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}/${folder}"
      COMPONENT ${component})
  endforeach()
endforeach()
include(CPack)
