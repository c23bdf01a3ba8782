# awk -f filled.awk BED.grains...: the share of the space that grains fill, by layers of 20 mm below the surface z = 0, within 0.15 m of the middle; the mean over the beds.
# A sphere counts with what lies between the planes of a layer.
function below(x, r) { if (x < -r) x = -r; if (x > r) x = r; return 3.14159265358979 * (r * r * x - x * x * x / 3) }
FNR == 1 { ++beds; grains = 0 }
/^ITEM: ATOMS/ { grains = 1; next }
grains && $1 * $1 < 0.0225 && $2 * $2 < 0.0225 { for (k = 0; k < 4; ++k) filled[k] += below(-0.02 * k - 0.01 - $3, $4) - below(-0.02 * k - 0.03 - $3, $4) }
END { for (k = 0; k < 4; ++k) printf " | %.3f", filled[k] / (0.09 * 0.02 * beds); printf "\n" }
