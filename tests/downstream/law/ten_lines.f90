program ten_lines
  use platen_law
  use, intrinsic :: iso_c_binding
  character(kind=c_char, len=200) :: why
  type(platen_law_response) :: now
  real(c_double) :: state(2) = 0 ! platen_law_state_size(law) bytes
  type(c_ptr) :: law ! or of a card: law = platen_law_of_card('granule.toml', 'radius_m=1e-3', message)
  law = platen_law_new('edmans-sinka'//c_null_char, c_null_char, 'radius_m=1e-3 sigma_ref_Pa=8.61e6 E_Pa=4.417e8 nu=0.1472 &
    &k=4.2 delta_t=0.09 a=3.5'//c_null_char, why, len(why, c_size_t))
  if (.not. c_associated(law)) print *, why
  now = platen_law_evaluate(law, state, 4e-4_c_double)
  print '(f0.6, i2)', now%force_N, now%branch
  call platen_law_free(law)
end program
