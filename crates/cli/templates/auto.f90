! [[ title ]]: periodic solutions with one impact in [[ loops ]] forcing periods, for AUTO-07p. Made by grazing.
!
! The flight from recoil to impact is a boundary value problem over 0 <= s <= 1 with the unknowns
!   U(1), U(2)  distance from the wall and its rate, negative where the wall has not been reached;  U(3)  time
! and the parameters
!   PAR(1)  [[ names[0] ]], called mu, PAR(2)  [[ names[1] ]], called eta, PAR(3)  phase of the impact, PAR(4)  its velocity
! all in the units of the description. A limit point is a saddle-node bifurcation; where PAR(4) = 0 solutions graze. Whether
! the flight goes through the wall on its way is not looked at.

MODULE grazing_formulas
  IMPLICIT NONE
  DOUBLE PRECISION, PARAMETER :: turns = [[ loops ]]*6.283185307179586476925286766559d0
CONTAINS
[% for function in functions %]
[[ function ]]
[%- endfor %]
  ! The time from recoil to impact.
  PURE DOUBLE PRECISION FUNCTION flight(par)
    DOUBLE PRECISION, INTENT(IN) :: par(*)
    flight = (turns - grazing_duration([par(4), par(3), par(1), par(2)])*par(4))/grazing_frequency(par(1:2))
  END FUNCTION flight
END MODULE grazing_formulas

SUBROUTINE FUNC(NDIM,U,ICP,PAR,IJAC,F,DFDU,DFDP)
  USE grazing_formulas
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), IJAC
  DOUBLE PRECISION, INTENT(IN) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(OUT) :: F(NDIM)
  DOUBLE PRECISION, INTENT(INOUT) :: DFDU(NDIM,NDIM), DFDP(NDIM,*)
  F(1) = flight(PAR)*U(2)
  F(2) = flight(PAR)*grazing_force([U(1), U(2), U(3), PAR(1), PAR(2)])
  F(3) = flight(PAR)
END SUBROUTINE FUNC

SUBROUTINE BCND(NDIM,PAR,ICP,NBC,U0,U1,FB,IJAC,DBC)
  USE grazing_formulas
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM, ICP(*), NBC, IJAC
  DOUBLE PRECISION, INTENT(IN) :: PAR(*), U0(NDIM), U1(NDIM)
  DOUBLE PRECISION, INTENT(OUT) :: FB(NBC)
  DOUBLE PRECISION, INTENT(INOUT) :: DBC(NBC,*)
  DOUBLE PRECISION :: impact(4)
  impact = [PAR(4), PAR(3), PAR(1), PAR(2)]
  FB(1) = U0(1)
  FB(2) = U0(2) + grazing_restitution(impact)*PAR(4)
  FB(3) = U0(3) - (PAR(3) + grazing_duration(impact)*PAR(4))/grazing_frequency(PAR(1:2))
  FB(4) = U1(1)
  FB(5) = U1(2) - PAR(4)
END SUBROUTINE BCND

SUBROUTINE STPNT(NDIM,U,PAR,T)
  IMPLICIT NONE
  INTEGER, INTENT(IN) :: NDIM
  DOUBLE PRECISION, INTENT(INOUT) :: U(NDIM), PAR(*)
  DOUBLE PRECISION, INTENT(IN) :: T
[%- for value in start %]
  PAR([[ loop.index ]]) = [[ value ]]
[%- endfor %]
END SUBROUTINE STPNT

SUBROUTINE ICND
END SUBROUTINE ICND

SUBROUTINE FOPT
END SUBROUTINE FOPT

SUBROUTINE PVLS
END SUBROUTINE PVLS
