# find_package(mirocup): mirocup::strategy, the headers that a team is built against, mirocup::predict, the same with the simulator,
# and mirocup::mirocup, the program. Of mirocup-labs, where it is installed: mirocup::training, and mirocup_simurosot_team(), which
# makes a team from sources that were written for SimuroSot.
include("${CMAKE_CURRENT_LIST_DIR}/mirocup-targets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/mirocup-labs-targets.cmake" OPTIONAL)
include("${CMAKE_CURRENT_LIST_DIR}/mirocup_simurosot.cmake" OPTIONAL)
if(NOT COMMAND mirocup_simurosot_team)
  function(mirocup_simurosot_team)
    message(FATAL_ERROR "mirocup_simurosot_team() is a part of mirocup-labs: install that package, or build with -D MIROCUP_LABS=ON")
  endfunction()
endif()
