# histories of inputs/laws/rft_upright.toml, one after another -> alpha_z of the upright plate by depth, as rft_depths.awk has it, and what the law says with zeta.
BEGIN { FS = ","; width = 0.05; area = width^2; law = 0.206 + 0.169 * cos(3.14159265) + 0.212 * sin(1.5 * 3.14159265) + 0.358 + 0.055 * sin(-0.5 * 3.14159265)
        print "| radius of the grains [m] | thickness and one grain [mm] | alpha_z of 1 to 2 widths [N/cm^3] | of 2 to 3 | of 1 to 3 |\n|---|---|---|---|---|" }
function finish() { if (radius != "") printf "| %s | %g | %.3f | %.3f | %.3f |\n", radius, 6 + 2000 * radius, f[1] / d[1] / 1e6, f[2] / d[2] / 1e6, (f[1] + f[2]) / (d[1] + d[2]) / 1e6; delete f; delete d }
/^#/ { finish(); radius = FILENAME; sub(/.*radius_/, "", radius); sub(/__seed.*/, "", radius); named = 0; next }
!named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
{ depth = -radius - $column["plate.z"]; range = int(depth / width); if (range < 1 || range > 2) next
  d[range] += depth^2; f[range] += depth * $column["plate.contact.fz"] / area }
END { finish(); printf "\nThe law says %.3f zeta.\n", law }
