(Exported by FreeCAD)
(Post Processor: grbl_post)
(Begin preamble)
G17 G90
G21
(Begin operation: TC: 5mm Drill)
(Path: TC: 5mm Drill)
(TC: 5mm Drill)
(Begin toolchange)
M6 T1
M3 S3000
(Begin operation: Drilling)
G0 Z10.000
G90
G98
G0 X5.000 Y5.000
G81 X5.000 Y5.000 Z-4.000 R1.000 F100.000
G81 X15.000 Y5.000 Z-4.000 R1.000 F100.000
G80
G0 Z10.000
(Begin postamble)
M5
G17 G90
M2
