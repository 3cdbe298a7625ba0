G21
G90
(zero X, Y and Z on the lower left corner of the board)
M6 T1 (6mm flat endmill)
G92 X0 Y0 Z0
G0 Z5
M3 S12000
G0 X10 Y10
G1 Z-3 F200
G1 X60 F800
G0 Z20
M5
M0 (change to the 3mm ball nose, zero Z on the surface)
M6 T2 (3mm ball nose)
G92 Z0
G0 Z5
M3 S15000
G0 X10 Y30
G1 Z-1 F200
G1 X60 F800
G0 Z5
M5
M30
