package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.spectrum.PowerSpectrum;
import sunbeam.precompute.work.Progress;

/**
 * Evaluates colors of the ensemble average along rays of (u, v) through the origin, for all wavelengths and positions of a ray at once
 * ({@link LogPolarConvolution}). Quintic B-splines of the colors' square roots interpolate between rays; their error is a tenth of that of
 * the table's cubic ones (docs/color-tables.md).
 *
 * <p>The disc of (u, v) is divided into bands, one per octave of |(u, v)|, so that inner bands need fewer rays, and these into polar tiles;
 * only tiles that hold a sample are evaluated. Immutable.
 */
public final class RadialBaker implements ColorBaker {
    /** Radius of the inner disc, in steps of the table; rays meet there, so it is baked directly. */
    private static final double INNER_STEPS = 5;
    /** Step between rays, in steps of the table: quintic splines err less at 1.1 than cubic ones at 1. */
    private static final double SPACING = 1.1;
    /** Distance in sigma_f beyond which bins are left out: exp(-reach^2) = 1e-10, so that a tail of 1e-6 stays right. */
    private static final double FINE_REACH = 4.8;
    /** The same for averages over a pixel: exp(-reach^2) = 2e-5. */
    private static final double COARSE_REACH = 3.3;

    // More than there are sectors of 2^31 rays.
    private static final int SECTOR_BITS = 24;

    private final WindowedSpectrum powers;
    private final double sliceStep;
    private final DirectBaker direct;
    private final List<LogRadialBand> bands;

    public RadialBaker(PowerSpectrum spectrum, CieTable cie, ColorTable.Level level) {
        this(spectrum, cie, level.area(), level.design(), TableSpace.AllLights.REACH, level.includeFaintTails());
    }

    /**
     * Creates a baker for samples of a table's density.
     *
     * @param farthest largest |(u, v)| of a sample
     * @param includeFaintTails whether tails of bright orders must be exact down to 1e-6 of the order
     */
    public RadialBaker(
            PowerSpectrum spectrum,
            CieTable cie,
            GaussianArea area,
            TableDesign design,
            double farthest,
            boolean includeFaintTails) {
        this.powers = WindowedSpectrum.of(
                spectrum, area.window(), includeFaintTails ? FINE_REACH : COARSE_REACH, !includeFaintTails);
        this.sliceStep = design.sliceStep();
        double sigma = area.window().sigmaFrequency();
        this.direct = new DirectBaker(cie);
        double rayStep = SPACING * design.step();
        int last = (int) Math.max(0, Math.log(farthest / (2 * INNER_STEPS * rayStep)) / Math.log(2));
        this.bands = IntStream.rangeClosed(0, last)
                .parallel()
                .mapToObj(
                        number -> LogRadialBand.of(cie, spectrum.tolerance(), sigma, farthest / (1 << number), rayStep))
                .toList();
    }

    @Override
    public ColorBaker direct() {
        return direct;
    }

    /** Returns the power at a wavelength in meters, relative to that of a flat mirror in specular direction. */
    public double power(double u, double v, double w, double wavelength) {
        // The truncated sum may be slightly negative in dark directions.
        return Math.max(0, direct.power(powers.new Sums().at(u / wavelength, v / wavelength), wavelength, Math.abs(w)));
    }

    @Override
    public float[] bake(float[] uvw, Progress token) {
        return bake(uvw, samples -> DepthInterpolation.fewest(samples, sliceStep), token);
    }

    /** Bakes with fixed slices of w: a sample's color does not depend on the other samples. */
    public float[] bakeRepeatably(float[] uvw, Progress token) {
        DepthInterpolation slices = DepthInterpolation.equallySpaced(0, ColorTable.DEEPEST, sliceStep);
        return bake(uvw, samples -> slices, token);
    }

    private float[] bake(float[] uvw, Function<float[], DepthInterpolation> slices, Progress token) {
        // Band, sector and sample, sorted: a run of samples for each tile. After the last band comes the inner disc.
        long[] byTile = IntStream.range(0, uvw.length / COLORS)
                .parallel()
                .mapToLong(i -> tile(uvw[COLORS * i], uvw[COLORS * i + 1]) << Integer.SIZE | i)
                .sorted()
                .toArray();
        int[] begins = IntStream.rangeClosed(0, byTile.length)
                .filter(i ->
                        i == 0 || i == byTile.length || byTile[i] >>> Integer.SIZE != byTile[i - 1] >>> Integer.SIZE)
                .toArray();
        float[] xyz = new float[uvw.length];
        runAll(begins.length - 1, run -> {
            int[] samples = Arrays.stream(byTile, begins[run], begins[run + 1])
                    .mapToInt(i -> (int) i)
                    .toArray();
            float[] tileUvw = new float[COLORS * samples.length];
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(uvw, COLORS * samples[i], tileUvw, COLORS * i, COLORS);
            }
            long tile = byTile[begins[run]] >>> Integer.SIZE;
            int band = (int) (tile >>> SECTOR_BITS);
            int sector = (int) (tile - ((long) band << SECTOR_BITS));
            float[] colors = band == bands.size()
                    ? direct.bake(tileUvw, Progress.NONE)
                    : bands.get(band).new Tile(sector, powers, slices.apply(tileUvw)).bake(tileUvw, token);
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(colors, COLORS * i, xyz, COLORS * samples[i], COLORS);
            }
            token.step(samples.length);
        });
        return xyz;
    }

    /** If a task fails, waits for the running ones and throws the failure. */
    private static void runAll(int count, IntConsumer work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        // Outer bands come first: they take longest.
        ForkJoinTask.invokeAll(IntStream.range(0, count)
                .mapToObj(number -> ForkJoinTask.adapt(() -> {
                    try {
                        if (failure.get() == null) {
                            work.accept(number);
                        }
                    } catch (RuntimeException problem) {
                        failure.compareAndSet(null, problem);
                    }
                }))
                .toList());
        if (failure.get() != null) {
            throw failure.get();
        }
    }

    /** Returns a value of a concurrent map, made on first use; two threads may make the same one, neither waits. */
    static <K, V> V known(Map<K, V> values, K key, Function<K, V> maker) {
        V value = values.get(key);
        if (value == null) {
            value = maker.apply(key);
            values.put(key, value);
        }
        return value;
    }

    private long tile(double u, double v) {
        double radius = Math.sqrt(u * u + v * v);
        int band = 0;
        while (band < bands.size() && radius < bands.get(band).low()) {
            band++;
        }
        return (long) band << SECTOR_BITS
                | (band < bands.size() ? bands.get(band).sector(u, v) : 0);
    }

    /** Sums each sample over wavelengths by itself: near the origin of (u, v), where rays meet, and for validation. Thread-safe. */
    final class DirectBaker implements ColorBaker {
        /** Step of ln lambda near the origin, where orders are wide. */
        private static final double WIDEST_STEP = 0.01;
        /** In units of sigma_f / |f|: 0.7 standard deviations of an order's power, as in the reference. */
        private static final double ORDER_STEP = 0.5;
        /** {@link #ORDER_STEP} for light with steep edges, which cut flanks of orders. */
        private static final double FLANK_STEP = 0.25;

        private final CieTable cie;
        private final double orderStep;
        // The key is the number of halvings of WIDEST_STEP.
        private final Map<Integer, WavelengthNodes> nodes = new ConcurrentHashMap<>();

        private DirectBaker(CieTable cie) {
            this.cie = cie;
            this.orderStep =
                    (cie.isSmooth() ? ORDER_STEP : FLANK_STEP) * powers.sigmaFrequency() * cie.shortestWavelength();
        }

        @Override
        public float[] bake(float[] uvw, Progress token) {
            float[] xyz = new float[uvw.length];
            int[] columns = columns(uvw);
            IntStream.range(0, columns.length - 1).parallel().forEach(column -> {
                int first = columns[column];
                double radius = Math.hypot(uvw[COLORS * first], uvw[COLORS * first + 1]);
                WavelengthNodes wavelengths = known(
                        nodes,
                        halvings(WIDEST_STEP, orderStep / radius),
                        halvings -> WavelengthNodes.logarithmic(cie, WIDEST_STEP / (1 << halvings), 0));
                int end = columns[column + 1];
                double[] sums = new double[COLORS * (end - first)];
                WindowedSpectrum.Sums terms = powers.new Sums();
                for (int i = 0; i < wavelengths.count(); i++) {
                    double wavelength = wavelengths.wavelengths()[i];
                    double[] atWavelength =
                            terms.at(uvw[COLORS * first] / wavelength, uvw[COLORS * first + 1] / wavelength);
                    for (int sample = first; sample < end; sample++) {
                        double power = power(atWavelength, wavelength, Math.abs(uvw[COLORS * sample + 2]));
                        for (int c = 0; c < COLORS; c++) {
                            sums[COLORS * (sample - first) + c] +=
                                    power * wavelengths.weights()[i][c];
                        }
                    }
                }
                for (int i = 0; i < sums.length; i++) {
                    xyz[COLORS * first + i] = (float) Math.max(0, sums[i]);
                }
                token.step(end - first);
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

        private double power(double[] terms, double wavelength, double depth) {
            double[] coefficients = powers.bins().coefficients(wavelength, depth);
            double power = 0;
            for (int m = 0; m < coefficients.length; m++) {
                power += coefficients[m] * terms[m];
            }
            return power;
        }
    }
}
