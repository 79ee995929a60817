! Platen's laws as normal forces of MFiX-DEM. UNTESTED INSIDE MFiX: compiled against a stub of its variables alone
! (tests/downstream/adapters), where forces are those of `platen eval`. Needs include/platen_law.f90. Which lines of MFiX
! call this, and what stands in platen.dat: docs/how-to/other-dem-codes.md. Memory is kept under the global numbers of the
! bodies: new lists of neighbours, sorting and restarts leave it as it is. It ends when they part, as in LAMMPS.
module platen_mfix
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit, int64
  use compar, only: numPEs
  use discretelement, only: COLLISION_ARRAY_MAX, DES_COLL_MODEL_ENUM, DES_RADIUS, iGLOBAL_ID, LSD, MAX_PIP, NEIGHBOR_INDEX, &
    PARTICLE_STATE, PIJK, normal_particle, entering_particle, exiting_particle
  use param, only: DIM_M
  use platen_law
  use run, only: UNITS
  implicit none
  private
  public :: platen_begin, platen_pair, platen_wall, platen_save, platen_load

  type :: contact
    integer :: partner = 0 ! its global number, or minus the facet of a wall
    real(c_double) :: state(2) = 0 ! of the law
    integer(int64) :: last = -1 ! step in which the bodies last touched
  end type
  type :: rule ! a line of platen.dat
    integer :: first = 0 ! phase of the card
    character(400) :: card = '', parameters = ''
  end type
  type(rule) :: rules(0:DIM_M, DIM_M) ! row 0: walls
  type(c_ptr) :: laws(0:DIM_M, DIM_M) = c_null_ptr
  double precision :: radius(0:DIM_M) = 0 ! of each phase; a plane has any
  type(contact), allocatable :: contacts(:, :) ! of each particle
  integer, allocatable :: owner(:) ! its global number, of a ghost 0
  integer(int64) :: step = 0
  integer(c_int), parameter :: version = 1 ! of the state
contains

  subroutine platen_begin ! once a step, before the first contact, by one thread
    integer :: L, slots, number(MAX_PIP)
    if (.not. allocated(owner)) call start
    number = 0
    do L = 1, MAX_PIP
      if (all(PARTICLE_STATE(L) /= [normal_particle, entering_particle, exiting_particle])) cycle
      number(L) = iGLOBAL_ID(L)
      if (DES_RADIUS(L) /= radius(PIJK(L, 5))) call meet(PIJK(L, 5), DES_RADIUS(L))
    end do
    slots = maxval(NEIGHBOR_INDEX(:MAX_PIP) - [1, NEIGHBOR_INDEX(:MAX_PIP - 1)]) + 2*COLLISION_ARRAY_MAX
    L = min(size(owner), MAX_PIP)
    if (slots > size(contacts, 1) .or. size(owner) /= MAX_PIP .or. any(owner(:L) /= number(:L))) &
      call place(max(slots, size(contacts, 1)), number)
    step = step + 1
  end subroutine

  !> Spring [N/m] and damping [N s/m] of particles L and I; in: MFiX's, out: the law's, its force is overlap*kn [N].
  subroutine platen_pair(L, I, overlap, kn, etan)
    integer, intent(in) :: L, I
    double precision, intent(in) :: overlap
    double precision, intent(inout) :: kn, etan
    integer :: s, k
    s = slot(L, iGLOBAL_ID(I))
    if (contacts(s, L)%last < 0 .and. owner(I) > 0) then ! until now the other may have had this one in its list
      k = findloc(contacts(:, I)%partner == owner(L) .and. contacts(:, I)%last == step - 1, .true., dim=1)
      if (k > 0) contacts(s, L)%state = contacts(k, I)%state
    end if
    call follow(contacts(s, L), PIJK(I, 5), PIJK(L, 5), overlap, kn, etan)
  end subroutine

  subroutine platen_wall(L, NF, overlap, kn, etan) ! the same of particle L on facet NF of a wall
    integer, intent(in) :: L, NF
    double precision, intent(in) :: overlap
    double precision, intent(inout) :: kn, etan
    call follow(contacts(slot(L, -NF), L), 0, PIJK(L, 5), overlap, kn, etan)
  end subroutine

  !> Damping is c = 2 sqrt(5/6) |ln e|/sqrt(ln^2 e + pi^2) sqrt(m dF/dgamma): MFiX's for a spring of 5/6 of the stiffness.
  !> A Hertzian contact returns e; its force, which MFiX adds up, may pull for a moment as the bodies part.
  subroutine follow(it, other, phase, overlap, kn, etan)
    type(contact), intent(inout) :: it
    integer, intent(in) :: other, phase
    double precision, intent(in) :: overlap
    double precision, intent(inout) :: kn, etan
    type(platen_law_response) :: now
    if (.not. c_associated(laws(other, phase))) call stop_with('platen.dat has no line for phases (0: walls)', [phase, other])
    now = platen_law_evaluate(laws(other, phase), it%state, overlap)
    it%last = step
    etan = etan*sqrt(5*now%stiffness_N_per_m/(6*kn))
    kn = now%force_N/overlap
  end subroutine

  integer function slot(L, partner) result(s) ! where particle L keeps that contact; of a new one `last` is -1
    integer, intent(in) :: L, partner
    integer :: free
    free = 0
    do s = 1, size(contacts, 1)
      if (contacts(s, L)%last < step - 1) free = s
      if (contacts(s, L)%partner == partner .and. free /= s) return
    end do
    if (free == 0) call stop_with('too many contacts of particle', [owner(L)])
    s = free
    contacts(s, L) = contact(partner)
  end function

  subroutine place(slots, number) ! moves what particles remember to where they are now
    integer, intent(in) :: slots, number(:)
    type(contact), allocatable :: now(:, :)
    integer :: L, was(0:max(0, maxval(owner), maxval(number)))
    was = 0
    do L = 1, size(owner)
      was(owner(L)) = L
    end do
    was(0) = 0
    allocate (now(slots, size(number)))
    do L = 1, size(number)
      if (was(number(L)) > 0) now(:size(contacts, 1), L) = contacts(:, was(number(L)))
    end do
    call move_alloc(now, contacts)
    owner = number
  end subroutine

  subroutine meet(phase, R) ! a phase is first seen: its laws with all that were, and with walls
    integer, intent(in) :: phase
    double precision, intent(in) :: R
    character(:), allocatable :: why
    character(80) :: radii
    integer :: q, one
    if (radius(phase) > 0) call stop_with('particles of more than one radius are of phase', [phase])
    if (all(rules(:, phase)%first == 0)) call stop_with('platen.dat has no line for phase', [phase])
    radius(phase) = R
    do q = 0, DIM_M
      one = rules(q, phase)%first
      if (one == 0 .or. radius(q) <= 0) cycle
      if (q == 0) write (radii, '(a, es23.16e3, a)') ' radius_m=', R, &
        merge(' against=plane', '              ', index(' '//rules(0, phase)%parameters, ' radius2_m=') == 0)
      if (q > 0) write (radii, '(2(a, es23.16e3))') ' radius_m=', radius(one), ' radius2_m=', radius(phase + q - one)
      laws(q, phase) = platen_law_of_card(trim(rules(q, phase)%card), trim(rules(q, phase)%parameters)//radii, why)
      if (.not. c_associated(laws(q, phase))) call stop_with(why)
      if (platen_law_state_version(laws(q, phase)) /= version) call stop_with('the library is of another version')
    end do
    laws(phase, :) = laws(1:, phase)
  end subroutine

  subroutine start
    character(1000) :: line, second
    type(rule) :: r
    integer :: unit, wrong, other
    allocate (contacts(0, 0), owner(0))
    radius(0) = 1
    if (numPEs > 1 .or. UNITS /= 'SI' .or. DES_COLL_MODEL_ENUM /= LSD) &
      call stop_with('one process, UNITS SI and DES_COLL_MODEL LSD are needed')
    open (newunit=unit, file='platen.dat', status='old', action='read', iostat=wrong)
    if (wrong /= 0) call stop_with('platen.dat is not there')
    do
      read (unit, '(a)', iostat=wrong) line
      if (wrong /= 0) exit
      line = line(:index(line//'#', '#') - 1)
      if (line == '') cycle
      r = rule()
      other = 0
      read (line, *, iostat=wrong) r%first, second, r%card, r%parameters ! the last may be missing
      if (wrong <= 0 .and. second /= 'wall') read (second, *, iostat=wrong) other
      if (wrong > 0 .or. min(r%first, merge(1, other, second == 'wall')) < 1 .or. max(r%first, other) > DIM_M .or. r%card == '') &
        call stop_with("platen.dat: '"//trim(line)//"' is not: phase, phase or wall, card, parameters")
      if (rules(other, r%first)%first > 0) call stop_with('platen.dat has two lines for phases (0: walls)', [r%first, other])
      rules(other, r%first) = r
      if (other > 0) rules(r%first, other) = r
    end do
    close (unit)
  end subroutine

  subroutine platen_save(file)
    character(*), intent(in) :: file
    integer :: unit
    if (.not. allocated(owner)) call start
    open (newunit=unit, file=file, form='unformatted', access='stream', status='replace')
    write (unit) version, step, shape(contacts), owner, contacts
    close (unit)
  end subroutine

  subroutine platen_load(file)
    character(*), intent(in) :: file
    integer(c_int) :: theirs
    integer :: unit, wrong, n(2)
    if (.not. allocated(owner)) call start
    theirs = 0
    open (newunit=unit, file=file, form='unformatted', access='stream', status='old', iostat=wrong)
    if (wrong == 0) read (unit, iostat=wrong) theirs, step, n
    if (wrong /= 0 .or. theirs /= version) call stop_with('no memory of contacts of this version is in '//file)
    deallocate (contacts, owner)
    allocate (contacts(n(1), n(2)), owner(n(2)))
    read (unit, iostat=wrong) owner, contacts
    if (wrong /= 0) call stop_with('the memory of contacts is cut off in '//file)
    close (unit)
  end subroutine

  subroutine stop_with(why, numbers)
    character(*), intent(in) :: why
    integer, intent(in), optional :: numbers(:)
    if (present(numbers)) write (error_unit, '(a, *(1x, i0))') 'platen: '//why, numbers
    if (.not. present(numbers)) write (error_unit, '(a)') 'platen: '//why
    error stop 1
  end subroutine
end module
