package sunbeam.precompute.table;

import java.util.Optional;
import sunbeam.precompute.expansion.CoefficientTable;
import sunbeam.precompute.expansion.ExpansionKind;
import sunbeam.precompute.expansion.HeightScale;
import sunbeam.precompute.fourier.Band;

/**
 * DFT bins of an expansion's terms T_n(h) over one patch, limited to the visible frequencies.
 *
 * @param scale map from heights to the argument s of T_n(s)
 * @param bandX bins along x; frequency = bin / width
 * @param bandY bins along y, ascending with y
 * @param real real parts {@code [term][row * bandX.count() + column]}, rows and columns in ascending order of bins; phases refer to sample
 *     (0, 0), at the top left
 * @param imaginary imaginary parts, in the order of {@code real}
 * @param coefficients sampled c_n(zeta); empty for Taylor's series, whose coefficients have a closed form
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
