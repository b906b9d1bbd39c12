package sunbeam.precompute.rays;

import java.util.Arrays;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthNodes;

/** Colours of single places by a sum over wavelengths: for those near the origin, where rays meet. */
final class DirectColours {
    private static final int CHANNELS = 3;
    // Orders near the origin are wide in ln lambda; this is fine enough for them and for the terms' coefficients.
    private static final double WIDEST_STEP = 0.01;

    private final RaySpectrum spectrum;
    private final BlurredPowers powers;

    DirectColours(RaySpectrum spectrum, BlurredPowers powers) {
        this.spectrum = spectrum;
        this.powers = powers;
    }

    /**
     * Evaluates some places.
     *
     * @param asked their numbers
     * @param places u, v, w of each place
     * @param depths |w| of the slices, ascending
     * @param xyz takes X, Y, Z of each place
     */
    void evaluate(RaySector.Places asked, float[] places, double[] depths, float[] xyz) {
        if (asked.isEmpty()) {
            return;
        }
        WavelengthNodes wavelengths = spectrum.wavelengths(WIDEST_STEP);
        double[][][] coefficients = Arrays.stream(depths)
                .mapToObj(depth -> Arrays.stream(wavelengths.wavelengths())
                        .mapToObj(wavelength -> spectrum.coefficients(wavelength, depth))
                        .toArray(double[][]::new))
                .toArray(double[][][]::new);
        IntStream.range(0, asked.count()).parallel().forEach(i -> {
            int at = CHANNELS * asked.number(i);
            int slice = Arrays.binarySearch(depths, Math.abs(places[at + 2]));
            double[] sum = sum(wavelengths, places[at], places[at + 1], coefficients[slice]);
            for (int c = 0; c < CHANNELS; c++) {
                xyz[at + c] = (float) Math.max(0, sum[c]);
            }
        });
    }

    private double[] sum(WavelengthNodes wavelengths, double u, double v, double[][] coefficients) {
        double radius = Math.hypot(u, v);
        double[] frequencies = new double[wavelengths.count()];
        for (int i = 0; i < frequencies.length; i++) {
            frequencies[i] = radius / wavelengths.wavelengths()[i];
        }
        double[][] terms = new double[powers.terms()][frequencies.length];
        powers.alongRay(radius == 0 ? 1 : u / radius, radius == 0 ? 0 : v / radius, frequencies, terms);
        double[] sum = new double[CHANNELS];
        for (int i = 0; i < frequencies.length; i++) {
            double power = 0;
            for (int m = 0; m < terms.length; m++) {
                power += coefficients[i][m] * terms[m][i];
            }
            for (int c = 0; c < CHANNELS; c++) {
                sum[c] += power * wavelengths.weights()[i][c];
            }
        }
        return sum;
    }
}
