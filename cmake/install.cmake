# The files of a prefix, and find_package(mirocup) from a prefix and from the build tree. Programs find their parts relative to
# themselves (system/locations.hpp), so a prefix can be moved. The components are the packages of cmake/packages.cmake.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/mirocup)
# Where Debian's Python looks below /usr; below another prefix, PYTHONPATH names it.
set(MIROCUP_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Folder of the package mirocup for Python, below the prefix")

# mirocup: the programs, the house teams, and what they read.
install(TARGETS mirocup EXPORT mirocup COMPONENT mirocup)
install(TARGETS mirocup_team EXPORT mirocup LIBRARY COMPONENT mirocup NAMELINK_COMPONENT mirocup-dev)
install(TARGETS mirocup-league COMPONENT mirocup)
install(TARGETS mirocup-plugin-host mirocup-careful-host mirocup-project-compiler RUNTIME DESTINATION libexec/mirocup COMPONENT mirocup)
install(PROGRAMS ${PROJECT_BINARY_DIR}/mirocup-credentials DESTINATION libexec/mirocup COMPONENT mirocup)
install(FILES record/record.schema.json record/files.schema.json DESTINATION share/mirocup COMPONENT mirocup)
install(FILES ${PROJECT_BINARY_DIR}/browser/mirocup.wasm browser/mirocup.js browser/verify.mjs browser/package.json
  DESTINATION share/mirocup/browser COMPONENT mirocup OPTIONAL)
install(DIRECTORY ${PROJECT_BINARY_DIR}/browser/node_modules/fzstd DESTINATION share/mirocup/browser/node_modules
  COMPONENT mirocup OPTIONAL FILES_MATCHING PATTERN index.js PATTERN package.json PATTERN LICENSE PATTERN esm EXCLUDE PATTERN umd EXCLUDE)
install(DIRECTORY ${PROJECT_BINARY_DIR}/browser/workbench/parts ${PROJECT_BINARY_DIR}/browser/workbench/clang
  DESTINATION share/mirocup/browser/workbench COMPONENT mirocup OPTIONAL)
install(DIRECTORY plugins/template/ DESTINATION share/mirocup/team COMPONENT mirocup USE_SOURCE_PERMISSIONS)
install(DIRECTORY plugins/drills DESTINATION share/mirocup COMPONENT mirocup PATTERN teams EXCLUDE)
install(DIRECTORY examples/course DESTINATION share/mirocup COMPONENT mirocup)
# The manual and what shells complete: made by the programs themselves, from their options.
install(DIRECTORY ${PROJECT_BINARY_DIR}/share/man/man1 DESTINATION share/man COMPONENT mirocup OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/share/completions/mirocup.bash
  DESTINATION share/bash-completion/completions RENAME mirocup COMPONENT mirocup OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/share/completions/mirocup.zsh
  DESTINATION share/zsh/vendor-completions RENAME _mirocup COMPONENT mirocup OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/share/completions/mirocup.fish
  DESTINATION share/fish/vendor_completions.d COMPONENT mirocup OPTIONAL)
set(pages ${PROJECT_BINARY_DIR}/share/made)
# Pages that the package mirocup-labs has, with all options.
set(labs_pages)
if(MIROCUP_LABS)
  set(labs_pages "mirocup-bench.1 mirocup-export.1 mirocup-identify.1 mirocup-record-as-seen.1 mirocup-tune.1 mirocup-validate.1")
endif()
set(date $ENV{SOURCE_DATE_EPOCH})
if(NOT date)
  set(date 1795737600)  # of this version: 27 November 2026
endif()
set(mirocup_man ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=${date})
add_custom_command(OUTPUT ${pages}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/share/man/man1 ${PROJECT_BINARY_DIR}/share/completions
  COMMAND ${mirocup_man} $<TARGET_FILE:mirocup> man ${PROJECT_BINARY_DIR}/share/man/man1
  COMMAND ${mirocup_man} $<TARGET_FILE:mirocup-league> man ${PROJECT_BINARY_DIR}/share/man/man1
  COMMAND mirocup completion bash > ${PROJECT_BINARY_DIR}/share/completions/mirocup.bash
  COMMAND mirocup completion zsh > ${PROJECT_BINARY_DIR}/share/completions/mirocup.zsh
  COMMAND mirocup completion fish > ${PROJECT_BINARY_DIR}/share/completions/mirocup.fish
  COMMAND sh -c "cd share/man/man1 && rm -f *.gz ${labs_pages} && gzip -9n *.1"
  COMMAND ${CMAKE_COMMAND} -E touch ${pages}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  DEPENDS mirocup mirocup-league VERBATIM)
add_custom_target(manual ALL DEPENDS ${pages})

# Units of systemd, where it looks below /usr.
install(DIRECTORY tournaments/units/ DESTINATION lib/systemd/system COMPONENT mirocup FILES_MATCHING PATTERN "mirocup-*")
install(FILES tournaments/units/sysusers.conf DESTINATION lib/sysusers.d RENAME mirocup.conf COMPONENT mirocup)
install(FILES tournaments/units/tmpfiles.conf DESTINATION lib/tmpfiles.d RENAME mirocup.conf COMPONENT mirocup)

# mirocup-dev: what a team in C or C++ is built with.
install(TARGETS mirocup_strategy mirocup_predict EXPORT mirocup ARCHIVE COMPONENT mirocup-dev)
install(DIRECTORY plugins/include/ TYPE INCLUDE COMPONENT mirocup-dev)
install(EXPORT mirocup NAMESPACE mirocup:: FILE mirocup-targets.cmake DESTINATION ${package_folder} COMPONENT mirocup-dev)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/mirocup-config.cmake ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config-version.cmake
  DESTINATION ${package_folder} COMPONENT mirocup-dev)

# python3-mirocup: teams in Python.
foreach(file __init__.py py.typed team.py)
  install(FILES ${PROJECT_BINARY_DIR}/python/mirocup/${file} DESTINATION ${MIROCUP_PYTHON_DIR}/mirocup COMPONENT python3-mirocup)
endforeach()
install(TARGETS mirocup_skills LIBRARY COMPONENT python3-mirocup NAMELINK_SKIP)
if(TARGET mirocup-python)
  install(TARGETS mirocup-python-host RUNTIME DESTINATION libexec/mirocup COMPONENT python3-mirocup)
  install(TARGETS mirocup-python LIBRARY DESTINATION libexec/mirocup COMPONENT python3-mirocup)
endif()

# mirocup-doc: pages, examples.
set(doc_folder share/doc/mirocup-doc)
install(DIRECTORY examples DESTINATION ${doc_folder} COMPONENT mirocup-doc USE_SOURCE_PERMISSIONS
  PATTERN course EXCLUDE  # it is in share/mirocup
  PATTERN pitch EXCLUDE)  # it needs the source tree
install(DIRECTORY docs DESTINATION ${doc_folder} COMPONENT mirocup-doc PATTERN "*.py" EXCLUDE)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md CITATION.cff DESTINATION ${doc_folder} COMPONENT mirocup-doc)
install(FILES plugins/host/README.md DESTINATION ${doc_folder}/plugins/host COMPONENT mirocup-doc)
install(FILES record/schema.md record/scene.md DESTINATION ${doc_folder}/record COMPONENT mirocup-doc)
install(FILES server/dds/README.md DESTINATION ${doc_folder}/server/dds COMPONENT mirocup-doc)
install(FILES tournaments/README.md DESTINATION ${doc_folder}/tournaments COMPONENT mirocup-doc)
install(FILES tournaments/journal/format.md DESTINATION ${doc_folder}/tournaments/journal COMPONENT mirocup-doc)
# platforms: its teams are in the build tree.
install(DIRECTORY tournaments/examples DESTINATION ${doc_folder}/tournaments COMPONENT mirocup-doc PATTERN platforms EXCLUDE)
# The build tree looks like a prefix to find_package and to `mirocup new`.
export(TARGETS mirocup mirocup_strategy mirocup_predict mirocup_team NAMESPACE mirocup::
  FILE ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-targets.cmake)
configure_file(cmake/mirocup-config.cmake ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config.cmake COPYONLY)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include ${PROJECT_BINARY_DIR}/share/mirocup)
foreach(link plugins/include/mirocup:include/mirocup plugins/template:share/mirocup/team plugins/drills:share/mirocup/drills
    examples/course:share/mirocup/course)
  string(REPLACE ":" ";" ends ${link})
  list(GET ends 0 from)
  list(GET ends 1 to)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${from} ${PROJECT_BINARY_DIR}/${to} COPY_ON_ERROR SYMBOLIC)
endforeach()
include(cmake/packages.cmake)
