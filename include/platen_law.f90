! The contact laws from Fortran 2008: what platen_law.h declares, and laws of cards, which C does not read. Compile this file
! with your own; link -lplaten_law -lstdc++.
module platen_law
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: platen_law_response, platen_law_new, platen_law_free, platen_law_state_size, platen_law_state_version, &
    platen_law_evaluate, platen_law_of_card

  type, bind(C) :: platen_law_response
    real(c_double) :: force_N, stiffness_N_per_m, contact_radius_m, mean_pressure_Pa, dissipated_work_J
    integer(c_int) :: branch, in_range
  end type

  interface ! texts end with c_null_char
    type(c_ptr) function platen_law_new(law, variant, parameters, message, message_size) bind(C)
      import
      character(kind=c_char) :: law(*), variant(*), parameters(*), message(*)
      integer(c_size_t), value :: message_size
    end function
    subroutine platen_law_free(law) bind(C)
      import
      type(c_ptr), value :: law
    end subroutine
    integer(c_size_t) function platen_law_state_size(law) bind(C)
      import
      type(c_ptr), value :: law
    end function
    integer(c_int) function platen_law_state_version(law) bind(C)
      import
      type(c_ptr), value :: law
    end function
    type(platen_law_response) function platen_law_evaluate(law, state, overlap_m) bind(C)
      import
      type(c_ptr), value :: law
      real(c_double) :: state(*)
      real(c_double), value :: overlap_m
    end function
  end interface
contains

  !> The law of a card, for instance with parameters = 'radius_m=1e-3 against=plane', as `platen eval -p`. Where something is
  !> wrong it is c_null_ptr, and `message` says what. Lists in a card must end on their line; its [validity] is not looked at.
  type(c_ptr) function platen_law_of_card(card, parameters, message) result(made)
    character(*), intent(in) :: card, parameters
    character(:), allocatable, intent(out) :: message
    integer, parameter :: longest = 65536
    character(longest) :: line
    character(kind=c_char, len=1000) :: why
    character(:), allocatable :: section, key, law, variant, all
    integer :: unit, wrong, equals
    logical :: opened
    made = c_null_ptr
    message = ''
    section = ''
    law = ''
    variant = ''
    all = parameters
    open (newunit=unit, file=card, status='old', action='read', iostat=wrong)
    opened = wrong == 0
    if (.not. opened) message = 'cannot read the law card '//card
    do while (wrong == 0)
      read (unit, '(a)', iostat=wrong) line
      if (wrong /= 0) exit
      line = adjustl(line)
      equals = index(line, '=')
      if (line(1:1) == '[') section = trim(line)
      if (line == '' .or. scan(line(1:1), '#[') > 0) cycle
      key = trim(line(:max(equals - 1, 0)))
      if (index(section, '[parameters]') == 1) then
        all = all//' '//key//'='//bare(line(equals + 1:))
        if (index(line, '[') > 0 .and. index(line, ']') == 0) message = card//': the list '//key//' must end on its line'
      else if (key == 'law') then
        law = bare(line(equals + 1:))
      else if (key == 'variant') then
        variant = bare(line(equals + 1:))
      else if (section == '' .and. key /= 'platen') then
        message = card//": '"//trim(line)//"' is not of a law card"
      end if
      if (line(longest:) /= '') message = card//': a line is too long'
      if (message /= '') exit
    end do
    if (opened) close (unit)
    if (message == '' .and. law == '') message = card//': law is missing'
    if (message /= '') return
    made = platen_law_new(law//c_null_char, variant//c_null_char, all//c_null_char, why, len(why, c_size_t))
    if (.not. c_associated(made)) message = card//': '//why(:index(why, c_null_char) - 1)
  end function

  !> A value of a card without quotes, brackets, blanks and comment.
  function bare(value)
    character(*), intent(in) :: value
    character(:), allocatable :: bare
    integer :: i
    bare = ''
    do i = 1, len_trim(value)
      if (value(i:i) == '#') exit
      if (scan(value(i:i), '"''[] '//achar(9)//achar(13)) == 0) bare = bare//value(i:i)
    end do
  end function
end module
