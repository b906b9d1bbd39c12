package sunbeam.app.gpu.colors;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import jrtr.GraphicsException;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Texture;
import sunbeam.precompute.colortable.AtlasPages;
import sunbeam.precompute.colortable.AtlasPages.TableLookUp;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.text.Text;

/** Resident tiles of a color table in {@link AtlasPages}. Tiles are added while pictures are drawn. */
final class Residency implements AutoCloseable {
    // Share of Java's heap that colors may take.
    private static final double USABLE_HEAP = 0.8;
    private static final double MEGABYTE = 1e6;

    private final RenderContext context;
    private final ColorTable table;
    private final List<TileGrid> grids;
    private final NumberFormat format;
    private final AtlasPages pages;
    private final TableLookUp lookUp;
    private final TileSet resident;
    private final BitSet changed = new BitSet();
    private FloatTexture texels;
    private FloatTexture pageTable;
    private long expectedTiles;

    Residency(RenderContext context, ColorTable table, List<TileGrid> grids) {
        this.context = context;
        this.table = table;
        this.grids = grids;
        this.format = table.numbers();
        this.pages = new AtlasPages(grids, format);
        this.lookUp = pages.lookUp();
        this.resident = TileSet.none(grids.size());
        // Even without tiles the shader samples a page: that of a mesh that faces away from the light.
        changed.set(0);
    }

    TileSet missing(TileSet tiles) {
        return tiles.without(resident);
    }

    /** Resident share of some tiles, 0 to 1; 1 if there are none. */
    double share(TileSet tiles) {
        long all = tiles.count();
        return all == 0 ? 1 : 1 - (double) missing(tiles).count() / all;
    }

    /** Sets the tiles to be added, to allocate the texture once; throws {@link GraphicsException} beyond the card's or Java's memory. */
    void expect(TileSet missing) {
        long tiles = resident.count() + missing.count();
        long textures = bytes(tiles);
        // The textures' copy in main memory, the samples, and the tiles being baked.
        long heap = textures + LevelBaking.sampleBytes(2 * tiles) + bytes(missing.count());
        long most = Runtime.getRuntime().maxMemory();
        if (textures > MemoryNeed.LARGEST_TEXTURE_BYTES || heap > USABLE_HEAP * most) {
            throw new GraphicsException(Text.format(
                    "the colors that this picture sees take %.0f MB of textures and %.0f MB of Java's heap, which may take"
                            + " %.0f MB; give a coarser tolerance, a shorter coherence length, a smaller picture or"
                            + " method full (--method full); SUNBEAM_JAVA_OPTIONS=-Xmx%dm allows more",
                    textures / MEGABYTE,
                    heap / MEGABYTE,
                    most / MEGABYTE,
                    (long) (heap / USABLE_HEAP / (1 << 20)) + 1));
        }
        expectedTiles = tiles;
    }

    /** Bytes of a number of tiles, which are allocated on the card and again in main memory. */
    private long bytes(long tiles) {
        return (long) AtlasPages.layers(tiles) * AtlasPages.LAYER_NUMBERS * format.bytes();
    }

    /** Adds tiles; they are on the card from the next {@link #textures()} on. */
    void add(Scheduler.BakedTiles baked) {
        int[] tiles = baked.tiles().stream().toArray();
        for (int i = 0; i < tiles.length; i++) {
            changed.set(pages.add(baked.level(), tiles[i], baked.coefficients().get(i)));
        }
        resident.of(baked.level()).or(baked.tiles());
    }

    /** Returns the mean X, Y, Z of power of a level at some (u, v, w), whose tiles must be resident. */
    double[] mean(int level, double[]... places) {
        double scale = table.levels().get(level).scale();
        double[] mean = new double[3];
        for (double[] uvw : places) {
            double[] xyz = lookUp.xyz(level, uvw[0], uvw[1], uvw[2]);
            Arrays.setAll(mean, c -> mean[c] + scale * xyz[c] / places.length);
        }
        return mean;
    }

    Map<String, Texture> textures() {
        if (!changed.isEmpty()) {
            upload();
        }
        return Map.of("colorTexels", texels, "colorTiles", pageTable);
    }

    private void upload() {
        List<ByteBuffer> layers = pages.layers();
        if (texels == null || texels.spec().layers() < layers.size()) {
            allocate(layers.size());
        }
        changed.stream().forEach(layer -> texels.uploadLayer(layer, layers.get(layer)));
        changed.clear();
        float[][] numbers = pages.pageTable();
        if (pageTable == null) {
            TileGrid finest = grids.get(0);
            pageTable = context.createFloatTexture(
                    "color tiles",
                    FloatTexture.Spec.array(
                            finest.columns(), finest.rows(), numbers.length, FloatTexture.Format.RG32F));
        }
        for (int layer = 0; layer < numbers.length; layer++) {
            pageTable.uploadLayer(layer, FloatBuffer.wrap(numbers[layer]));
        }
    }

    private void allocate(int layers) {
        int capacity = Math.max(layers, AtlasPages.layers(expectedTiles));
        if (texels != null && capacity == layers) {
            // Doubling keeps complete uploads few. Drivers allow no more layers than expect().
            long most = MemoryNeed.LARGEST_TEXTURE_BYTES / AtlasPages.LAYER_NUMBERS / format.bytes();
            capacity = Math.max(layers, (int) Math.min(2L * texels.spec().layers(), most));
        }
        close(texels);
        texels = null;
        FloatTexture.Spec spec = FloatTexture.Spec.array(
                AtlasPages.LAYER_SIDE,
                AtlasPages.LAYER_SIDE,
                capacity,
                format == NumberFormat.HALF ? FloatTexture.Format.RGBA16F : FloatTexture.Format.RGBA32F);
        texels = context.createFloatTexture("colors", spec.with(FloatTexture.Filter.LINEAR));
        changed.set(0, layers);
        ByteBuffer empty = pages.newLayer();
        for (int layer = layers; layer < capacity; layer++) {
            texels.uploadLayer(layer, empty);
        }
    }

    private static void close(FloatTexture texture) {
        if (texture != null) {
            texture.close();
        }
    }

    @Override
    public void close() {
        close(texels);
        close(pageTable);
    }
}
