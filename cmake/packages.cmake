# `cpack -G DEB` in the build tree of the preset "packages" makes the five packages of Debian; docs/installing.md.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mirocup)
set(CPACK_PACKAGE_VENDOR mirocup)
include(${PROJECT_SOURCE_DIR}/cmake/owner.cmake)
set(CPACK_PACKAGE_CONTACT "${MIROCUP_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${MIROCUP_HOMEPAGE}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/one_date.cmake)
set(CPACK_COMPONENTS_ALL mirocup mirocup-dev python3-mirocup mirocup-doc)
if(MIROCUP_LABS)
  list(APPEND CPACK_COMPONENTS_ALL mirocup-labs)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
foreach(package MIROCUP PYTHON3-MIROCUP MIROCUP-LABS)  # those with a library that programs link
  set(CPACK_DEBIAN_${package}_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/triggers)
endforeach()
list(APPEND CPACK_DEBIAN_MIROCUP_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_MIROCUP_PACKAGE_NAME mirocup)
set(CPACK_DEBIAN_MIROCUP-DEV_PACKAGE_NAME mirocup-dev)
set(CPACK_DEBIAN_PYTHON3-MIROCUP_PACKAGE_NAME python3-mirocup)
set(CPACK_DEBIAN_MIROCUP-DOC_PACKAGE_NAME mirocup-doc)
set(CPACK_DEBIAN_MIROCUP-LABS_PACKAGE_NAME mirocup-labs)
set(CPACK_DEBIAN_MIROCUP_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MIROCUP-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PYTHON3-MIROCUP_PACKAGE_SECTION python)
set(CPACK_DEBIAN_MIROCUP-DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_MIROCUP-LABS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MIROCUP_PACKAGE_DEPENDS "tzdata")
set(CPACK_DEBIAN_MIROCUP_PACKAGE_RECOMMENDS "mirocup-dev, ffmpeg, openssl")
set(CPACK_DEBIAN_MIROCUP_PACKAGE_SUGGESTS "python3-mirocup, mirocup-labs, mirocup-doc, nodejs, xdg-utils")
set(same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(CPACK_DEBIAN_MIROCUP-DEV_PACKAGE_DEPENDS "mirocup ${same_version}, g++, cmake, make")
set(CPACK_DEBIAN_MIROCUP-DEV_PACKAGE_RECOMMENDS "gdb")
set(CPACK_DEBIAN_PYTHON3-MIROCUP_PACKAGE_DEPENDS "mirocup ${same_version}, python3")
set(CPACK_DEBIAN_PYTHON3-MIROCUP_PACKAGE_SUGGESTS "mirocup-labs")
set(CPACK_DEBIAN_MIROCUP-LABS_PACKAGE_DEPENDS "mirocup ${same_version}, python3-mirocup ${same_version}, python3")
set(CPACK_DEBIAN_MIROCUP-LABS_PACKAGE_RECOMMENDS "mirocup-dev, python3-numpy")
set(CPACK_DEBIAN_MIROCUP-DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_MIROCUP-DOC_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_MIROCUP_DESCRIPTION "tournament platform for MiroSot robot soccer
Simulates a leg between two teams of small robots, judges it by the laws,
records it so that it can be run again bit for bit, and makes a league of
many legs. Teams are shared libraries or files of Python in a sandbox, or
programs on the network. This package has the programs, house teams, and
units of systemd for leagues.")
set(CPACK_DEBIAN_MIROCUP-DEV_DESCRIPTION "headers to build a team for mirocup
Headers in C and C++, a library that predicts what the simulator will do,
and the files for find_package(mirocup) of CMake. With it, the command
mirocup new makes a team that builds as it is.")
set(CPACK_DEBIAN_PYTHON3-MIROCUP_DESCRIPTION "teams in Python for mirocup
The module mirocup.team and the program that plays a team in Python in the
sandbox of a library.")
set(CPACK_DEBIAN_MIROCUP-LABS_DESCRIPTION "research with mirocup: learning, tuning, other pitches and platforms
Environments with the interface of Gymnasium in which thousands of matches
are played at once, the search for better numbers of a team, the numbers of
a pitch from recordings of it, and teams from sources that were written for
SimuroSot.")
set(CPACK_DEBIAN_MIROCUP-DOC_DESCRIPTION "pages, laws and examples of mirocup
What hosts of leagues and students read: the laws, the conditions of a hall,
how to host a league, exercises, formats of files, and examples: a league,
a team over the network.")

# Each package has its copyright, its changelog and what lintian need not tell (cmake/debian).
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(package ${CPACK_COMPONENTS_ALL})
  set(folder ${PROJECT_BINARY_DIR}/debian/${package})
  configure_file(cmake/debian/changelog.in ${folder}/changelog @ONLY)
  execute_process(COMMAND gzip -9nf ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${folder}/changelog.gz DESTINATION share/doc/${package} RENAME changelog.Debian.gz COMPONENT ${package} EXCLUDE_FROM_ALL)
  install(FILES cmake/debian/copyright DESTINATION share/doc/${package} COMPONENT ${package} EXCLUDE_FROM_ALL)
  # What lintian says to a package that is not of Debian itself, and what is meant.
  file(READ cmake/debian/lintian-overrides overrides)
  if(EXISTS ${PROJECT_SOURCE_DIR}/cmake/debian/${package}.lintian-overrides)
    file(READ cmake/debian/${package}.lintian-overrides more)
    string(APPEND overrides "${more}")
  endif()
  file(WRITE ${folder}/overrides "${overrides}")
  install(FILES ${folder}/overrides DESTINATION share/lintian/overrides RENAME ${package} COMPONENT ${package} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
