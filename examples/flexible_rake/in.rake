# The grains' side of examples/flexible_rake: a settled bed, and five beams of the scene that touch it.
#   mpirun -np 2 liggghts_mbd -in in.rake -var bed BED -var out DIR : -np 1 mbd_solver scene.toml --out DIR --set particles.grains=BED.grains
variable here   index .
variable bed    index bed.restart
variable out    index .
variable length index 0.6        # as in in.bed
variable width  index 0.28
variable dt     index 5e-5       # [s]
variable every  index 2          # substeps per window
variable frames index 0.1        # [s] between dumps of the grains
variable half   equal 0.5*${width}

atom_modify map array
newton off
communicate single vel yes
units si
hard_particles yes
processors * * 1
read_restart ${bed}
neighbor 0.003 bin
neigh_modify delay 0
include ${here}/material.lammps
include ${here}/walls.lammps
timestep ${dt}
fix gravity all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere

# The bodies come from the scene, which moves and bends them; each tine is a beam of its own to the grains.
fix rake all wall/gran/beam model hertz tangential history rolling_friction cdt type 2 &
  body tine_1 body tine_2 body tine_3 body tine_4 body tine_5
fix mbd all couple/mbd every ${every}

thermo_style custom step atoms f_rake[1] f_rake[3][1] f_rake[7] f_rake[8] f_mbd[2] cpu
thermo 1000
thermo_modify lost warn norm no
variable stride equal round(${frames}/${dt})
dump grains all custom ${stride} ${out}/grains_*.txt id x y z vx vy vz radius

# The scene's end time ends the run.
run 1000000000
