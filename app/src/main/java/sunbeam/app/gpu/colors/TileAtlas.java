package sunbeam.app.gpu.colors;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Texture;
import sunbeam.precompute.colortable.AtlasPages;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.colortable.TableLookUp;
import sunbeam.precompute.colortable.TileGrid;
import sunbeam.precompute.plan.MemoryNeed;

/** {@link AtlasPages} on the graphics card, to which tiles are added while pictures are drawn. */
final class TileAtlas implements AutoCloseable {
    private final RenderContext context;
    private final TileGrid finest;
    private final NumberFormat format;
    private final AtlasPages pages;
    private final BitSet changed = new BitSet();
    private FloatTexture texels;
    private FloatTexture pageTable;
    private long expectedTiles;

    TileAtlas(RenderContext context, NumberFormat format, List<TileGrid> grids) {
        this.context = context;
        this.finest = grids.get(0);
        this.format = format;
        this.pages = new AtlasPages(grids, format);
        // Upload an empty page even if no tile is needed (a mesh that faces away from the light): the shader samples it
        // anyway.
        changed.set(0);
    }

    /** Returns the bytes of the layers for a number of tiles. They are allocated twice: on the card and in main memory. */
    static long bytes(long tiles, NumberFormat format) {
        return (long) AtlasPages.layers(tiles) * AtlasPages.LAYER_NUMBERS * format.bytes();
    }

    /** Sets the expected number of tiles, so that the texture is allocated once. */
    void expect(long expected) {
        expectedTiles = expected;
    }

    /** Adds a tile; it is on the card from the next {@link #textures()} on. */
    void add(int level, int tile, byte[] coefficients) {
        changed.set(pages.add(level, tile, coefficients));
    }

    TableLookUp lookUp(List<TileGrid> grids) {
        return new TableLookUp(grids, format, pages::coefficient);
    }

    /** Valid until a tile is added. */
    Map<String, Texture> textures() {
        if (!changed.isEmpty()) {
            upload();
        }
        return Map.of("colorTexels", texels, "colorTiles", pageTable);
    }

    private void closeTexels() {
        if (texels != null) {
            texels.close();
            texels = null;
        }
    }

    private int layerCapacity() {
        int layers = pages.layers().size();
        int needed = Math.max(layers, AtlasPages.layers(expectedTiles));
        if (texels == null || needed > layers) {
            return needed;
        }
        // Doubling keeps the number of complete uploads small.
        return Math.max(needed, Math.min(2 * texels.spec().layers(), mostLayers()));
    }

    /** Returns the most layers that drivers allow; {@link VirtualTexture} refuses more tiles beforehand. */
    private int mostLayers() {
        return (int) (MemoryNeed.LARGEST_TEXTURE_BYTES / AtlasPages.LAYER_NUMBERS / format.bytes());
    }

    private void upload() {
        List<ByteBuffer> layers = pages.layers();
        if (texels == null || texels.spec().layers() < layers.size()) {
            int capacity = layerCapacity();
            closeTexels();
            FloatTexture.Spec spec = FloatTexture.Spec.array(
                    AtlasPages.LAYER_SIDE,
                    AtlasPages.LAYER_SIDE,
                    capacity,
                    format == NumberFormat.HALF ? FloatTexture.Format.RGBA16F : FloatTexture.Format.RGBA32F);
            texels = context.createFloatTexture("colors", spec.with(FloatTexture.Filter.LINEAR));
            changed.set(0, layers.size());
            ByteBuffer empty = pages.newLayer();
            for (int layer = layers.size(); layer < capacity; layer++) {
                upload(layer, empty);
            }
        }
        changed.stream().forEach(layer -> upload(layer, layers.get(layer)));
        changed.clear();
        float[][] pageTables = pages.pageTable();
        if (pageTable == null) {
            pageTable = context.createFloatTexture(
                    "color tiles",
                    FloatTexture.Spec.array(
                            finest.columns(), finest.rows(), pageTables.length, FloatTexture.Format.RG32F));
        }
        for (int layer = 0; layer < pageTables.length; layer++) {
            pageTable.uploadLayer(layer, FloatBuffer.wrap(pageTables[layer]));
        }
    }

    private void upload(int layer, ByteBuffer numbersOfTexels) {
        if (format == NumberFormat.HALF) {
            texels.uploadLayer(layer, numbersOfTexels.asShortBuffer());
        } else {
            texels.uploadLayer(layer, numbersOfTexels.asFloatBuffer());
        }
    }

    @Override
    public void close() {
        closeTexels();
        if (pageTable != null) {
            pageTable.close();
            pageTable = null;
        }
    }
}
