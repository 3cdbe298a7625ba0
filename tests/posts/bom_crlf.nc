%
O0010 	(bom file)
	G21 G90	
 T1 M6 (6mm End Mill)
/ M8
/2 G0 X0 Y0 S1000 M3 
G0 Z5.
G1 Z-1. F100 
X10.


G0 Z5.
M30
%
