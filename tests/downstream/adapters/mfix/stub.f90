! MFiX, as far as the adapter sees it: names and shapes of its variables.
module param
  implicit none
  integer, parameter :: DIM_M = 10
end module

module run
  implicit none
  character(16) :: UNITS = 'SI'
  character(60) :: RUN_NAME = 'two-bodies'
end module

module compar
  implicit none
  integer :: numPEs = 1
end module

module discretelement
  implicit none
  integer, parameter :: nonexistent = 0, normal_particle = 1, entering_particle = 2, exiting_particle = 3, normal_ghost = 4, &
    HERTZIAN = 0, LSD = 1
  integer :: MAX_PIP = 0, DES_COLL_MODEL_ENUM = LSD, COLLISION_ARRAY_MAX = 8
  integer(kind=1), allocatable :: PARTICLE_STATE(:)
  integer, allocatable :: iGLOBAL_ID(:), NEIGHBORS(:), NEIGHBOR_INDEX(:), PIJK(:, :)
  double precision, allocatable :: DES_RADIUS(:), DES_POS_NEW(:, :), PMASS(:)
end module
