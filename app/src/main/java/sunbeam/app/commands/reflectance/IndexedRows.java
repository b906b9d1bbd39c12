package sunbeam.app.commands.reflectance;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.input.DirectionList;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * Rows of another material than the standard one, whose power is the same: rho in proportion to its own flat mirror along the
 * normal (of a tabulated index, to the mean of that by luminance), the BRDF with its own reflectance.
 */
public record IndexedRows(RefractiveIndex index, CieTable cie) {
    private static final int RHO = 2;
    private static final int BRDF = 3;
    private static final int GAIN = 3;

    /** Results of the material, of those of the standard one. */
    public List<double[]> of(DirectionList list, List<double[]> results) {
        if (index.isStandard()) {
            return results;
        }
        double mirror = ReflectionPart.mirror(index, cie);
        return IntStream.range(0, list.size())
                .mapToObj(row -> row(list, row, results.get(row).clone(), mirror))
                .toList();
    }

    private double[] row(DirectionList list, int row, double[] values, double mirror) {
        DirectionPair pair = list.pair(row);
        double wavelength = list.spectral() ? list.wavelength(row) : CieTable.MINIMUM_WAVELENGTH;
        double over = index.reflectance(wavelength, pair.cosThetaD()) / Gain.reflectance(pair.cosThetaD());
        if (list.spectral()) {
            values[RHO] *= over * Gain.R0 / mirror;
            values[BRDF] *= over;
        } else {
            values[GAIN] *= over * Gain.R0 / mirror;
        }
        return values;
    }
}
