# gnuplot -c rft_form.gp POINTS: POINTS has a row "beta gamma alpha_x alpha_z" for each pair [deg, deg, N/cm^3, N/cm^3], as rft_depths.awk writes it.
# Fits the nine coefficients of resistive force theory's Fourier series (mbd_solver/cli/rigs/rft_rig.cpp) to them by least squares; prints R^2 as the rig has it, the coefficients,
# and what they say of the plate that moves in its own plane. Of plates that go in and come out also R^2 of those that go in.
points = ARG1
set fit quiet logfile '/dev/null'
set angles degrees
fz(b, g) = A00 + A10 * cos(2 * b) + B11 * sin(2 * b + g) + B01 * sin(g) + Bm11 * sin(-2 * b + g)
fx(b, g) = C11 * cos(2 * b + g) + C01 * cos(g) + Cm11 * cos(-2 * b + g) + D10 * sin(2 * b)
A00 = 0.206; A10 = 0.169; B11 = 0.212; B01 = 0.358; Bm11 = 0.055; C11 = -0.124; C01 = 0.253; Cm11 = 0.007; D10 = 0.088
printed = sprintf("| printed | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |", A00, A10, B11, B01, Bm11, C11, C01, Cm11, D10)
lawz = fz(-30, 30); lawx = fx(-30, 30)
fit fz(x, y) points using 1:2:4 via A00, A10, B11, B01, Bm11
fit fx(x, y) points using 1:2:3 via C11, C01, Cm11, D10
stats points using ($3 + $4) nooutput name 'both'
mean = both_mean / 2
stats points using (($3 - mean)**2 + ($4 - mean)**2) nooutput name 'all'
stats points using (($3 - fx($1, $2))**2 + ($4 - fz($1, $2))**2) nooutput name 'left'
stats points using ($1 == -30 && $2 == 30 ? $3 : NaN) nooutput name 'planex'
stats points using ($1 == -30 && $2 == 30 ? $4 : NaN) nooutput name 'planez'
stats points using ($2 > 0 ? $3 + $4 : NaN) nooutput name 'bothin'
meanin = bothin_mean / 2
stats points using ($2 > 0 ? ($3 - meanin)**2 + ($4 - meanin)**2 : NaN) nooutput name 'allin'
stats points using ($2 > 0 ? ($3 - fx($1, $2))**2 + ($4 - fz($1, $2))**2 : NaN) nooutput name 'leftin'
set print '-'
print sprintf("R^2 of the form with nine coefficients of its own: %.3f%s.\n", 1 - left_sum / all_sum, \
  bothin_records < both_records ? sprintf("; of the plates that go in alone %.3f", 1 - leftin_sum / allin_sum) : "")
print "| coefficients [N/cm^3] | A00 | A10 | B11 | B01 | B-11 | C11 | C01 | C-11 | D10 |"
print "|---|---|---|---|---|---|---|---|---|---|"
print printed
print sprintf("| of our stresses | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |", A00, A10, B11, B01, Bm11, C11, C01, Cm11, D10)
print ""
print "| beta = -30, gamma = 30 degrees [N/cm^3] | alpha_x | alpha_z |"
print "|---|---|---|"
print sprintf("| printed coefficients, without their scalar | %.3f | %.3f |", lawx, lawz)
print sprintf("| the form with coefficients of its own | %.3f | %.3f |", fx(-30, 30), fz(-30, 30))
print sprintf("| found | %.3f | %.3f |", planex_mean, planez_mean)
