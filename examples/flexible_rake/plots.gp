# Tine deflection and drag force of a run: gnuplot -e "run='RUN'" plots.gp draws RUN/deflection.png and RUN/drag.png.
if (!exists("run")) run = "."
set datafile separator ","
set datafile columnheaders
set encoding utf8
set border 3 lw 1 lc rgb "#404040"
set tics nomirror out
set grid lw 1 lc rgb "#e0e0e0"
set xlabel "time [s]"
set key outside right center samplen 1.5 noenhanced
array colour[5] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]
set terminal pngcairo size 900,460 font "DejaVu Sans,11"
history = run."/history.csv"
shoe(i) = sprintf("shoe_%d.x", i)
force(i) = sprintf("tine_%d.contact.fx", i)

set output run."/deflection.png"
set title "How far the ends of the tines are bent back" noenhanced
set ylabel "deflection [mm]"
plot for [i=1:5] history using (column("time")):(1000*(column("carriage.x")-column(shoe(i)))) \
  with lines lw 1.2 lc rgb colour[i] title sprintf("tine %d", i)

set output run."/drag.png"
set title "Force of the grains against the motion" noenhanced
set ylabel "drag force [N]"
plot for [i=1:5] history using (column("time")):(-column(force(i))) with lines lw 0.8 lc rgb colour[i] title sprintf("tine %d", i), \
  history using (column("time")):(-(column(force(1))+column(force(2))+column(force(3))+column(force(4))+column(force(5)))) \
  with lines lw 2 lc rgb "black" title "rake"
