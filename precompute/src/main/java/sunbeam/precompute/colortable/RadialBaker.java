package sunbeam.precompute.colortable;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.spectrum.PowerSpectrum;

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

    private static final int COLORS = 3;

    private final WindowedSpectrum powers;
    private final double sliceStep;
    private final DirectBaker direct;
    private final List<LogRadialBand> bands;
    // First tile of each band; the last entry is the inner disc.
    private final int[] firstTiles;

    public RadialBaker(PowerSpectrum spectrum, CieTable cie, ColorTable.Level level) {
        this(spectrum, cie, level.area(), level.design(), TableSpace.AllLights.REACH, level.includeFaintTails());
    }

    /** Creates a baker for samples up to {@code farthest} |(u, v)|; faint tails of bright orders are 1e-6 of the order. */
    public RadialBaker(
            PowerSpectrum spectrum,
            CieTable cie,
            GaussianArea area,
            TableDesign design,
            double farthest,
            boolean includeFaintTails) {
        this.powers = new WindowedSpectrum(
                spectrum, area.window(), includeFaintTails ? FINE_REACH : COARSE_REACH, !includeFaintTails);
        this.sliceStep = design.sliceStep();
        double sigma = area.window().sigmaFrequency();
        this.direct = new DirectBaker(powers, cie, sigma);
        double rayStep = SPACING * design.step();
        int last = (int) Math.max(0, Math.log(farthest / (2 * INNER_STEPS * rayStep)) / Math.log(2));
        this.bands = IntStream.rangeClosed(0, last)
                .parallel()
                .mapToObj(
                        number -> LogRadialBand.of(cie, spectrum.tolerance(), sigma, farthest / (1 << number), rayStep))
                .toList();
        this.firstTiles = new int[bands.size() + 1];
        for (int band = 0; band < bands.size(); band++) {
            firstTiles[band + 1] = firstTiles[band] + bands.get(band).sectors();
        }
    }

    @Override
    public ColorBaker direct() {
        return direct;
    }

    /** Returns the power at a wavelength in meters, relative to that of a flat mirror in specular direction. */
    public double power(double u, double v, double w, double wavelength) {
        return direct.power(u, v, w, wavelength);
    }

    @Override
    public float[] bake(float[] uvw, ColorBaker.Token token) {
        return bake(uvw, samples -> DepthInterpolation.fewest(samples, sliceStep), token);
    }

    /** Bakes with fixed slices of w: a sample's color does not depend on the other samples. */
    public float[] bakeRepeatably(float[] uvw, ColorBaker.Token token) {
        DepthInterpolation slices = DepthInterpolation.fixed(sliceStep);
        return bake(uvw, samples -> slices, token);
    }

    private float[] bake(float[] uvw, Function<float[], DepthInterpolation> slices, ColorBaker.Token token) {
        int[] tiles = IntStream.range(0, uvw.length / COLORS)
                .parallel()
                .map(sample -> tile(uvw[COLORS * sample], uvw[COLORS * sample + 1]))
                .toArray();
        int middle = firstTiles[bands.size()];
        int[] ends = new int[middle + 1];
        for (int tile : tiles) {
            ends[tile]++;
        }
        Arrays.parallelPrefix(ends, Integer::sum);
        int[] begins = ends.clone();
        int[] order = new int[tiles.length];
        for (int sample = tiles.length - 1; sample >= 0; sample--) {
            order[--begins[tiles[sample]]] = sample;
        }
        float[] xyz = new float[uvw.length];
        int[] filled = IntStream.rangeClosed(0, middle)
                .filter(tile -> begins[tile] < ends[tile])
                .toArray();
        runAll(filled, tile -> {
            int[] samples = Arrays.copyOfRange(order, begins[tile], ends[tile]);
            float[] tileUvw = new float[COLORS * samples.length];
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(uvw, COLORS * samples[i], tileUvw, COLORS * i, COLORS);
            }
            float[] colors = tile == middle
                    ? direct.bake(tileUvw, ColorBaker.Token.NONE)
                    : tile(tile, slices.apply(tileUvw)).bake(tileUvw, token);
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(colors, COLORS * i, xyz, COLORS * samples[i], COLORS);
            }
            token.step(samples.length);
        });
        return xyz;
    }

    private LogRadialBand.Tile tile(int number, DepthInterpolation slices) {
        int band = 0;
        while (number >= firstTiles[band + 1]) {
            band++;
        }
        return bands.get(band).tile(number - firstTiles[band], powers, slices);
    }

    /** If a task fails, waits for the running ones and throws the failure. */
    private static void runAll(int[] tiles, IntConsumer work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        // One task per tile, outer bands first: they take longest.
        ForkJoinTask.invokeAll(IntStream.of(tiles)
                .mapToObj(tile -> ForkJoinTask.adapt(() -> {
                    try {
                        if (failure.get() == null) {
                            work.accept(tile);
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

    private int tile(double u, double v) {
        double radius = Math.sqrt(u * u + v * v);
        int band = 0;
        while (band < bands.size() && radius < bands.get(band).low()) {
            band++;
        }
        return firstTiles[band] + (band < bands.size() ? bands.get(band).sector(u, v) : 0);
    }
}
