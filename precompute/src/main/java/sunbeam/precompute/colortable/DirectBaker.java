package sunbeam.precompute.colortable;

import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;

/** Sums each sample over wavelengths by itself: near the origin of (u, v), where rays meet, and for validation. Thread-safe. */
final class DirectBaker implements ColorBaker {
    private static final int COLORS = 3;
    /** Step of ln lambda near the origin, where orders are wide. */
    private static final double WIDEST_STEP = 0.01;
    /** In units of sigma_f / |f|: 0.7 standard deviations of an order's power, as in the reference. */
    private static final double ORDER_STEP = 0.5;
    /** {@link #ORDER_STEP} for light with steep edges, which cut flanks of orders. */
    private static final double FLANK_STEP = 0.25;

    private final WindowedSpectrum powers;
    private final CieTable cie;
    private final double orderStep;
    // The key is the number of halvings of WIDEST_STEP.
    private final ConcurrentHashMap<Integer, WavelengthNodes> nodes = new ConcurrentHashMap<>();

    DirectBaker(WindowedSpectrum powers, CieTable cie, double sigmaFrequency) {
        this.powers = powers;
        this.cie = cie;
        this.orderStep = (cie.isSmooth() ? ORDER_STEP : FLANK_STEP) * sigmaFrequency * cie.shortestWavelength();
    }

    @Override
    public float[] bake(float[] uvw, ColorBaker.Token token) {
        float[] xyz = new float[uvw.length];
        int[] columns = columns(uvw);
        IntStream.range(0, columns.length - 1).parallel().forEach(column -> {
            int first = columns[column];
            double radius = Math.hypot(uvw[COLORS * first], uvw[COLORS * first + 1]);
            WavelengthNodes wavelengths = wavelengths(halvings(WIDEST_STEP, orderStep / radius));
            double[][] terms = terms(wavelengths.wavelengths(), uvw[COLORS * first], uvw[COLORS * first + 1]);
            for (int sample = first; sample < columns[column + 1]; sample++) {
                put(wavelengths, terms, Math.abs(uvw[COLORS * sample + 2]), xyz, COLORS * sample);
            }
            token.step(columns[column + 1] - first);
        });
        return xyz;
    }

    /** Returns the first sample of each run of samples with the same (u, v), then the number of samples. */
    static int[] columns(float[] uvw) {
        int count = uvw.length / COLORS;
        return IntStream.rangeClosed(0, count)
                .filter(i -> i == 0
                        || i == count
                        || uvw[COLORS * i] != uvw[COLORS * i - COLORS]
                        || uvw[COLORS * i + 1] != uvw[COLORS * i - COLORS + 1])
                .toArray();
    }

    static int halvings(double widest, double step) {
        return step >= widest ? 0 : (int) Math.ceil(Math.log(widest / step) / Math.log(2));
    }

    private WavelengthNodes wavelengths(int halvings) {
        WavelengthNodes known = nodes.get(halvings);
        if (known == null) {
            // Two threads may compute the same nodes; neither waits.
            known = WavelengthNodes.logarithmic(cie, WIDEST_STEP / (1 << halvings), 0);
            nodes.put(halvings, known);
        }
        return known;
    }

    private double[][] terms(double[] wavelengths, double u, double v) {
        double[][] terms = new double[wavelengths.length][];
        WindowedSpectrum.Sums sums = powers.sums();
        for (int i = 0; i < wavelengths.length; i++) {
            terms[i] = sums.at(u / wavelengths[i], v / wavelengths[i]).clone();
        }
        return terms;
    }

    private void put(WavelengthNodes nodes, double[][] terms, double depth, float[] xyz, int at) {
        double[] sum = new double[COLORS];
        for (int i = 0; i < terms.length; i++) {
            double power = power(terms[i], nodes.wavelengths()[i], depth);
            for (int c = 0; c < COLORS; c++) {
                sum[c] += power * nodes.weights()[i][c];
            }
        }
        for (int c = 0; c < COLORS; c++) {
            xyz[at + c] = (float) Math.max(0, sum[c]);
        }
    }

    private double power(double[] terms, double wavelength, double depth) {
        double[] coefficients = powers.coefficients(wavelength, depth);
        double power = 0;
        for (int m = 0; m < coefficients.length; m++) {
            power += coefficients[m] * terms[m];
        }
        return power;
    }

    /** The truncated sum may be slightly negative in dark directions, hence the clamp. */
    double power(double u, double v, double w, double wavelength) {
        return Math.max(0, power(powers.sums().at(u / wavelength, v / wavelength), wavelength, Math.abs(w)));
    }
}
