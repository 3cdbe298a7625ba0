%
(1002)
(Using G0 which travels along dogleg path.)
(T1   D=0.5 CR=0. - ZMIN=-0.25 - flat end mill)
G90 G54 G64 G50 G17 G40 G80 G94 G91.1 G49
G20 (Inch)
G30

N10(2D Adaptive1)
T1 G43 H1 M6
S4000 M3 M8
G54
G0 X1.0 Y1.0
Z0.6
Z0.2
G1 Z0.1 F20.
G3 X1.0 Y1.0 Z-0.05 I0.1 J0. F20.
G3 X1.0 Y1.0 Z-0.25 I0.1 J0.
G3 X1.2 Y1.0 I0.1 J0. 
G1 X2.
G0 Z0.6
M5 M9
G30
M30
%
