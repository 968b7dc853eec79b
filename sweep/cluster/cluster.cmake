# stickslip-mpi, where an MPI library is installed: a program of its own, so that the usual one needs none.
find_package(MPI COMPONENTS CXX QUIET)
if(MPI_CXX_FOUND)
  add_executable(stickslip-mpi cluster/main.cpp cluster/mpi_cluster.cpp cluster/mpi_chunks.cpp)
  target_compile_definitions(stickslip-mpi PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  target_link_libraries(stickslip-mpi PRIVATE sweep MPI::MPI_CXX)
  install(TARGETS stickslip-mpi RUNTIME DESTINATION bin)
endif()
