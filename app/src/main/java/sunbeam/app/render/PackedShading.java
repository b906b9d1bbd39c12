package sunbeam.app.render;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.scene.Light;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.Footprints;
import sunbeam.app.gpu.colors.VirtualTexture;

/** Runs the shading pass (shaders/skin.frag) only for pixels that show skin, packed into a compact target (see {@link Packing}). */
final class PackedShading implements AutoCloseable {
    /** Coverage of a pixel that needs a tile which is not resident; MISSING_COVERAGE in shaders/skin.frag. */
    static final float MISSING_COVERAGE = -1;

    private static final int CHANNELS = 4;
    // Pixels of a square follow one another, so that neighbors stay neighbors.
    private static final int SQUARE = 4;
    private static final int FEW_PIXELS = 200;

    private final FloatTexture sources;
    private final FloatTarget target;
    private final float[] slots = new float[Packing.MOST];

    PackedShading(RenderContext context) {
        this.sources = context.createFloatTexture(
                "sources", FloatTexture.Spec.flat(Packing.COLUMNS, Packing.ROWS, FloatTexture.Format.R32F));
        // Images: radiance, centers of footprints, axes of footprints.
        var spec = new FloatTarget.Spec(Packing.COLUMNS, Packing.ROWS, 3, false);
        this.target = Resource.orClose(() -> context.createFloatTarget("packed radiance", spec), sources::close);
    }

    /**
     * Part of a block to shade. The buffer has also the geometry beside it, since footprints are differences to neighbors.
     *
     * @param data look whose pixels are shaded, and patch that is diffracted
     */
    record Part(
            SkinSurface skin,
            SceneData data,
            DrawRequest request,
            SkinGeometry geometry,
            GeometryBuffer buffer,
            LightList lights,
            LightTexture inMemory,
            SceneBlocks.Piece piece) {
        int columns() {
            return request.columns(piece.inBlock());
        }

        int rows() {
            return request.rows(piece.inBlock());
        }

        VirtualTexture tiles() {
            return skin.virtualTexture().orElseThrow();
        }

        /** Returns the indices of drawn samples that show the look, ordered square by square. */
        int[] covered() {
            int first = SceneData.patchNumber(data.look(), 0);
            int beyond = SceneData.patchNumber(data.look() + 1, 0);
            float[] views = buffer.views(piece.inBlock());
            int columns = columns();
            int rows = rows();
            int[] pixels = new int[columns * rows];
            int count = 0;
            for (int top = 0; top < rows; top += SQUARE) {
                for (int left = 0; left < columns; left += SQUARE) {
                    for (int row = top; row < Math.min(top + SQUARE, rows); row++) {
                        for (int column = left; column < Math.min(left + SQUARE, columns); column++) {
                            int x = request.x(column, row);
                            int y = request.down() * row;
                            float patch = views[CHANNELS * (y * piece.inBlock().width() + x) + 3];
                            if (patch >= first && patch < beyond && request.draws(piece.x() + x, piece.y() + y)) {
                                pixels[count++] = row * columns + column;
                            }
                        }
                    }
                }
            }
            return Arrays.copyOf(pixels, count);
        }
    }

    /**
     * Shades a part of a block. Missing tiles are baked first, unless a scheduler bakes them.
     *
     * @return linear XYZ and coverage per shaded pixel, the part's top row first; zeros without skin; where tiles are missing, the body's
     *     color without diffraction and {@link #MISSING_COVERAGE}
     */
    float[] shade(Part part) {
        float[] lit = new float[CHANNELS * part.columns() * part.rows()];
        int[] missing = shade(part, part.covered(), lit);
        while (missing.length > 0 && !part.tiles().isScheduled()) {
            // Under many lights some pixels tell nearly all tiles.
            addFeedback(part, missing, part.lights.areMany() ? 1 + missing.length / FEW_PIXELS : 1);
            part.tiles().bakeFeedback(part.lights.areMany());
            int[] left = shade(part, missing, lit);
            if (left.length == missing.length) {
                throw new IllegalStateException("a footprint reads tiles that are missing in its feedback");
            }
            missing = left;
        }
        return lit;
    }

    /** Returns the pixels whose color is missing. */
    private int[] shade(Part part, int[] covered, float[] lit) {
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = upload(part, covered, first);
            float[] drawn = sumOfLights(part, packing);
            for (int i = 0; i < packing.count(); i++) {
                copy(drawn, CHANNELS * i, lit, CHANNELS * covered[first + i]);
            }
        }
        return Arrays.stream(covered)
                .filter(i -> lit[CHANNELS * i + CHANNELS - 1] == MISSING_COVERAGE)
                .toArray();
    }

    static boolean isMissing(float[] lit) {
        for (int alpha = CHANNELS - 1; alpha < lit.length; alpha += CHANNELS) {
            if (lit[alpha] == MISSING_COVERAGE) {
                return true;
            }
        }
        return false;
    }

    private float[] sumOfLights(Part part, Packing packing) {
        int lights = part.lights.count();
        int perPass = part.skin.lightsPerPass(part.lights);
        float[] sum = meanOfDraws(part, packing, 0, Math.min(lights, perPass));
        for (int first = perPass; first < lights; first += perPass) {
            float[] further = meanOfDraws(part, packing, first, Math.min(lights, first + perPass));
            for (int i = 0; i < sum.length; i++) {
                sum[i] += i % CHANNELS == CHANNELS - 1 ? 0 : further[i];
            }
        }
        return sum;
    }

    private float[] meanOfDraws(Part part, Packing packing, int firstLight, int lastLight) {
        int draws = part.skin.draws(part.request.scene(), part.lights, part.request.samples());
        float[] sums = new float[CHANNELS * packing.count()];
        for (int draw = 0; draw < draws; draw++) {
            part.skin.shade(part, sources, target, packing.used(), firstLight, lastLight, draw, true);
            float[] drawn = UploadedTables.requireWholeSums(read(packing, 0));
            if (draws == 1) {
                return drawn;
            }
            for (int i = 0; i < sums.length; i++) {
                sums[i] += drawn[i];
            }
        }
        for (int at = 0; at < sums.length; at += CHANNELS) {
            for (int c = 0; c < CHANNELS; c++) {
                sums[at + c] /= sums[at + CHANNELS - 1];
            }
        }
        return sums;
    }

    /** Adds the footprints of every {@code stride}-th pixel to the feedback. */
    void addFeedback(Part part, int stride) {
        addFeedback(part, part.covered(), stride);
    }

    private void addFeedback(Part part, int[] all, int stride) {
        int[] covered = IntStream.range(0, (all.length + stride - 1) / stride)
                .map(i -> all[stride * i])
                .toArray();
        List<Light> lights = part.lights.all();
        for (int first = 0; first < covered.length; first += Packing.MOST) {
            Packing packing = upload(part, covered, first);
            for (int light = 0; light < lights.size(); light++) {
                // A wide light's colors are means of two levels, those of many lights not.
                int levels = lights.get(light).deviation() > 0 && !part.lights.areMany() ? 2 : 1;
                for (int level = 0; level < levels; level++) {
                    part.skin.shade(part, sources, target, packing.used(), light, light + 1, level, false);
                    Footprints footprints = new Footprints(read(packing, 1), read(packing, 2));
                    part.tiles().addFeedback(footprints, !part.request.isCoarsest());
                }
            }
        }
    }

    /** Uploads the index of the geometry buffer's texel that each slot shades, -1 for none, for the pixels from the first. */
    private Packing upload(Part part, int[] covered, int first) {
        Packing packing = Packing.of(Math.min(Packing.MOST, covered.length - first));
        Tile inBlock = part.piece.inBlock();
        int columns = part.columns();
        Arrays.fill(slots, 0, Packing.COLUMNS * packing.rows(), -1);
        for (int i = 0; i < packing.count(); i++) {
            int row = covered[first + i] / columns;
            int x = part.request.x(covered[first + i] % columns, row);
            slots[packing.slot(i)] = part.buffer.texel(inBlock.x() + x, inBlock.y() + part.request.down() * row);
        }
        sources.upload(slots);
        return packing;
    }

    private float[] read(Packing packing, int image) {
        float[] packed = target.read(image, packing.used());
        float[] values = new float[CHANNELS * packing.count()];
        for (int i = 0; i < packing.count(); i++) {
            copy(packed, CHANNELS * packing.indexInReadback(i), values, CHANNELS * i);
        }
        return values;
    }

    /** Copies a pixel; System.arraycopy is slower for four values. */
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

    /**
     * Positions of scattered pixels in a compact target. Software renderers shade 4 x 4 pixels at once and give each processor squares of
     * 64 x 64: full small squares, dealt out in turn to several large ones, keep all processors busy.
     *
     * @param count pixels, from 1 to {@link #MOST}
     * @param columns columns in use: one large square for every two small ones, up to all 16
     * @param rows rows in use, a multiple of 4
     */
    private record Packing(int count, int columns, int rows) {
        /** 16 large squares. */
        static final int COLUMNS = 1024;

        static final int ROWS = 32;

        static final int MOST = COLUMNS * ROWS;

        private static final int SMALL = 4;
        private static final int LARGE = 64;

        static Packing of(int count) {
            int columns = LARGE * Math.min(COLUMNS / LARGE, SceneBlocks.ceilDiv(count, 2 * SMALL * SMALL));
            return new Packing(count, columns, SMALL * SceneBlocks.ceilDiv(count, SMALL * columns));
        }

        /** Rows count from the top. */
        Tile used() {
            return new Tile(0, ROWS - rows, columns, rows);
        }

        /** Counts row by row from the bottom left, as {@code gl_FragCoord}. */
        int slot(int pixel) {
            return COLUMNS * row(pixel) + column(pixel);
        }

        /** Index in {@link #used} as read back: row by row from the top left. */
        int indexInReadback(int pixel) {
            return columns * (rows - 1 - row(pixel)) + column(pixel);
        }

        /** Sixteen successive pixels share a small square. */
        private int column(int pixel) {
            int inRow = pixel / (SMALL * SMALL) % (columns / SMALL);
            int largeSquares = columns / LARGE;
            return LARGE * (inRow % largeSquares) + SMALL * (inRow / largeSquares) + pixel % SMALL;
        }

        private int row(int pixel) {
            return SMALL * (pixel / (SMALL * columns)) + pixel / SMALL % SMALL;
        }
    }
}
