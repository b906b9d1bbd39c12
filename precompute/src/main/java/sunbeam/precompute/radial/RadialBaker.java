package sunbeam.precompute.radial;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.colortable.BakeToken;
import sunbeam.precompute.colortable.ColorBaker;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.TableSpace;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Bakes colors of the ensemble average at many (u, v, w): evaluated along rays of (u, v) through the origin, for all wavelengths and places
 * at once ({@link LogPolarConvolution}), and interpolated between them by quintic B-splines through square roots, which err by a tenth of what
 * cubic splines between the samples will (docs/color-tables.md).
 *
 * <p>The disc is divided into bands of |(u, v)|, each twice as far out as the next, so that no more rays go inwards than are needed there, and
 * bands into tiles, of which those are evaluated that hold a sample. Immutable, safe for use by several threads.
 */
public final class RadialBaker implements ColorBaker {
    /** Within so many steps of the origin, where rays meet, samples are evaluated one by one. */
    private static final double INNER_STEPS = 5;
    /** Of rays and of places on them, in steps of the table: quintic splines err by less there than cubic ones do at one. */
    private static final double SPACING = 1.1;
    /** Samples whose tiles one processor finds at a time. */
    private static final int SAMPLES_PER_TASK = 1 << 14;
    /** exp(-reach^2) of a bin is left out: 1e-10, beside which a tail of 1e-6 stays right. */
    private static final double FINE_REACH = 4.8;
    /** Leaves out 2e-5: for averages of pixels. */
    private static final double COARSE_REACH = 3.3;

    private static final int COLORS = 3;

    private final WindowedSpectrum powers;
    private final double sliceStep;
    private final DirectBaker direct;
    // The outermost first.
    private final List<LogRadialBand> bands;
    // Number of each band's first tile; behind them that of the middle, where rays meet.
    private final int[] firstTiles;

    /** Bakes a level of a table of all directions. */
    public RadialBaker(PowerSpectrum spectrum, CieTable cie, ColorTable.Level level) {
        this(
                spectrum,
                cie,
                level.area(),
                level.design().step(),
                level.design().sliceStep(),
                TableSpace.AllLights.REACH,
                level.includeFaintTails());
    }

    /**
     * Bakes colors under a window.
     *
     * @param cie observer and illuminant
     * @param step distance in (u, v) of the samples
     * @param sliceStep distance in w of slices that four at a time suffice to interpolate
     * @param farthest largest |(u, v)| of a sample; rays are as close there as the step says
     * @param includeFaintTails whether tails of bright orders matter
     */
    public RadialBaker(
            PowerSpectrum spectrum,
            CieTable cie,
            GaussianArea area,
            double step,
            double sliceStep,
            double farthest,
            boolean includeFaintTails) {
        this.powers = spectrum.under(area.window(), includeFaintTails ? FINE_REACH : COARSE_REACH, !includeFaintTails);
        this.sliceStep = sliceStep;
        double sigma = area.window().sigmaFrequency();
        this.direct = new DirectBaker(powers, cie, sigma);
        double rayStep = SPACING * step;
        int last = (int) Math.max(0, Math.log(farthest / (2 * INNER_STEPS * rayStep)) / Math.log(2));
        this.bands = IntStream.rangeClosed(0, last)
                .parallel()
                .mapToObj(number ->
                        new LogRadialBand(cie, spectrum.widestPlaces(), sigma, farthest / (1 << number), rayStep))
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

    /**
     * Power at a wavelength, 1 for a flat mirror in specular direction.
     *
     * @param wavelength metres, 380e-9 to 780e-9
     */
    public double power(double u, double v, double w, double wavelength) {
        return direct.power(u, v, w, wavelength);
    }

    @Override
    public float[] bake(float[] uvw, BakeToken token) {
        return bake(uvw, samples -> DepthInterpolation.fewest(samples, sliceStep), token);
    }

    /** As {@link #bake}, so that the color of a sample does not depend on the batch that it is in. */
    public float[] bakeRepeatably(float[] uvw, BakeToken token) {
        DepthInterpolation slices = DepthInterpolation.fixed(sliceStep);
        return bake(uvw, samples -> slices, token);
    }

    private float[] bake(float[] uvw, Function<float[], DepthInterpolation> slices, BakeToken token) {
        int[] tiles = tiles(uvw);
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
            float[] some = new float[COLORS * samples.length];
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(uvw, COLORS * samples[i], some, COLORS * i, COLORS);
            }
            float[] colors = tile == middle
                    ? direct.bake(some, BakeToken.NONE)
                    : tile(tile, slices.apply(some)).bake(some, token);
            for (int i = 0; i < samples.length; i++) {
                System.arraycopy(colors, COLORS * i, xyz, COLORS * samples[i], COLORS);
            }
            token.step(samples.length);
        });
        return xyz;
    }

    private PolarTile tile(int number, DepthInterpolation slices) {
        int band = 0;
        while (number >= firstTiles[band + 1]) {
            band++;
        }
        return new PolarTile(bands.get(band), number - firstTiles[band], powers, slices);
    }

    /** Beside each other; if one fails, none is going on any more when its failure is thrown. */
    private static void runAll(int[] tiles, IntConsumer work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        // One by one, and not in halves as streams are: those of outer bands take longest.
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

    /** The number of each sample's tile. */
    private int[] tiles(float[] uvw) {
        int[] tiles = new int[uvw.length / COLORS];
        int tasks = (tiles.length + SAMPLES_PER_TASK - 1) / SAMPLES_PER_TASK;
        IntStream.range(0, tasks).parallel().forEach(task -> {
            int first = task * SAMPLES_PER_TASK;
            int end = Math.min(tiles.length, first + SAMPLES_PER_TASK);
            for (int i = first; i < end; i++) {
                float u = uvw[COLORS * i];
                float v = uvw[COLORS * i + 1];
                boolean same = i > first && u == uvw[COLORS * i - COLORS] && v == uvw[COLORS * i - COLORS + 1];
                tiles[i] = same ? tiles[i - 1] : tile(u, v);
            }
        });
        return tiles;
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
