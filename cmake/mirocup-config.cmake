# find_package(mirocup): mirocup::strategy, the headers that a team is built against, mirocup::predict, the same with the simulator,
# and mirocup::mirocup, the program.
include("${CMAKE_CURRENT_LIST_DIR}/mirocup-targets.cmake")
# mirocup_simurosot_team(): a team from sources that were written for SimuroSot.
include("${CMAKE_CURRENT_LIST_DIR}/mirocup_simurosot.cmake")
