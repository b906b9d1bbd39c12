package sunbeam.precompute.rays;

import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colortable.ColorColumns;

/** Colors of single places by a sum over wavelengths: for those near the origin, where rays meet, and to validate others with. */
final class DirectColors {
    private static final int CHANNELS = 3;
    // Orders near the origin are wide in ln lambda; this is fine enough for them and for the terms' coefficients.
    private static final double WIDEST_STEP = 0.01;
    // Of ln lambda, beside sigma_f of the window as orders have it: 0.7 of their deviation, as the reference has it,
    // and
    // half of that where light ends on flanks of orders.
    private static final double ORDER_STEP = 0.5;
    private static final double FLANK_STEP = 0.25;

    private final RaySpectrum spectrum;
    private final WindowedPowers powers;
    private final double sigmaFrequency;

    DirectColors(RaySpectrum spectrum, WindowedPowers powers, double sigmaFrequency) {
        this.spectrum = spectrum;
        this.powers = powers;
        this.sigmaFrequency = sigmaFrequency;
    }

    /**
     * Evaluates places at any w.
     *
     * @param places u, v, w of each
     * @return X, Y, Z of each
     */
    float[] xyz(float[] places) {
        int count = places.length / CHANNELS;
        Map<Integer, WavelengthNodes> nodes = new ConcurrentHashMap<>();
        float[] xyz = new float[places.length];
        IntStream.range(0, count).parallel().forEach(place -> {
            int at = CHANNELS * place;
            WavelengthNodes wavelengths = nodes.computeIfAbsent(
                    halvings(Math.hypot(places[at], places[at + 1])),
                    halvings -> spectrum.wavelengths(WIDEST_STEP / (1 << halvings)));
            double depth = Math.abs(places[at + 2]);
            double[][] coefficients = Arrays.stream(wavelengths.wavelengths())
                    .mapToObj(wavelength -> spectrum.coefficients(wavelength, depth))
                    .toArray(double[][]::new);
            double[] sum = sum(wavelengths, terms(wavelengths, places[at], places[at + 1]), coefficients);
            for (int c = 0; c < CHANNELS; c++) {
                xyz[at + c] = (float) Math.max(0, sum[c]);
            }
        });
        return xyz;
    }

    /** How often the widest step is halved so that orders at a place are sampled. */
    private int halvings(double radius) {
        double step = spectrum.isSmooth() ? ORDER_STEP : FLANK_STEP;
        return halvings(WIDEST_STEP, step * sigmaFrequency * spectrum.shortestWavelength() / radius);
    }

    /** How often a step is halved until it is no wider than another. */
    static int halvings(double widest, double step) {
        return step >= widest ? 0 : (int) Math.ceil(Math.log(widest / step) / Math.log(2));
    }

    /**
     * Evaluates some columns.
     *
     * @param asked their numbers
     * @return how many places that were
     */
    long evaluate(int[] asked, ColorColumns columns) {
        WavelengthNodes wavelengths = spectrum.wavelengths(WIDEST_STEP);
        double[] depths = columns.depths();
        double[][][] coefficients = Arrays.stream(depths)
                .mapToObj(depth -> Arrays.stream(wavelengths.wavelengths())
                        .mapToObj(wavelength -> spectrum.coefficients(wavelength, depth))
                        .toArray(double[][]::new))
                .toArray(double[][][]::new);
        return Arrays.stream(asked)
                .parallel()
                .mapToLong(column -> evaluate(wavelengths, coefficients, column, columns))
                .sum();
    }

    /** @param coefficients by slice, wavelength and term */
    private long evaluate(WavelengthNodes wavelengths, double[][][] coefficients, int column, ColorColumns columns) {
        float[] uv = new float[2];
        columns.locate(column, uv);
        double[][] terms = terms(wavelengths, uv[0], uv[1]);
        int[] slices = new int[coefficients.length];
        int count = columns.asked(column, slices);
        for (int i = 0; i < count; i++) {
            double[] sum = sum(wavelengths, terms, coefficients[slices[i]]);
            columns.put(column, slices[i], sum[0], sum[1], sum[2]);
        }
        return count;
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
