(Project part)
(Created by Estlcam version 11 build 11.245)
(Machining time about 00:05:00 hours)
(Required tools:)
(End mill 4mm)
G21
G90
M03 S24000
G00 Z5.0000
(No. 1: Part 1)
M00 (Change tool to End mill 4mm)
G00 X10.0000 Y5.0000
G00 Z0.5000
G01 Z-1.0000 F600
G01 X40.0000 F1800
G03 X45.0000 Y10.0000 I0.0000 J5.0000
G01 Y30.0000
G00 Z5.0000
M05
M30
