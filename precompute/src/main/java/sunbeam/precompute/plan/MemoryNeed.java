package sunbeam.precompute.plan;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TERMS;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Locale;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.resample.AxisGrid;
import sunbeam.precompute.setting.SettingException;

/**
 * What a plan takes, estimated from above before any of it is taken.
 *
 * @param heapBytes tables and work space in Java's heap at their peak
 * @param textureBytes on the graphics card
 * @param longestSide texels along the longest side of a texture
 */
record MemoryNeed(long heapBytes, long textureBytes, long longestSide) {
    /** The most that textures of one plan may take: what small graphics cards have. */
    static final long MOST_TEXTURE_BYTES = 3L << 30;

    /** The longest side that drivers of OpenGL 3.3 in use have in common. */
    static final long LONGEST_SIDE = 16384;

    // Arrays this large leave gaps in the heap; some of it is the program's own.
    private static final double USABLE_HEAP = 0.8;
    private static final long TERM_BYTES = 2 * Float.BYTES;
    private static final long COMPLEX_BYTES = 2 * Double.BYTES;
    private static final long TEXEL_BYTES = 4 * Float.BYTES;

    /** @param rows of the patch */
    static MemoryNeed of(Plan plan, int rows) {
        int terms = plan.expansion().terms();
        MemoryNeed table = ofBins(rows, terms, plan.bandX(), plan.bandY());
        return plan.sampling() instanceof Sampling.Grid grid
                ? ofGrid(grid, plan.window().sigmaFrequency(), plan.range(), table, terms)
                : table;
    }

    /** A Fourier table and its textures. */
    private static MemoryNeed ofBins(int rows, int terms, Band bandX, Band bandY) {
        long bins = (long) bandX.count() * bandY.count();
        long table = TERM_BYTES * terms * bins;
        // A band of two real terms is transformed as one that is symmetric, up to twice as wide each way.
        long lines = (long) rows + bandY.symmetric().count();
        long transform = COMPLEX_BYTES * lines * bandX.symmetric().count();
        return new MemoryNeed(table + transform, table, Math.max(bandX.count(), bandY.count()));
    }

    /** The same table resampled; see sunbeam.app.gpu.GridTextures. */
    private static MemoryNeed ofGrid(
            Sampling.Grid grid, double sigmaFrequency, VisibleRange range, MemoryNeed table, int terms) {
        int taps = grid.interpolation().taps();
        // The ensemble's Gaussian is narrower by sqrt(2) and its fields, about twice the terms, are real: four a texel,
        // where two complex terms share one.
        double step = sigmaFrequency / Math.sqrt(2) / grid.interpolation().deviation();
        AxisGrid pointX = range.gridX(step, taps);
        AxisGrid pointY = range.gridY(step, taps);
        AxisGrid nodesX = range.gridX(grid.nodeStep(), 1);
        AxisGrid nodesY = range.gridY(grid.nodeStep(), 1);
        long width = Math.max(nodesX.count(), nodesY.count());
        long height = Math.max(pointX.count(), pointY.count());
        long layers = (terms + 1L) / 2;
        // Single wavelengths take both averages on both axes; colours take two sets of rays.
        long points = layers * pointX.count() * pointY.count() * 3 / 2;
        long rays = 2 * layers * width * height;
        long turnedTerms = COMPLEX_BYTES / TERM_BYTES * table.textureBytes();
        long oneLayer = TEXEL_BYTES * Math.max(width * height, (long) pointX.count() * pointY.count());
        return new MemoryNeed(
                table.textureBytes() + Math.max(table.heapBytes(), 2 * turnedTerms + 2 * oneLayer),
                TEXEL_BYTES * Math.max(points, rays),
                Math.max(width, height));
    }

    boolean fits(long heapLimit) {
        return heapBytes <= USABLE_HEAP * heapLimit
                && textureBytes <= MOST_TEXTURE_BYTES
                && longestSide <= LONGEST_SIDE;
    }

    /**
     * Refuses what does not fit.
     *
     * @param heapLimit largest size of the heap, bytes
     * @throws SettingException when more is needed than there is
     */
    void require(long heapLimit, Plan plan) {
        if (fits(heapLimit)) {
            return;
        }
        String what = String.format(
                Locale.ROOT,
                "and %d x %d DFT bins in %d terms",
                plan.bandX().count(),
                plan.bandY().count(),
                plan.expansion().terms());
        if (longestSide > LONGEST_SIDE) {
            throw complaint(
                    plan,
                    "%s need textures of %d texels along a side, more than the %d of common drivers"
                            .formatted(what, longestSide, LONGEST_SIDE),
                    "");
        }
        if (textureBytes > MOST_TEXTURE_BYTES) {
            throw complaint(
                    plan,
                    "%s need %s of textures, more than the %s that Sunbeam takes"
                            .formatted(what, inWords(textureBytes), inWords(MOST_TEXTURE_BYTES)),
                    "");
        }
        throw complaint(
                plan,
                "%s need %s of memory, but Java's heap may take %s"
                        .formatted(what, inWords(heapBytes), inWords(heapLimit)),
                " or SUNBEAM_JAVA_OPTIONS=-Xmx%dm".formatted((long) (heapBytes / USABLE_HEAP / (1 << 20)) + 1));
    }

    private static SettingException complaint(Plan plan, String problem, String otherRemedy) {
        return SettingException.of(
                COHERENCE_LENGTH,
                plan.window().coherenceLength(),
                problem + "; crop the patch, or give a coarser ",
                TOLERANCE,
                ", fewer ",
                TERMS,
                " or another ",
                COHERENCE_LENGTH,
                otherRemedy);
    }

    private static String inWords(long bytes) {
        return bytes < 1_000_000_000
                ? String.format(Locale.ROOT, "%.0f MB", bytes * 1e-6)
                : String.format(Locale.ROOT, "%.1f GB", bytes * 1e-9);
    }
}
