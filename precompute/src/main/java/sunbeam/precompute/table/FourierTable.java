package sunbeam.precompute.table;

import java.util.Optional;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;

/**
 * DFT bins of the terms T_n(h) of one patch, cropped to what is visible.
 *
 * @param patch where the heights came from
 * @param kind the expansion
 * @param scale maps heights to the expansion's argument
 * @param bandX bins along x; frequency = bin / width
 * @param bandY bins along y (upwards); frequency = bin / height
 * @param real {@code [term][row * bandX.count() + column]}, rows of ascending jy, columns of ascending jx; origin of the
 *     phases at sample (0, 0), the top left
 * @param imaginary as {@code real}
 * @param coefficients sampled c_n(zeta), for expansions without a closed form
 */
public record FourierTable(
        PatchIdentity patch,
        ExpansionKind kind,
        HeightScale scale,
        Band bandX,
        Band bandY,
        float[][] real,
        float[][] imaginary,
        Optional<CoefficientTable> coefficients) {

    public FourierTable {
        if (real.length == 0 || real.length != imaginary.length) {
            throw new IllegalArgumentException("terms missing: " + real.length + " and " + imaginary.length);
        }
        long size = (long) bandX.count() * bandY.count();
        for (int n = 0; n < real.length; n++) {
            if (real[n].length != size || imaginary[n].length != size) {
                throw new IllegalArgumentException("term " + n + " has not the band's size " + size);
            }
        }
    }

    public int terms() {
        return real.length;
    }

    public long bytes() {
        return 8L * terms() * bandX.count() * bandY.count();
    }
}
