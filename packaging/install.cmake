# What `cmake --install` puts where. Two components:
#   runtime      programs, what a run needs, man pages, completion, docs     package footfall
#   development  headers and libraries: find_package(footfall)               package footfall-dev
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS footfall footfall_studies mbd_solver liggghts_mbd RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)

# Programs find these from their own place: ../share/footfall (mbd_solver/scene/shipped_files.h).
set(share share/footfall)
install(DIRECTORY inputs examples DESTINATION ${share} COMPONENT runtime)
install(FILES README.md CHANGELOG.md LICENSE packaging/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT runtime
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.txt" PATTERN site EXCLUDE)

# The pages of help are made by the program itself.
find_program(GZIP gzip REQUIRED)
set(help ${CMAKE_BINARY_DIR}/help)
add_custom_command(OUTPUT ${help}/_footfall
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${help}
  COMMAND footfall help --write ${help}
  COMMAND sh -c "exec \"$1\" -9n \"$2\"/*.1" sh ${GZIP} ${help}
  DEPENDS footfall footfall_studies COMMENT "Man pages and completion" VERBATIM)
add_custom_target(help_pages ALL DEPENDS ${help}/_footfall)
install(DIRECTORY ${help}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime FILES_MATCHING PATTERN "*.1.gz")
install(FILES ${help}/footfall.bash DESTINATION share/bash-completion/completions RENAME footfall COMPONENT runtime)
install(FILES ${help}/_footfall DESTINATION share/zsh/vendor-completions COMPONENT runtime)

# Headers by their full paths, as the sources name them.
install(DIRECTORY coupler DESTINATION include/footfall COMPONENT development FILES_MATCHING PATTERN "*.h")
install(DIRECTORY mbd_solver DESTINATION include/footfall COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN app EXCLUDE PATTERN studies EXCLUDE PATTERN bed EXCLUDE)

# footfall::coupler       the conversation with LIGGGHTS, over MPI
# footfall::mbd_solver    scene, model, integrators, runs
# find_package(footfall COMPONENTS coupler) needs Eigen and MPI alone.
set_target_properties(footfall_options PROPERTIES EXPORT_NAME options)
set_target_properties(coupler PROPERTIES EXPORT_NAME coupler_without_mpi)
set_target_properties(coupler_mpi PROPERTIES EXPORT_NAME coupler)
install(TARGETS footfall_options coupler_base coupler coupler_mpi EXPORT footfallCoupler
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/footfall COMPONENT development)
add_library(mbd_solver_library INTERFACE)
target_link_libraries(mbd_solver_library INTERFACE mbd_run coupler_mpi)
set_target_properties(mbd_solver_library PROPERTIES EXPORT_NAME mbd_solver)
install(TARGETS mbd_base mbd_model mbd_fe mbd_dynamics mbd_integrator mbd_scene mbd_build mbd_coupling
  mbd_output mbd_observe mbd_run mbd_solver_library EXPORT footfallMbdSolver
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/footfall COMPONENT development)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/footfall)
foreach(part Coupler MbdSolver)
  install(EXPORT footfall${part} NAMESPACE footfall:: FILE footfall${part}.cmake DESTINATION ${config} COMPONENT development)
endforeach()
configure_package_config_file(${CMAKE_SOURCE_DIR}/packaging/footfallConfig.cmake.in ${CMAKE_BINARY_DIR}/footfallConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/footfallConfigVersion.cmake COMPATIBILITY ExactVersion)
install(FILES ${CMAKE_BINARY_DIR}/footfallConfig.cmake ${CMAKE_BINARY_DIR}/footfallConfigVersion.cmake
  DESTINATION ${config} COMPONENT development)
