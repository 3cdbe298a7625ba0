( Made using CamBam - http://www.cambam.co.uk )
( Untitled 3/4/2015 10:10:10 AM )
( T1 : 3.0 )
G21 G90 G91.1 G64 G40
G0 Z3.0
( T1 : 3.0 )
T1 M6
( Profile1 )
G17
M3 S1000
G0 X-1.5 Y20.0
G0 Z1.0
G1 F300.0 Z-1.0
G1 F800.0 Y40.0
G2 X0.0 Y41.5 I1.5 J0.0
G1 X40.0
G2 X41.5 Y40.0 I0.0 J-1.5
G1 Y20.0
S1000
G0 Z3.0
M5
M30
