package sunbeam.app.render;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import sunbeam.app.scene.SceneColor;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.text.Text;

/** Pixels of a picture or a tile, means of samples: linear light, and colors on a display. */
public final class PixelPicture {
    private static final int CHANNELS = 4;

    // Standard error of the mean root of a channel's display light, as of random samples: least, about 1 in lightness,
    // and share of the root, 4 % of the light. Samples at regular places err by about half as much, 2 %.
    private static final double UNSURE = 0.01;
    private static final double UNSURE_SHARE = 0.02;

    private final ScenePicture light;
    private final BufferedImage image;
    private final DisplayTransform display;
    private final double[] behind;

    /** Creates black pixels without mesh. */
    PixelPicture(int width, int height, DisplayTransform display, SceneColor background) {
        this(ScenePicture.empty(width, height), display, background.light());
    }

    private PixelPicture(ScenePicture light, DisplayTransform display, double[] behind) {
        this.light = light;
        this.image = new BufferedImage(light.width(), light.height(), BufferedImage.TYPE_INT_RGB);
        this.display = display;
        this.behind = behind;
    }

    /** Returns black pixels of the same size and display. */
    PixelPicture like() {
        return new PixelPicture(ScenePicture.empty(light.width(), light.height()), display, behind);
    }

    /** Returns opaque sRGB of one sample per pixel, over the background, which is not exposed. */
    public static BufferedImage image(ScenePicture picture, DisplayTransform display, SceneColor background) {
        PixelPicture pixels = new PixelPicture(picture.width(), picture.height(), display, background);
        pixels.setAll(picture, 1, 1);
        return pixels.image;
    }

    /** Returns means of samples (see {@link ScenePicture#reduced}). */
    public ScenePicture light() {
        return light;
    }

    /** Returns opaque sRGB, over the background, which is not exposed. */
    public BufferedImage image() {
        return image;
    }

    BitSet setAll(ScenePicture samples, int across, int down) {
        BitSet all = new BitSet();
        all.set(0, light.width() * light.height());
        return set(all, samples, across, down);
    }

    /**
     * Sets pixels to means of their samples, transformed to display light first, so that thin bright lines keep their color and smooth
     * edges.
     *
     * @param pixels indices, row by row
     * @param samples samples of all pixels, {@code across x down} for each
     * @return those of these pixels whose means are unsure
     */
    BitSet set(BitSet pixels, ScenePicture samples, int across, int down) {
        boolean[] unsure = new boolean[light.width() * light.height()];
        IntStream.range(0, light.height()).parallel().forEach(row -> {
            Mean mean = new Mean(samples);
            int end = (row + 1) * light.width();
            for (int i = pixels.nextSetBit(end - light.width()); i >= 0 && i < end; i = pixels.nextSetBit(i + 1)) {
                unsure[i] = mean.set(i, across, down);
            }
        });
        return IntStream.range(0, unsure.length).filter(i -> unsure[i]).collect(BitSet::new, BitSet::set, BitSet::or);
    }

    /** Not thread-safe. */
    private final class Mean {
        private final int[] rgb = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        private final ScenePicture samples;
        private final double[] sample = new double[CHANNELS - 1];
        private final double[] sum = new double[CHANNELS - 1];
        private final double[] roots = new double[CHANNELS - 1];
        private int last = -1;

        Mean(ScenePicture samples) {
            this.samples = samples;
        }

        /** True if the mean is unsure. */
        boolean set(int pixel, int across, int down) {
            Arrays.fill(sum, 0);
            Arrays.fill(roots, 0);
            int corner = pixel / light.width() * down * samples.width() + pixel % light.width() * across;
            for (int y = 0; y < down; y++) {
                for (int x = 0; x < across; x++) {
                    add(CHANNELS * (corner + y * samples.width() + x));
                }
            }
            light.setMean(pixel, samples, corner, across, down);
            int count = across * down;
            boolean isUnsure = false;
            for (int c = 0; c < sum.length; c++) {
                sum[c] /= count;
                double root = roots[c] / count;
                double most = Math.max(UNSURE, UNSURE_SHARE * root);
                isUnsure |= sum[c] - root * root > most * most * count;
            }
            rgb[pixel] = DisplayTransform.packed(sum);
            return isUnsure;
        }

        private void add(int from) {
            float[] rgba = samples.rgba();
            // A pixel's samples of the ground are equal and need one transform.
            if (last < 0 || !Arrays.equals(rgba, last, last + CHANNELS, rgba, from, from + CHANNELS)) {
                // The sample's light is premultiplied by coverage.
                float uncovered = Math.max(0, 1 - rgba[from + CHANNELS - 1]);
                display.light(rgba, from, sample);
                for (int c = 0; c < sample.length; c++) {
                    sample[c] = Math.min(1, sample[c] + uncovered * behind[c]);
                }
                last = from;
            }
            for (int c = 0; c < sum.length; c++) {
                sum[c] += sample[c];
                roots[c] += Math.sqrt(sample[c]);
            }
        }
    }

    /** Pixels that a mesh fills by half or more, and the lit ones among them, with an sRGB channel of {@link #LEAST_CODE} or more. */
    public record LitPixels(long lit, long filled) {
        public static final LitPixels NONE = new LitPixels(0, 0);

        /** Visible beside bright pixels, of 255. */
        private static final int LEAST_CODE = 8;

        /**
         * With fewer, a picture is black with specks: a grating of 2 um on a bare sphere lights 0.7 % at 320 x 240 pixels and 3 % at 64 x
         * 48, a snake's nanostructure 77 %.
         */
        private static final double LEAST_SHARE = 0.05;

        private static final double LEAST_LIGHT = Srgb.linear(LEAST_CODE);

        /** Counts whole pixels, not their samples. */
        public static LitPixels of(ScenePicture pixels, DisplayTransform display) {
            double[] light = new double[3];
            long lit = 0;
            long filled = 0;
            for (int from = 0; from < pixels.rgba().length; from += 4) {
                if (pixels.rgba()[from + 3] >= 0.5f) {
                    filled++;
                    display.light(pixels.rgba(), from, light);
                    lit += Math.max(light[0], Math.max(light[1], light[2])) >= LEAST_LIGHT ? 1 : 0;
                }
            }
            return new LitPixels(lit, filled);
        }

        public LitPixels plus(LitPixels other) {
            return new LitPixels(lit + other.lit, filled + other.filled);
        }

        /** Share of the mesh's pixels that are lit, 0 to 1; 0 without mesh. */
        public double share() {
            return filled == 0 ? 0 : (double) lit / filled;
        }

        /** True if so few pixels are lit that the picture is probably a mistake. */
        public boolean areTooFew() {
            return share() < LEAST_SHARE;
        }

        public String summary() {
            double percent = 100 * share();
            String text = percent < 10 ? Text.format("%.2g", percent) : Text.format("%.0f", percent);
            return "lit: " + text + " % of " + filled + " pixels that the mesh fills";
        }

        /** Returns one line about too few lit pixels, with a remedy. */
        public String complaint() {
            return filled == 0
                    ? "the picture shows no mesh; move the camera"
                    : Text.format(
                            "only %.2g %% of the mesh is lit: the light goes elsewhere, or is too weak; move the light, or raise"
                                    + " roughness, the weights or the exposure",
                            100 * share());
        }
    }
}
