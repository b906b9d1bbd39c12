package sunbeam.precompute.rays;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.function.LongConsumer;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.colourtable.ColourSource;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Colours of the ensemble average at many (u, v) in few slices of w: evaluated along rays through the origin, for all
 * wavelengths and places at once ({@link RayConvolution}), and interpolated between them by quintic B-splines through
 * square roots, which err by a tenth of what cubic splines between the places that are asked for will (docs/colour-tables.md).
 *
 * <p>The disc is divided into octaves of |(u, v)|, so that no more rays go inwards than are needed there, and octaves into
 * sectors, of which only those are evaluated that are asked for. Safe for use by several threads.
 */
public final class RayColours implements ColourSource {
    private static final double FARTHEST = 2;
    // Within so many steps of the origin directions are evaluated one by one.
    private static final double INNER_STEPS = 10;
    // Of rays and of places on them, in steps of the table: quintic splines err by less there than cubic ones do at
    // one.
    private static final double SPACING = 1.1;
    private static final int MOST_SLICES = 2048;
    private static final int CHANNELS = 3;
    // exp(-reach^2) of a bin is left out: 1e-10 of it in the finest table, beside which a wing of 1e-6 stays right,
    // 2e-5 in
    // averages for pixels.
    private static final double FINE_REACH = 4.8;
    private static final double COARSE_REACH = 3.3;

    private final RaySpectrum spectrum;
    private final BlurredPowers powers;
    private final double step;
    private final LongConsumer progress;

    /**
     * Colours under a window.
     *
     * @param step of (u, v) between the places that will be asked for
     * @param fine whether wings of bright orders matter
     * @param progress told how many places have been evaluated since it was told last, which may be none, every few milliseconds;
     *     by any thread, which goes on when it returns: whoever waits there holds up the others' work as well
     */
    public RayColours(RaySpectrum spectrum, GaussianArea area, double step, boolean fine, LongConsumer progress) {
        this.spectrum = spectrum;
        this.powers = spectrum.under(area, fine ? FINE_REACH : COARSE_REACH, !fine);
        this.step = SPACING * step;
        this.progress = progress;
    }

    /**
     * @throws IllegalArgumentException if places have more different w than slices are meant
     */
    @Override
    public float[] xyz(float[] places) {
        double[] depths = depths(places);
        List<Octave> octaves = octaves(depths);
        List<RaySector.Places> sectors = new ArrayList<>();
        octaves.forEach(octave -> sectors.addAll(octave.sectors()));
        RaySector.Places direct = new RaySector.Places(null, 0);
        sectors.add(direct);
        int[] sector = sectors(places, octaves);
        for (int i = 0; i < sector.length; i++) {
            sectors.get(sector[i]).add(i);
        }
        float[] xyz = new float[places.length];
        List<ForkJoinTask<?>> tasks = new ArrayList<>();
        for (RaySector.Places some : sectors) {
            if (some != direct && !some.isEmpty()) {
                tasks.add(ForkJoinTask.adapt(() -> {
                    new RaySector(some.octave(), powers, some, () -> progress.accept(0)).evaluate(places, depths, xyz);
                    progress.accept(some.count());
                }));
            }
        }
        // One by one, and not in halves as streams are: those of outer octaves take longest.
        ForkJoinTask.invokeAll(tasks);
        new DirectColours(spectrum, powers).evaluate(direct, places, depths, xyz);
        progress.accept(direct.count());
        return xyz;
    }

    /** The number of each place's sector, octave after octave; behind the last one that of the places in the middle. */
    private static int[] sectors(float[] places, List<Octave> octaves) {
        int[] before = new int[octaves.size() + 1];
        for (int i = 0; i < octaves.size(); i++) {
            before[i + 1] = before[i] + octaves.get(i).sectors().size();
        }
        int[] numbers = new int[places.length / CHANNELS];
        IntStream.range(0, numbers.length).parallel().forEach(i -> {
            double u = places[CHANNELS * i];
            double v = places[CHANNELS * i + 1];
            double radius = Math.sqrt(u * u + v * v);
            int octave = 0;
            while (octave < octaves.size() && radius < octaves.get(octave).low()) {
                octave++;
            }
            numbers[i] = before[octave]
                    + (octave < octaves.size() ? octaves.get(octave).sector(u, v) : 0);
        });
        return numbers;
    }

    private List<Octave> octaves(double[] depths) {
        List<Octave> octaves = new ArrayList<>();
        double high = FARTHEST;
        do {
            octaves.add(new Octave(spectrum, high, step, depths));
            high /= 2;
        } while (high > 2 * INNER_STEPS * step);
        return octaves;
    }

    /** |w| of all places, ascending. */
    private static double[] depths(float[] places) {
        double[] found = new double[MOST_SLICES];
        int count = 0;
        for (int i = 2; i < places.length; i += CHANNELS) {
            double depth = Math.abs(places[i]);
            int at = Arrays.binarySearch(found, 0, count, depth);
            if (at < 0) {
                if (count == MOST_SLICES) {
                    throw new IllegalArgumentException("places lie in more than " + MOST_SLICES + " slices of w");
                }
                System.arraycopy(found, -at - 1, found, -at, count + at + 1);
                found[-at - 1] = depth;
                count++;
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** Rays of an octave of |(u, v)|, and the places on them that belong to each of its sectors. */
    static final class Octave {
        // Rays of a sector; those beside it that splines see come on top.
        private static final int SECTOR_RAYS = 192;
        // Of ln lambda: colour matching functions have weights of their own, and terms' coefficients turn slower.
        private static final double WIDEST_STEP = 0.01;

        private static final double LITTLE_LONGER = 1.12;

        private final RaySpectrum spectrum;
        private final double low;
        private final int rays;
        private final double[] depths;
        private final double widestStep;
        private final List<RaySector.Places> sectors = new ArrayList<>();
        private RayConvolution convolution;
        private WavelengthNodes wavelengths;
        private double start;
        private double logStep;
        private int count;

        Octave(RaySpectrum spectrum, double high, double step, double[] depths) {
            this.spectrum = spectrum;
            this.low = high / 2;
            this.depths = depths;
            this.widestStep = Math.min(step / high, WIDEST_STEP);
            this.rays = (int) Math.ceil(2 * Math.PI * high / step);
            int divided = Math.max(1, rays / SECTOR_RAYS);
            for (int i = 0; i < divided; i++) {
                sectors.add(new RaySector.Places(this, (int) ((long) rays * i / divided)));
            }
        }

        double low() {
            return low;
        }

        int rays() {
            return rays;
        }

        List<RaySector.Places> sectors() {
            return sectors;
        }

        /** Where a place lies among the rays, 0 to {@link #rays()}. */
        double ray(double u, double v) {
            double turns = Math.atan2(v, u) / (2 * Math.PI);
            return (turns < 0 ? turns + 1 : turns) * rays;
        }

        /** The number of a place's sector. */
        int sector(double u, double v) {
            int ray = Math.min(rays - 1, (int) ray(u, v));
            int at = (int) ((long) ray * sectors.size() / rays);
            while (at + 1 < sectors.size() && sectors.get(at + 1).firstRay() <= ray) {
                at++;
            }
            while (sectors.get(at).firstRay() > ray) {
                at--;
            }
            return at;
        }

        /** The first ray beyond a sector. */
        int end(RaySector.Places sector) {
            int next = sectors.indexOf(sector) + 1;
            return next < sectors.size() ? sectors.get(next).firstRay() : rays;
        }

        /** Made when the first sector needs it. */
        synchronized RayConvolution convolution() {
            if (convolution == null) {
                prepare(widestStep);
                int power = Integer.highestOneBit(length() - 1);
                if (length() < LITTLE_LONGER * power) {
                    // A little coarser, transforms are half as long.
                    prepare(widestStep * (length() + 2) / power);
                }
                convolution = new RayConvolution(start, count, wavelengths, depths, spectrum::coefficients);
            }
            return convolution;
        }

        private void prepare(double step) {
            wavelengths = spectrum.wavelengths(step);
            double[] nodes = wavelengths.wavelengths();
            logStep = Math.log(nodes[nodes.length - 1] / nodes[0]) / (nodes.length - 1);
            start = Math.log(low) - QuinticSpline.MARGIN * logStep;
            count = 2 * QuinticSpline.MARGIN + 2 + (int) Math.ceil(Math.log(2) / logStep);
        }

        private int length() {
            return count + wavelengths.count() - 1;
        }

        /** Places on a ray. */
        int count() {
            return count;
        }

        /** Where |(u, v)| lies among the places of a ray. */
        double onRay(double radius) {
            return (Math.log(radius) - start) / logStep;
        }
    }
}
