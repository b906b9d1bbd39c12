package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Stream;
import jrtr.ContextInfo;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.SceneSession;
import sunbeam.app.scene.TimedTiles;
import sunbeam.precompute.optics.Direction;

/** Everything of the viewer that lives on the graphics card. Belongs to the thread that made it. */
class GraphicsStage implements AutoCloseable {
    private final RenderContext context;
    private final MapStage map;
    private final TimedTiles tiles = new TimedTiles(this::pixelClock);
    private List<SceneSession> parts = List.of();
    private ViewState state;

    /** Opens a context without a window. */
    GraphicsStage() {
        context = RenderContext.offscreen();
        map = new MapStage(context);
    }

    ContextInfo info() {
        return context.info();
    }

    /** Goes over to a state; if that fails, the old one stays. */
    void update(ViewState next) {
        List<SceneData> wanted = next.scene().parts();
        if (parts.size() == wanted.size()) {
            List<SceneData> before = parts.stream().map(SceneSession::data).toList();
            try {
                update(wanted);
            } catch (RuntimeException | OutOfMemoryError failure) {
                update(before);
                throw failure;
            }
        } else {
            replace(wanted);
        }
        state = next;
    }

    private void update(List<SceneData> data) {
        for (int i = 0; i < parts.size(); i++) {
            parts.get(i).update(data.get(i));
        }
    }

    private void replace(List<SceneData> wanted) {
        List<SceneSession> made = new ArrayList<>();
        try {
            wanted.forEach(data -> made.add(new SceneSession(context, data)));
        } catch (RuntimeException | OutOfMemoryError failure) {
            made.forEach(SceneSession::close);
            throw failure;
        }
        parts.forEach(SceneSession::close);
        parts = List.copyOf(made);
    }

    private Stream<LevelTiles> tiles() {
        return parts.stream().flatMap(part -> part.tiles().stream());
    }

    /**
     * From now on bakes tiles of color tables in the background.
     *
     * @param arrived told, by another thread, that there are more
     */
    void bakeInBackground(Runnable arrived) {
        tiles().forEach(tiles -> tiles.bakeInBackground(arrived));
    }

    /** Takes over what has been baked in the background; whether there was anything. */
    boolean takeBaked() {
        return tiles().map(LevelTiles::takeBaked).reduce(false, Boolean::logicalOr);
    }

    /** Leaves the processors to what is being drawn for a while. */
    void holdBaking() {
        tiles().forEach(LevelTiles::holdBaking);
    }

    /**
     * Asks the background for all that the picture looks into; the share of it that is there, 1 where nothing is missing. Nothing
     * where it was interrupted.
     */
    OptionalDouble request(BooleanSupplier interrupted) {
        for (SceneSession part : parts) {
            if (!part.request(state.width(), state.height(), samples(), interrupted)) {
                return OptionalDouble.empty();
            }
        }
        return OptionalDouble.of(requestedShare());
    }

    /** Share of what the background was asked for that is there, 1 where nothing is missing. */
    double requestedShare() {
        return average(LevelTiles::requestedShare);
    }

    /** Share of the coarsest mip level that is there; 1 where nobody waits for one. */
    double coarsestShare() {
        return average(LevelTiles::coarsestShare);
    }

    private double average(Function<LevelTiles, Double> share) {
        return tiles().mapToDouble(share::apply).average().orElse(1);
    }

    /** Whether {@link #byTable} draws the state: its colors are in one table. */
    boolean isByTable() {
        return parts.size() == 1 && tiles().findAny().isPresent();
    }

    /** Whether all pixels have colors, if only those of the coarsest mip level; else those without show the body alone. */
    boolean hasColors() {
        return !isByTable() || tiles().allMatch(LevelTiles::hasCoarsest);
    }

    /** By those tiles that are there, with a {@code divisor}-th of columns and rows: as a screen shows it. */
    BufferedImage byTable(int divisor, double exposure) {
        return parts.get(0).moving(state.width(), state.height(), divisor, exposure);
    }

    /** The finest stride of {@link #coarse} that draws in that time. */
    int stride(long nanoseconds) {
        return tiles.stride(state.width(), state.height(), nanoseconds);
    }

    /**
     * By few samples of diffracted light over the whole body, as {@link PartSum#coarse}.
     *
     * @return nothing where it was interrupted
     */
    Optional<ScenePicture> coarse(int stride, double white, BooleanSupplier interrupted) {
        return sum().coarse(scene(), state.width(), state.height(), stride, white, tiles, interrupted);
    }

    /**
     * Draws the final picture.
     *
     * @param interrupted asked before each tile
     * @param drawn told of each tile as a screen shows it
     * @return whether all was drawn
     */
    boolean refine(double exposure, BooleanSupplier interrupted, BiConsumer<Tile, BufferedImage> drawn) {
        int samples = samples();
        List<Tile> blocks = SceneSession.tiles(state.width(), state.height(), samples);
        return tiles.draw(blocks, interrupted, tile -> {
            ScenePicture part = sum().samples(scene(), state.width(), state.height(), tile, samples);
            drawn.accept(tile, image(part, samples, exposure));
        });
    }

    private PartSum sum() {
        return new PartSum(parts);
    }

    /**
     * As a screen shows it.
     *
     * @param samples along a pixel's side
     */
    BufferedImage image(ScenePicture picture, int samples, double exposure) {
        return SceneDisplay.image(picture, samples, scene().display(exposure), scene().background());
    }

    private Scene scene() {
        return state.fine().scene();
    }

    /** As many as {@code render} takes. */
    private int samples() {
        return PixelSamples.alongSide(scene().method(), state.width(), state.height());
    }

    /** Nanoseconds that go by while pixels are drawn, but not while the mesh is. */
    long pixelClock() {
        return System.nanoTime()
                - parts.stream().mapToLong(SceneSession::meshNanoseconds).sum();
    }

    /** The exposure of the final picture, as {@code render} finds it; nothing where it was interrupted. */
    OptionalDouble exposure(BooleanSupplier interrupted) {
        return SceneDisplay.exposure(scene(), sum(), state.width(), state.height(), tiles, interrupted);
    }

    Optional<Pick> pick(int x, int y, int width, int height) {
        return parts.isEmpty() ? Optional.empty() : parts.get(0).pick(x, y, width, height);
    }

    /** The BRDF map of the scene's method; null if it was interrupted. */
    BufferedImage map(Direction light, int size, BooleanSupplier interrupted) {
        return tiles().findAny().isPresent()
                ? map.draw(state.scene().parts(), light, size, interrupted)
                : map.draw(parts.get(0).method(), light, size, interrupted);
    }

    @Override
    public void close() {
        try {
            map.close();
            parts.forEach(SceneSession::close);
        } finally {
            context.close();
        }
    }
}
