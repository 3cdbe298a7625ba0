; OpenBuilds CAM
; Operation: CNC: Vector (path outside)
; Endmill Diameter: 3.175
G21 ; mm-mode
G54; Work Coordinates
G21; mm-mode
G90; Absolute Positioning
M3 S1000; Spindle On
G0 Z10; move to z-safe height
G0 F1000 X1.5875 Y1.5875
G1 F300 Z-1
G1 F800 X20
G1 Y20
M5 S0
G0 Z10
G4 P0.5
$H
