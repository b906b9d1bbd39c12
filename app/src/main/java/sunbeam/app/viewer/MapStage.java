package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.LevelSources;
import sunbeam.app.gpu.map.BrdfMapRenderer;
import sunbeam.app.gpu.map.DiscDirections;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.TimedTiles;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.colortable.ColorSource;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;

/** Draws the BRDF map beside the mesh, small first, interruptible at any tile. */
final class MapStage implements AutoCloseable {
    static final int PREVIEW_SIZE = 48;
    static final int SIZE = 192;

    private final RenderContext context;
    private final TimedTiles tiles = new TimedTiles(System::nanoTime);
    private final TimedTiles tableTiles = new TimedTiles(System::nanoTime);
    private List<LevelSources> opened = List.of();
    private List<ColorSource> sources = List.of();

    MapStage(RenderContext context) {
        this.context = context;
    }

    /**
     * Draws a map.
     *
     * @param method the scene's, uploaded to this context
     * @param interrupted asked after every tile
     * @return null if it was interrupted
     */
    BufferedImage draw(UploadedTables method, Direction light, int size, BooleanSupplier interrupted) {
        try (BrdfMapRenderer renderer = new BrdfMapRenderer(context, method, size)) {
            List<Tile> blocks = Tile.cover(size, size, TimedTiles.LARGEST);
            if (!tiles.draw(blocks, interrupted, tile -> renderer.draw(light, tile))) {
                return null;
            }
            return shown(renderer.picture());
        }
    }

    /** As the other, of a scene by tables: by what their finest level is made of. */
    BufferedImage draw(List<SceneData> parts, Direction light, int size, BooleanSupplier interrupted) {
        open(parts.stream().map(part -> part.levels().orElseThrow()).toList());
        DiscDirections directions = new DiscDirections(size, light);
        float[] xyz = new float[3 * size * size];
        Arrays.fill(xyz, Float.NaN);
        boolean isWhole = tableTiles.draw(Tile.cover(size, size, TimedTiles.LARGEST), interrupted, tile -> {
            int[] pixels = IntStream.range(0, Math.toIntExact(tile.pixels()))
                    .map(i -> (tile.y() + i / tile.width()) * size + tile.x() + i % tile.width())
                    .filter(directions::covers)
                    .toArray();
            for (int part = 0; part < parts.size(); part++) {
                add(directions, pixels, parts.get(part), sources.get(part), xyz);
            }
        });
        return isWhole ? shown(new LinearPicture(size, size, xyz)) : null;
    }

    @SuppressWarnings("ReferenceEquality") // the same objects as long as nothing is loaded anew
    private void open(List<LevelSources> wanted) {
        boolean isSame = wanted.size() == opened.size()
                && IntStream.range(0, wanted.size()).allMatch(i -> wanted.get(i) == opened.get(i));
        if (!isSame) {
            close();
            sources = wanted.stream().map(levels -> levels.open(0, done -> {})).toList();
            opened = wanted;
        }
    }

    private static void add(DiscDirections directions, int[] pixels, SceneData data, ColorSource source, float[] xyz) {
        float[] places = new float[3 * pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            DirectionPair pair = directions.at(pixels[i]);
            places[3 * i] = (float) pair.u();
            places[3 * i + 1] = (float) pair.v();
            places[3 * i + 2] = (float) pair.w();
        }
        float[] power = pixels.length == 0 ? places : source.exact(places);
        for (int i = 0; i < pixels.length; i++) {
            DirectionPair pair = directions.at(pixels[i]);
            double gain =
                    data.part().map(part -> part.reflection().gain(pair)).orElseGet(() -> Gain.relativeRadiance(pair));
            for (int c = 0; c < 3; c++) {
                int at = 3 * pixels[i] + c;
                xyz[at] = (float) (gain * power[3 * i + c] + (Float.isNaN(xyz[at]) ? 0 : xyz[at]));
            }
        }
    }

    private static BufferedImage shown(LinearPicture picture) {
        return picture.shown(new DisplayTransform(AutoExposure.of(picture), Tone.COMPRESS));
    }

    @Override
    public void close() {
        sources.forEach(ColorSource::close);
        sources = List.of();
        opened = List.of();
    }
}
