package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import jrtr.ContextInfo;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.scene.PartSum;
import sunbeam.app.scene.Pick;
import sunbeam.app.scene.PixelSamples;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneData;
import sunbeam.app.scene.SceneDisplay;
import sunbeam.app.scene.ScenePicture;
import sunbeam.app.scene.ScenePreview;
import sunbeam.app.scene.SceneSession;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.shader.ShaderTables;

/** Everything of the viewer that lives on the graphics card. Belongs to the thread that made it. */
class GraphicsStage implements AutoCloseable {
    private final RenderContext context;
    private final MapStage map;
    private List<SceneSession> fine = List.of();
    private SceneSession coarse;
    private Optional<SceneSession> moving = Optional.empty();
    private Optional<SceneData> requested = Optional.empty();
    private ViewState state;
    private Optional<ShaderTables> uploadedOf = Optional.empty();
    private Optional<UploadedTables> uploaded = Optional.empty();

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
        goOverTo(next);
        state = next;
    }

    private void goOverTo(ViewState state) {
        if (fine.size() != state.parts().size()) {
            replace(state);
            return;
        }
        if (moving.isPresent() && state.moving().isEmpty()) {
            closeMoving();
        }
        Optional<SceneSession> nextMoving = moving;
        SceneSession nextCoarse = coarse;
        List<SceneSession> sessions = sessions();
        List<SceneData> before = sessions.stream().map(SceneSession::data).toList();
        try {
            if (moving.isEmpty()) {
                nextMoving = state.moving().map(data -> new SceneSession(context, data));
            }
            if (coarse == null && !state.isBare()) {
                nextCoarse = new SceneSession(context, state.coarse());
            }
            update(sessions, data(state));
        } catch (RuntimeException | OutOfMemoryError failure) {
            update(sessions, before);
            closeNew(nextMoving.orElse(null), moving.orElse(null));
            closeNew(nextCoarse, coarse);
            throw failure;
        }
        moving = nextMoving;
        coarse = nextCoarse;
    }

    @SuppressWarnings("ReferenceEquality") // the same session
    private static void closeNew(SceneSession next, SceneSession old) {
        if (next != null && next != old) {
            next.close();
        }
    }

    private static void update(List<SceneSession> sessions, List<SceneData> data) {
        for (int i = 0; i < sessions.size(); i++) {
            sessions.get(i).update(data.get(i));
        }
    }

    /** Of {@link #sessions()}, in their order. */
    private List<SceneData> data(ViewState state) {
        List<SceneData> all = new ArrayList<>(state.parts());
        if (coarse != null) {
            all.add(state.coarse());
        }
        if (moving.isPresent()) {
            all.add(state.moving().orElseThrow());
        }
        return all;
    }

    private List<SceneSession> sessions() {
        List<SceneSession> all = new ArrayList<>(fine);
        if (coarse != null) {
            all.add(coarse);
        }
        moving.ifPresent(all::add);
        return all;
    }

    private void replace(ViewState state) {
        List<SceneSession> made = new ArrayList<>();
        int parts = state.parts().size();
        try {
            state.parts().forEach(data -> made.add(new SceneSession(context, data)));
            // What shows the body alone is seldom asked for: what moves does, too.
            if (!state.isBare()) {
                made.add(new SceneSession(context, state.coarse()));
            }
            state.moving().ifPresent(data -> made.add(new SceneSession(context, data)));
        } catch (RuntimeException | OutOfMemoryError failure) {
            made.forEach(SceneSession::close);
            throw failure;
        }
        sessions().forEach(SceneSession::close);
        fine = List.copyOf(made.subList(0, parts));
        coarse = state.isBare() ? null : made.get(parts);
        moving = state.moving().map(data -> made.get(made.size() - 1));
    }

    private void closeMoving() {
        moving.ifPresent(SceneSession::close);
        moving = Optional.empty();
    }

    /**
     * From now on makes colors in the background, where a method's are made as they are looked at.
     *
     * @param arrived told, by another thread, that there are more
     */
    void bakeInBackground(Runnable arrived) {
        fine.forEach(session -> session.bakeInBackground(false, arrived));
        // Until they are there, what moves is drawn by its method.
        moving.ifPresent(session -> session.bakeInBackground(true, arrived));
    }

    /** Takes over what has been made in the background; whether there was anything. */
    boolean takeBaked() {
        boolean any = false;
        for (SceneSession session : sessions()) {
            any |= session.takeBaked();
        }
        return any;
    }

    /**
     * Asks the background for all that a picture looks into; the share of it that is there, 1 where nothing is missing. Nothing where
     * it was interrupted.
     */
    OptionalDouble request(int width, int height, BooleanSupplier interrupted) {
        double sum = 0;
        for (SceneSession part : fine) {
            OptionalDouble share = part.request(width, height, samples(width, height), interrupted);
            if (share.isEmpty()) {
                return share;
            }
            sum += share.getAsDouble();
        }
        return OptionalDouble.of(sum / fine.size());
    }

    /** Has the driver make ready what such a picture will be drawn with. */
    void prepareDrawing(int width, int height) {
        fine.forEach(part -> part.prepareDrawing(width, height));
    }

    /** Asks the background for what pictures of what moves look into; nobody waits for it. */
    void requestMoving(int width, int height, BooleanSupplier interrupted) {
        if (!state.moving().equals(requested)
                && moving.map(session -> session.requestMoving(width, height, interrupted))
                        .orElse(true)) {
            requested = state.moving();
        }
    }

    /** Leaves the processors to what is being drawn for a while. */
    void holdBaking() {
        sessions().forEach(SceneSession::holdBaking);
    }

    ScenePreview preview(int width, int height, int divisor) {
        return coarse().preview(width, height, divisor);
    }

    private SceneSession coarse() {
        if (coarse == null) {
            coarse = new SceneSession(context, state.coarse());
        }
        return coarse;
    }

    /** Whether {@link #moving(int, int, int, double)} can draw the state. */
    boolean canMove() {
        // Of a scene that has no other picture yet, coarse colors are more than none.
        return moving.isPresent()
                ? moving.get().canMove()
                : mover().map(SceneSession::canMoveCoarsely).orElse(false);
    }

    /** Whether {@link #canMove()} will be so in a moment, by what an earlier run has kept. */
    boolean canMoveSoon() {
        return mover().map(SceneSession::hasKeptCoarse).orElse(false);
    }

    /** Share of what pictures that stand still wait for that is there, 1 where nothing is missing. */
    double requestedShare() {
        return fine.stream().mapToDouble(SceneSession::requestedShare).average().orElse(1);
    }

    private Optional<SceneSession> mover() {
        return moving.isEmpty() && fine.size() == 1 ? Optional.of(fine.get(0)) : moving;
    }

    /** What moves, with a {@code divisor}-th of columns and rows. */
    BufferedImage moving(int width, int height, int divisor, double exposure) {
        return mover().orElseThrow().moving(width, height, divisor, exposure);
    }

    /** A part of the picture that stands still, as a screen shows it. */
    BufferedImage part(int width, int height, Tile tile, double exposure) {
        Scene scene = state.fine().scene();
        int samples = samples(width, height);
        ScenePicture drawn = new PartSum(fine).samples(scene, width, height, tile, samples);
        return SceneDisplay.image(drawn, samples, scene.display(exposure), scene.background());
    }

    /** The tiles of a picture that stands still, in the order that is best drawn. */
    List<Tile> tiles(int width, int height) {
        return SceneSession.tiles(width, height, samples(width, height));
    }

    /** As many as {@code render} takes. */
    private int samples(int width, int height) {
        return PixelSamples.alongSide(state.fine().scene().method(), width, height);
    }

    /** Time that has gone to the mesh of parts so far. */
    long meshNanoseconds() {
        return fine.stream().mapToLong(SceneSession::meshNanoseconds).sum();
    }

    /** The exposure of the picture that stands still, as {@code render} finds it. */
    double exposure() {
        return SceneDisplay.exposure(state.fine().scene(), new PartSum(fine), state.width(), state.height());
    }

    /** The same found by the plan for previews, where that shows diffracted light. */
    double previewExposure() {
        return state.isBare()
                ? exposure()
                : SceneDisplay.exposure(
                        state.coarse().scene(), new PartSum(List.of(coarse())), state.width(), state.height());
    }

    BufferedImage image(ScenePicture picture, double exposure) {
        Scene scene = state.coarse().scene();
        return SceneDisplay.image(picture, 1, scene.display(exposure), scene.background());
    }

    Optional<Pick> pick(int x, int y, int width, int height) {
        return fine.isEmpty() ? Optional.empty() : fine.get(0).pick(x, y, width, height);
    }

    /** The BRDF map of the scene's method; null if it was interrupted. */
    BufferedImage map(Direction light, int size, BooleanSupplier interrupted) {
        return map.draw(mapped().orElse(fine.get(0).method()), light, size, interrupted);
    }

    /** What a scene's tables of colors are made of: those of a mesh's pixels have no map themselves. */
    private Optional<UploadedTables> mapped() {
        Optional<ShaderTables> tables = state.mapped().map(SceneData::tables);
        if (!tables.equals(uploadedOf)) {
            uploaded.ifPresent(UploadedTables::close);
            uploaded = Optional.empty();
            uploadedOf = Optional.empty();
            uploaded = tables.map(of -> UploadedTables.upload(context, of));
            uploadedOf = tables;
        }
        return uploaded;
    }

    @Override
    public void close() {
        try {
            uploaded.ifPresent(UploadedTables::close);
            sessions().forEach(SceneSession::close);
        } finally {
            context.close();
        }
    }
}
