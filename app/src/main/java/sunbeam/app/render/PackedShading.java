package sunbeam.app.render;

import java.util.Arrays;
import jrtr.FloatFormat;
import jrtr.FloatTargetSpec;
import jrtr.FloatTextureSpec;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.Opening;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.LoopLimit;
import sunbeam.app.gpu.colors.Footprints;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.app.scene.Scene;

/** Runs the costly shader for the pixels that show skin and for no other, packed (see {@link Packing}). */
final class PackedShading implements AutoCloseable {
    private static final int CHANNELS = 4;
    // Radiance, and the footprints' centers and axes.
    private static final int IMAGES = 3;
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
                        "packed radiance", new FloatTargetSpec(Packing.COLUMNS, Packing.ROWS, IMAGES, false)),
                sources::close);
    }

    /**
     * Lights a part of a block. Tiles that are not resident are made first, unless a scheduler makes them.
     *
     * @param buffer the block, with that part drawn, and its neighbors, from which footprints follow
     * @param part counted from the block's corner
     * @param stride each stride-th pixel of each stride-th row is lit, and stands for those to its right and below
     * @param samplesAcross of the mesh along a side of a pixel
     * @return linear XYZ and coverage, 4 values a lit pixel, the part's top row first; zeros where there is no skin; where tiles are
     *     missing, the body with a coverage of -1
     */
    float[] shade(SkinSurface skin, Scene scene, GeometryBuffer buffer, Tile part, int stride, int samplesAcross) {
        int[] covered = covered(buffer.views(part), part, stride);
        float[] lit =
                new float[CHANNELS * SceneSession.few(part.width(), stride) * SceneSession.few(part.height(), stride)];
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = Packing.of(Math.min(Packing.MOST, covered.length - first));
            upload(packing, covered, first, buffer, part, stride);
            float[] drawn = LoopLimit.checked(shade(skin, scene, buffer, packing, stride, samplesAcross));
            for (int i = 0; i < packing.count(); i++) {
                copy(drawn, CHANNELS * i, lit, CHANNELS * covered[first + i]);
            }
        }
        return lit;
    }

    /** Lights what was uploaded: 4 values for each of the packing's. */
    private float[] shade(
            SkinSurface skin, Scene scene, GeometryBuffer buffer, Packing packing, int stride, int samplesAcross) {
        if (skin.levels().isEmpty()) {
            return meanOfDraws(skin, scene, buffer, packing, stride, samplesAcross);
        }
        LevelTiles tiles = skin.levels().get();
        ShadingPass pass = new ShadingPass(stride, samplesAcross, 0, true);
        float[] drawn = draw(skin, scene, buffer, packing, pass);
        if (tiles.isScheduled() || !isMissing(drawn)) {
            return drawn;
        }
        tiles.note(footprints(packing));
        tiles.make();
        drawn = draw(skin, scene, buffer, packing, pass);
        if (isMissing(drawn)) {
            throw new IllegalStateException("a footprint reads tiles that were not noted for it");
        }
        return drawn;
    }

    private float[] draw(SkinSurface skin, Scene scene, GeometryBuffer buffer, Packing packing, ShadingPass pass) {
        skin.shade(context, scene, buffer, sources, target, packing.used(), pass);
        return unpacked(packing, target.read(0, packing.used()));
    }

    /** The footprints of what was drawn last. */
    private Footprints footprints(Packing packing) {
        return new Footprints(
                unpacked(packing, target.read(1, packing.used())), unpacked(packing, target.read(2, packing.used())));
    }

    /** Whether a tile was not resident for one of these pixels (shaders/skin.frag). */
    static boolean isMissing(float[] lit) {
        for (int alpha = CHANNELS - 1; alpha < lit.length; alpha += CHANNELS) {
            if (lit[alpha] < 0) {
                return true;
            }
        }
        return false;
    }

    private float[] meanOfDraws(
            SkinSurface skin, Scene scene, GeometryBuffer buffer, Packing packing, int stride, int samplesAcross) {
        int draws = skin.draws(scene, samplesAcross);
        float[] sums = new float[CHANNELS * packing.count()];
        for (int draw = 0; draw < draws; draw++) {
            float[] drawn = draw(skin, scene, buffer, packing, new ShadingPass(stride, samplesAcross, draw, true));
            if (draws == 1) {
                return drawn;
            }
            LoopLimit.checked(drawn);
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

    /** Notes the tiles that a part of a block reads. */
    void note(SkinSurface skin, Scene scene, GeometryBuffer buffer, Tile part, int samplesAcross) {
        int[] covered = covered(buffer.views(part), part, 1);
        ShadingPass pass = new ShadingPass(1, samplesAcross, 0, false);
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = Packing.of(Math.min(Packing.MOST, covered.length - first));
            upload(packing, covered, first, buffer, part, 1);
            skin.shade(context, scene, buffer, sources, target, packing.used(), pass);
            skin.levels().orElseThrow().note(footprints(packing));
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
