package sunbeam.app.scene;

import java.util.Arrays;
import jrtr.FloatFormat;
import jrtr.FloatTargetSpec;
import jrtr.FloatTextureSpec;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.Opening;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.CutLoops;

/** Runs the costly shader for the pixels that show skin and for no other, packed (see {@link Packing}). */
final class PackedShading implements AutoCloseable {
    private static final int CHANNELS = 4;
    // Side of the squares in which pixels are taken up, so that neighbors stay neighbors.
    private static final int SQUARE = 4;

    private final RenderContext context;
    private final FloatTexture sources;
    private final FloatTarget target;
    private final float[] slots = new float[Packing.MOST];

    PackedShading(RenderContext context) {
        this.context = context;
        this.sources = context.createFloatTexture(
                "sources", FloatTextureSpec.flat(Packing.COLUMNS, Packing.ROWS, FloatFormat.R32F));
        this.target = Opening.orClose(
                () -> context.createFloatTarget(
                        "packed radiance", FloatTargetSpec.color(Packing.COLUMNS, Packing.ROWS)),
                sources::close);
    }

    /**
     * Lights a part of a block. Where the skin's colors are made as they are looked at, those that are missing are, unless a scheduler
     * makes them.
     *
     * @param buffer the block, with that part drawn, and its neighbors for what its pixels see of colors
     * @param part counted from the block's corner
     * @param stride each stride-th pixel of each stride-th row is lit, and stands for those to its right and below
     * @param samplesAcross of the mesh along a side of a pixel
     * @return linear XYZ and coverage, 4 values a lit pixel, the part's top row first; zeros where there is no skin; where colors are
     *     missing, the body with a coverage of -1
     */
    float[] shade(SkinSurface skin, Scene scene, GeometryBuffer buffer, Tile part, int stride, int samplesAcross) {
        int[] covered = covered(buffer.views(part), part, stride);
        float[] lit =
                new float[CHANNELS * SceneSession.few(part.width(), stride) * SceneSession.few(part.height(), stride)];
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = Packing.of(Math.min(Packing.MOST, covered.length - first));
            upload(packing, covered, first, buffer, part, stride);
            Tile used = packing.used();
            skin.footprints()
                    .ifPresent(footprints -> footprints.find(scene, buffer, stride, samplesAcross, sources, used));
            float[] drawn = CutLoops.checked(shade(skin, scene, buffer, packing, used, samplesAcross));
            for (int i = 0; i < packing.count(); i++) {
                copy(drawn, CHANNELS * i, lit, CHANNELS * covered[first + i]);
            }
        }
        return lit;
    }

    /** Lights what was uploaded: 4 values for each of the packing's. */
    private float[] shade(
            SkinSurface skin, Scene scene, GeometryBuffer buffer, Packing packing, Tile used, int samplesAcross) {
        if (skin.footprints().isEmpty() || scene.blend().diffraction() == 0) {
            return drawn(skin, scene, buffer, packing, used, skin.draws(scene, samplesAcross));
        }
        SkinFootprints footprints = skin.footprints().get();
        boolean isScheduled = footprints.tiles().isScheduled();
        // Most are drawn by what was made for them before, which need not be found out first.
        if (isScheduled || footprints.tiles().tiles() > 0) {
            float[] drawn = drawn(skin, scene, buffer, packing, used, 1);
            if (isScheduled || !SkinFootprints.isMissing(drawn)) {
                return drawn;
            }
        }
        footprints.note(packing, used);
        footprints.tiles().make();
        float[] drawn = drawn(skin, scene, buffer, packing, used, 1);
        if (SkinFootprints.isMissing(drawn)) {
            throw new IllegalStateException("a pixel looks into colors that were not noted for it");
        }
        return drawn;
    }

    private float[] drawn(SkinSurface skin, Scene scene, GeometryBuffer buffer, Packing packing, Tile used, int draws) {
        float[] sums = new float[CHANNELS * packing.count()];
        for (int draw = 0; draw < draws; draw++) {
            skin.shade(context, scene, buffer, sources, target, used, draw);
            float[] drawn = unpacked(packing, target.read(0, used));
            if (draws == 1) {
                return drawn;
            }
            CutLoops.checked(drawn);
            for (int i = 0; i < sums.length; i++) {
                sums[i] += drawn[i];
            }
        }
        // Draws have weights, of which alpha is the sum.
        for (int at = 0; at < sums.length; at += CHANNELS) {
            for (int c = 0; c < CHANNELS; c++) {
                sums[at + c] /= sums[at + CHANNELS - 1];
            }
        }
        return sums;
    }

    /** Notes what a part of a block looks into; {@link #shade} makes it at once. */
    void look(SkinFootprints footprints, Scene scene, GeometryBuffer buffer, Tile part, int samplesAcross) {
        int[] covered = covered(buffer.views(part), part, 1);
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = Packing.of(Math.min(Packing.MOST, covered.length - first));
            upload(packing, covered, first, buffer, part, 1);
            Tile used = packing.used();
            footprints.find(scene, buffer, 1, samplesAcross, sources, used);
            footprints.note(packing, used);
        }
    }

    /** Numbers of the lit pixels that show skin, counted row by row from the part's top left; neighbors together. */
    private static int[] covered(float[] views, Tile part, int stride) {
        int columns = SceneSession.few(part.width(), stride);
        int rows = SceneSession.few(part.height(), stride);
        int[] pixels = new int[columns * rows];
        int count = 0;
        for (int top = 0; top < rows; top += SQUARE) {
            for (int left = 0; left < columns; left += SQUARE) {
                for (int y = top; y < Math.min(top + SQUARE, rows); y++) {
                    for (int x = left; x < Math.min(left + SQUARE, columns); x++) {
                        if (views[CHANNELS * stride * (y * part.width() + x) + 3] > 0) {
                            pixels[count++] = y * columns + x;
                        }
                    }
                }
            }
        }
        return Arrays.copyOf(pixels, count);
    }

    /** Tells the shader for each slot which texel of the geometry it lights; -1 for none. */
    private void upload(Packing packing, int[] covered, int first, GeometryBuffer buffer, Tile part, int stride) {
        int columns = SceneSession.few(part.width(), stride);
        Arrays.fill(slots, 0, Packing.COLUMNS * packing.rows(), -1);
        for (int i = 0; i < packing.count(); i++) {
            int x = part.x() + stride * (covered[first + i] % columns);
            int y = part.y() + stride * (covered[first + i] / columns);
            slots[packing.slot(i)] = buffer.texel(x, y);
        }
        sources.upload(slots);
    }

    /** Of each slot that was lit; what lies in others nobody has drawn. */
    private static float[] unpacked(Packing packing, float[] packed) {
        float[] lit = new float[CHANNELS * packing.count()];
        for (int i = 0; i < packing.count(); i++) {
            copy(packed, CHANNELS * packing.read(i), lit, CHANNELS * i);
        }
        return lit;
    }

    /** A pixel; by hand, since a million calls of System.arraycopy for so little take longer. */
    private static void copy(float[] from, int first, float[] to, int at) {
        for (int c = 0; c < CHANNELS; c++) {
            to[at + c] = from[first + c];
        }
    }

    @Override
    public void close() {
        sources.close();
        target.close();
    }
}
