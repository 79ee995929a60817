! MFiX, as far as the adapter sees it: two spheres, or one and a wall, and a third sphere that touches nothing. Reads
! "phase1 R1 phase2 R2" (phase2 0: a wall), then lines "overlap turn" of one step each; before a step with turn 1 the particles
! change their places in memory, and who has whom in the list of neighbours. Writes the force on the first along the normal
! away from the other, and the damping where MFiX's own is 1 N s/m with a spring of 1e5 N/m.
!
! host [LOAD SAVE [PROCESSES]]
program host
  use compar, only: numPEs
  use discretelement
  use platen_mfix
  implicit none
  double precision, parameter :: n(3) = [0.6d0, 0d0, 0.8d0] ! from the first to the other
  double precision :: radii(3), position(3, 3), force(3, 3), overlap, kn, etan, shown, apart(3)
  integer :: phases(3), place(3), who(3), turn, wrong, a, b, L
  character(300) :: load, save, processes
  logical :: on_wall
  call get_command_argument(1, load)
  call get_command_argument(2, save)
  call get_command_argument(3, processes)
  if (processes /= '') read (processes, *) numPEs
  read (*, *) phases(1), radii(1), phases(2), radii(2)
  on_wall = phases(2) == 0
  phases(3) = phases(1)
  radii(3) = radii(1)
  if (on_wall) phases(2) = phases(1)
  if (on_wall) radii(2) = radii(1)
  MAX_PIP = 4 ! the second place is empty
  allocate (PARTICLE_STATE(4), iGLOBAL_ID(4), NEIGHBORS(6), NEIGHBOR_INDEX(4), PIJK(4, 5), DES_RADIUS(4))
  place = [1, 3, 4]
  call sort
  if (load /= '') call platen_load(trim(load))
  do
    read (*, *, iostat=wrong) overlap, turn
    if (wrong /= 0) exit
    if (turn == 1) place = place(3:1:-1)
    if (turn == 1) call sort
    position(:, 1) = 0
    position(:, 2) = (radii(1) + radii(2) - overlap)*n
    if (on_wall) position(:, 2) = 10*radii(1)
    position(:, 3) = -10*radii(1)
    force = 0
    shown = 0
    call platen_begin
    do L = 1, MAX_PIP
      if (PARTICLE_STATE(L) == nonexistent) cycle
      a = who_is(L)
      if (on_wall .and. a == 1 .and. overlap > 0) then
        kn = 1d5
        etan = 1
        call platen_wall(L, 3, overlap, kn, etan)
        force(:, 1) = force(:, 1) - kn*overlap*n
        shown = etan
      end if
      do b = merge(NEIGHBOR_INDEX(max(L - 1, 1)), 1, L > 1), NEIGHBOR_INDEX(L) - 1
        call meet(a, who_is(NEIGHBORS(b)), L, NEIGHBORS(b))
      end do
    end do
    print '(2(es24.16e3))', dot_product(force(:, 1), -n), shown
    if (.not. on_wall .and. any(force(:, 1) /= -force(:, 2))) error stop 'force and counterforce differ'
  end do
  if (save /= '') call platen_save(trim(save))
contains
  subroutine sort ! particles to their places; every pair in the list of the one that comes first
    integer :: k, i
    PARTICLE_STATE = nonexistent
    iGLOBAL_ID = -1
    who = [11, 5, 7]
    do k = 1, 3
      PARTICLE_STATE(place(k)) = normal_particle
      iGLOBAL_ID(place(k)) = who(k)
      PIJK(place(k), 5) = phases(k)
      DES_RADIUS(place(k)) = radii(k)
    end do
    b = 1
    do k = 1, MAX_PIP
      do i = k + 1, MAX_PIP
        if (PARTICLE_STATE(k) == nonexistent .or. PARTICLE_STATE(i) == nonexistent) cycle
        NEIGHBORS(b) = i
        b = b + 1
      end do
      NEIGHBOR_INDEX(k) = b
    end do
  end subroutine

  integer function who_is(at)
    integer, intent(in) :: at
    who_is = findloc(place, at, dim=1)
  end function

  subroutine meet(one, two, at, other)
    integer, intent(in) :: one, two, at, other
    double precision :: gap, between
    apart = position(:, two) - position(:, one)
    gap = norm2(apart)
    between = radii(one) + radii(two) - gap
    if (between <= 0) return
    kn = 1d5
    etan = 1
    call platen_pair(at, other, between, kn, etan)
    force(:, one) = force(:, one) - kn*between*apart/gap
    force(:, two) = force(:, two) + kn*between*apart/gap
    shown = etan
  end subroutine
end program
