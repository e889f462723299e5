# Finds every library Taut stands on and gathers them in the interface targets
# taut::dealii (finite elements, PETSc, p4est, MPI), taut::sundials and
# taut::gmsh. All missing ones are listed at once.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

set(missing "")

find_package(deal.II 9.4.0 QUIET HINTS ${deal.II_DIR} ${DEAL_II_DIR} $ENV{DEAL_II_DIR})
if(NOT deal.II_FOUND)
  list(APPEND missing "deal.II 9.4 or newer (libdeal.ii-dev)")
else()
  foreach(feature MPI P4EST PETSC SLEPC SUNDIALS GMSH MUPARSER TRILINOS)
    if(NOT DEAL_II_WITH_${feature})
      list(APPEND missing "deal.II built with ${feature}")
    endif()
  endforeach()
endif()

foreach(package CLI11 fmt spdlog nlohmann_json)
  find_package(${package} QUIET)
  if(NOT ${package}_FOUND)
    list(APPEND missing "${package}")
  endif()
endforeach()

find_library(TAUT_ARKODE_LIBRARY sundials_arkode)
find_library(TAUT_CVODE_LIBRARY sundials_cvode)
find_library(TAUT_IDAS_LIBRARY sundials_idas)
find_library(TAUT_KINSOL_LIBRARY sundials_kinsol)
find_library(TAUT_NVECPARALLEL_LIBRARY sundials_nvecparallel)
find_library(TAUT_NVECSERIAL_LIBRARY sundials_nvecserial)
find_library(TAUT_MUPARSER_LIBRARY muparser)
find_library(TAUT_GMSH_LIBRARY gmsh)
find_library(TAUT_FFTW_LIBRARY fftw3)
foreach(library ARKODE CVODE IDAS KINSOL NVECPARALLEL NVECSERIAL MUPARSER GMSH FFTW)
  if(NOT TAUT_${library}_LIBRARY)
    list(APPEND missing "the library ${library}")
  endif()
endforeach()

if(missing)
  list(JOIN missing "\n  " missing)
  message(FATAL_ERROR "Taut cannot be built, these are missing:\n  ${missing}\n"
                      "The script ./taut installs them on Debian 12.")
endif()

find_package(MPI REQUIRED COMPONENTS C)

# deal.II's own setup macro adds -g and none of the choices below.
add_library(taut_dealii INTERFACE)
add_library(taut::dealii ALIAS taut_dealii)
target_include_directories(taut_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
# Only what Taut calls itself; deal.II's own list of 160 libraries costs seconds
# at every link and the loader 0.3 s at every start.
foreach(library IN LISTS DEAL_II_LIBRARIES_RELEASE)
  if(library MATCHES "lib(trilinos_teuchoscomm|trilinos_teuchoscore|petsc|slepc|boost_iostreams|boost_serialization|tbb|z|p4est|sc|muparser|lapack|blas)\\.so$")
    list(APPEND TAUT_DEALII_LIBRARIES ${library})
  endif()
endforeach()
target_link_libraries(taut_dealii INTERFACE
  "$<IF:$<CONFIG:Debug>,${DEAL_II_PATH}/${DEAL_II_LIBRARY_RELDIR}/libdeal.ii.g.so,${DEAL_II_PATH}/${DEAL_II_LIBRARY_RELDIR}/libdeal.ii.so>"
  ${TAUT_DEALII_LIBRARIES} MPI::MPI_C)
target_compile_definitions(taut_dealii INTERFACE $<$<CONFIG:Debug>:DEBUG>
  OMPI_SKIP_MPICXX BOOST_NO_AUTO_PTR TBB_SUPPRESS_DEPRECATED_MESSAGES)

# For the layer time, which needs nothing else of deal.II's company.
add_library(taut_slepc INTERFACE)
add_library(taut::slepc ALIAS taut_slepc)
target_include_directories(taut_slepc SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
set(TAUT_SLEPC_LIBRARIES ${TAUT_DEALII_LIBRARIES})
list(FILTER TAUT_SLEPC_LIBRARIES INCLUDE REGEX "lib(petsc|slepc)\\.so$")
target_link_libraries(taut_slepc INTERFACE ${TAUT_SLEPC_LIBRARIES} MPI::MPI_C)

add_library(taut_sundials INTERFACE)
add_library(taut::sundials ALIAS taut_sundials)
target_include_directories(taut_sundials SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
# Never sundials_ida: it exports the same symbols as the idas of deal.II.
target_link_libraries(taut_sundials INTERFACE
  ${TAUT_ARKODE_LIBRARY} ${TAUT_CVODE_LIBRARY} ${TAUT_IDAS_LIBRARY}
  ${TAUT_KINSOL_LIBRARY} ${TAUT_NVECPARALLEL_LIBRARY} ${TAUT_NVECSERIAL_LIBRARY})

target_link_libraries(taut_sundials INTERFACE MPI::MPI_C)

add_library(taut_gmsh INTERFACE)
add_library(taut::gmsh ALIAS taut_gmsh)
target_link_libraries(taut_gmsh INTERFACE ${TAUT_GMSH_LIBRARY})

add_library(taut_fftw INTERFACE)
add_library(taut::fftw ALIAS taut_fftw)
target_link_libraries(taut_fftw INTERFACE ${TAUT_FFTW_LIBRARY})

add_library(taut_muparser INTERFACE)
add_library(taut::muparser ALIAS taut_muparser)
target_link_libraries(taut_muparser INTERFACE ${TAUT_MUPARSER_LIBRARY})
