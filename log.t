ERROR on proc 0: Cannot open input script in.agarwal: No such file or directory (src/lammps.cpp:520)
Last command: (unknown)
