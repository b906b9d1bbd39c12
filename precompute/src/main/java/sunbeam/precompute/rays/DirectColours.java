package sunbeam.precompute.rays;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthNodes;

/** Colours of single places by a sum over wavelengths: for those near the origin, where rays meet. */
final class DirectColours {
    private static final int CHANNELS = 3;
    // Orders near the origin are wide in ln lambda; this is fine enough for them and for the terms' coefficients.
    private static final double WIDEST_STEP = 0.01;

    private final RaySpectrum spectrum;
    private final WindowedPowers powers;

    DirectColours(RaySpectrum spectrum, WindowedPowers powers) {
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
        List<int[]> columns = columns(asked, places);
        IntStream.range(0, columns.size()).parallel().forEach(i -> {
            int[] column = columns.get(i);
            int first = CHANNELS * column[0];
            double[][] terms = terms(wavelengths, places[first], places[first + 1]);
            for (int place : column) {
                int at = CHANNELS * place;
                int slice = Arrays.binarySearch(depths, Math.abs(places[at + 2]));
                double[] sum = sum(wavelengths, terms, coefficients[slice]);
                for (int c = 0; c < CHANNELS; c++) {
                    xyz[at + c] = (float) Math.max(0, sum[c]);
                }
            }
        });
    }

    /** Places of one (u, v), whose slices share all but the terms' coefficients; they are asked for one after the other. */
    private static List<int[]> columns(RaySector.Places asked, float[] places) {
        int[] numbers = IntStream.range(0, asked.count()).map(asked::number).toArray();
        List<int[]> columns = new ArrayList<>();
        int first = 0;
        for (int i = 1; i <= numbers.length; i++) {
            if (i == numbers.length || !sameDirection(places, numbers[first], numbers[i])) {
                columns.add(Arrays.copyOfRange(numbers, first, i));
                first = i;
            }
        }
        return columns;
    }

    private static boolean sameDirection(float[] places, int one, int other) {
        return places[CHANNELS * one] == places[CHANNELS * other]
                && places[CHANNELS * one + 1] == places[CHANNELS * other + 1];
    }

    /** {@code [term][wavelength]} */
    private double[][] terms(WavelengthNodes wavelengths, double u, double v) {
        double radius = Math.hypot(u, v);
        double[] frequencies = new double[wavelengths.count()];
        for (int i = 0; i < frequencies.length; i++) {
            frequencies[i] = radius / wavelengths.wavelengths()[i];
        }
        double[][] terms = new double[powers.terms()][frequencies.length];
        powers.alongRay(radius == 0 ? 1 : u / radius, radius == 0 ? 0 : v / radius, frequencies, terms);
        return terms;
    }

    private static double[] sum(WavelengthNodes wavelengths, double[][] terms, double[][] coefficients) {
        double[] sum = new double[CHANNELS];
        for (int i = 0; i < coefficients.length; i++) {
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
