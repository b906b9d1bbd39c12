package sunbeam.precompute.plan;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;
import sunbeam.precompute.setting.Excess;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.text.Text;

/** Upper estimate of the memory that a plan needs: peak size in Java's heap, and all arrays on the graphics card. */
public record MemoryNeed(long heapBytes, List<ArrayLayout> textures) {
    static final long MOST_TEXTURE_BYTES = 3L << 30;
    /** Limit of one texture in Mesa's software renderer: less than 1536 MiB, since it reserves coarser mip levels. */
    public static final long LARGEST_TEXTURE_BYTES = 1500L << 20;
    /** Limits that OpenGL 3.3 drivers in use support. */
    static final long LONGEST_SIDE = 16384;

    static final long MOST_LAYERS = 2048;
    // Large arrays leave gaps in the heap, and the program needs the rest.
    private static final double USABLE_HEAP = 0.8;
    private static final long TERM_BYTES = 2 * Float.BYTES;
    private static final long COMPLEX_BYTES = 2 * Double.BYTES;

    static MemoryNeed of(SpectrumPlan plan, MethodUse use, int rows) {
        Band bandX = plan.bandX();
        Band bandY = plan.bandY();
        long table = TERM_BYTES * plan.expansion().terms() * bandX.count() * bandY.count();
        // A pair of real terms is transformed in one symmetric band, up to twice as wide along each axis.
        long transform = COMPLEX_BYTES
                * ((long) rows + bandY.symmetric().count())
                * bandX.symmetric().count();
        return new MemoryNeed(table + Math.max(transform, plan.sampling().workBytes(plan)), plan.layouts(use));
    }

    public static MemoryNeed of(SpectrumPlan plan, int rows) {
        return Arrays.stream(MethodUse.values())
                .map(use -> of(plan, use, rows))
                .max(Comparator.comparingLong(MemoryNeed::textureBytes))
                .orElseThrow();
    }

    public MemoryNeed and(ArrayLayout texture) {
        return new MemoryNeed(
                heapBytes, Stream.concat(textures.stream(), Stream.of(texture)).toList());
    }

    public long textureBytes() {
        return textures.stream().mapToLong(ArrayLayout::bytes).sum();
    }

    private long largest(ToLongFunction<ArrayLayout> size) {
        return textures.stream().mapToLong(size).max().orElse(0);
    }

    /** Returns which limit is exceeded. */
    Optional<Excess> excess(long heapLimit) {
        long longestSide = largest(layout -> Math.max(layout.width(), layout.height()));
        if (longestSide > LONGEST_SIDE) {
            return excess(
                    "textures of %d texels along a side, more than the %d of common drivers",
                    longestSide, LONGEST_SIDE);
        }
        long layers = largest(ArrayLayout::layers);
        if (layers > MOST_LAYERS) {
            return excess("a texture of %d layers, more than the %d of common drivers", layers, MOST_LAYERS);
        }
        long largestTextureBytes = largest(ArrayLayout::bytes);
        if (largestTextureBytes > LARGEST_TEXTURE_BYTES) {
            return excess(
                    "a texture of %s, more than the %s that common drivers give to one",
                    inWords(largestTextureBytes), inWords(LARGEST_TEXTURE_BYTES));
        }
        long textureBytes = textureBytes();
        if (textureBytes > MOST_TEXTURE_BYTES) {
            return excess(
                    "%s of textures, more than the %s that Sunbeam takes",
                    inWords(textureBytes), inWords(MOST_TEXTURE_BYTES));
        }
        if (heapBytes > USABLE_HEAP * heapLimit) {
            String words = Text.format(
                    "need %s of memory, but Java's heap may take %s", inWords(heapBytes), inWords(heapLimit));
            return Optional.of(new Excess(words, (long) (heapBytes / USABLE_HEAP)));
        }
        return Optional.empty();
    }

    private static Optional<Excess> excess(String what, Object... numbers) {
        return Optional.of(Excess.ofDriver(Text.format("need " + what, numbers)));
    }

    static String inWords(long bytes) {
        return bytes < 1_000_000_000 ? Text.format("%.0f MB", bytes * 1e-6) : Text.format("%.1f GB", bytes * 1e-9);
    }
}
