! SPDX-License-Identifier: MIT
!
! The two calls of a team in Fortran; fortran_entry.c has the table of functions.
subroutine team_decide(robots, ball_x, ball_y, wheels) bind(c)
  use iso_c_binding
  integer(c_int32_t), value :: robots
  real(c_double), value :: ball_x, ball_y
  real(c_double), intent(out) :: wheels(2, robots)
  real(c_double), allocatable :: weights(:)
  character(len=20) :: text
  integer :: i
  allocate(weights(robots))
  weights = [(real(i, c_double), i = 1, robots)]
  do i = 1, robots
    wheels(1, i) = 10.0d0 * weights(i) / sum(weights) + ball_x
    wheels(2, i) = 10.0d0 + ball_y
  end do
  write (text, '(f8.3)') ball_x
  if (len_trim(text) == 0) wheels = 0.0d0
end subroutine
