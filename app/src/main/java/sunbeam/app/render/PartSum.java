package sunbeam.app.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import jrtr.Tile;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSettings.BodyAlpha;

/**
 * Draws a scene look by look: the sum of the parts' diffracted light, one part per patch and reflectance component, over the body
 * (shaders/include/blend.glsl). The body is blended in after the sum, since its visibility depends on all diffracted light.
 *
 * @param sessions one session per part
 */
public record PartSum(List<SceneSession> sessions) {
    // Longer sides, pixels, of the pictures metered for automatic exposure, under the light and those around it.
    private static final int METER_SIDE = 160;
    private static final int AROUND_SIDE = 80;

    // Factor by which the light's direction may change the exposure: a stop, between high and low key of a scene.
    private static final double MOST_BY_LIGHT = 2;

    // Samples along a metered pixel's side by method table; other methods take one.
    static final int TABLE_SAMPLES = 2;

    /** Compares some baked colors with exact ones and warns of tables that err too much. */
    public void validate() {
        sessions.forEach(session -> session.virtualTexture().ifPresent(VirtualTexture::validate));
    }

    /** See {@link SceneSession#pick}. */
    public Optional<Pick> pick(int x, int y, int width, int height) {
        return sessions.isEmpty() ? Optional.empty() : sessions.get(0).pick(x, y, width, height);
    }

    /** Draws all samples of a tile of a picture (see {@link SceneSession#draw}). */
    public ScenePicture draw(DrawRequest request) {
        List<ScenePicture> looks = new ArrayList<>();
        looks().forEach((object, parts) -> {
            DrawRequest own = request.with(request.scene().at(object));
            looks.add(
                    parts.size() == 1
                            ? parts.get(0).draw(own)
                            : ScenePicture.sum(lightByLight(own.scene())
                                    .map(light -> underOneLight(parts, own.under(light)))
                                    .toList()));
        });
        return ScenePicture.joined(looks);
    }

    /**
     * Draws a tile of pixels. With adaptive samples, pixels whose means are unsure are drawn again with each refinement.
     */
    public PixelPicture draw(Scene scene, int width, int height, Tile tile, PixelSamples samples, double exposure) {
        int side = samples.side();
        var pixels = new PixelPicture(tile.width(), tile.height(), scene.display(exposure), scene.background());
        BitSet unsure = new BitSet();
        unsure.set(0, tile.width() * tile.height());
        DrawRequest first = DrawRequest.first(scene, width, height, tile, samples);
        unsure = set(pixels, unsure, first, samples.firstAcross(), side);
        for (int finer : samples.refinements()) {
            if (!unsure.isEmpty()) {
                DrawRequest all = DrawRequest.ofPixels(scene, width, height, tile, finer);
                unsure = set(pixels, unsure, all.only(unsure), finer, finer);
            }
        }
        return pixels;
    }

    /** Returns the pixels whose means are unsure: as samples under few lights differ, since those under many have different lights. */
    private BitSet set(PixelPicture pixels, BitSet chosen, DrawRequest request, int across, int down) {
        BitSet unsure = pixels.set(chosen, draw(request), across, down);
        if (!request.scene().hasEnvironment() || down == 1) {
            return unsure;
        }
        Scene few = request.scene().with(SceneSettings.ENVIRONMENT_LIGHTS, OptionalInt.of(LightList.FEW));
        return pixels.like().set(chosen, draw(request.with(few)), across, down);
    }

    /**
     * Returns the scene's exposure if it is set, else the automatic exposure of a small picture with the same ratio of sides. It is {@link
     * #bounded} by those under {@link Scene#lightsAround}: an order that the light's own direction sends to the camera does not decide. It
     * depends neither on the whole picture's size and samples nor on finer levels of a color table than the coarsest: a picture that is
     * refined level by level keeps its exposure.
     *
     * @param interrupted polled before each tile
     * @return empty if interrupted
     */
    public OptionalDouble exposure(Scene scene, int width, int height, TimedTiles tiles, BooleanSupplier interrupted) {
        if (scene.get(SceneSettings.EXPOSURE).isPresent()) {
            return scene.get(SceneSettings.EXPOSURE);
        }
        OptionalDouble own = exposureUnder(scene, meter(width, height, METER_SIDE), tiles, interrupted);
        List<Scene> around = scene.lightsAround();
        double[] others = around.stream()
                .map(lit -> exposureUnder(lit, meter(width, height, AROUND_SIDE), tiles, interrupted))
                .flatMapToDouble(OptionalDouble::stream)
                .toArray();
        return own.isPresent() && others.length == around.size()
                ? OptionalDouble.of(bounded(own.getAsDouble(), others))
                : OptionalDouble.empty();
    }

    /** Returns an exposure, or the nearest that is at most {@link #MOST_BY_LIGHT} times off the median of an even number of others. */
    static double bounded(double own, double[] others) {
        if (others.length == 0) {
            return own;
        }
        double[] sorted = Arrays.stream(others).sorted().toArray();
        double middle = Math.sqrt(sorted[sorted.length / 2 - 1] * sorted[sorted.length / 2]);
        return Math.max(middle / MOST_BY_LIGHT, Math.min(middle * MOST_BY_LIGHT, own));
    }

    private OptionalDouble exposureUnder(Scene scene, Tile meter, TimedTiles tiles, BooleanSupplier interrupted) {
        int samples = scene.method().isTable() ? TABLE_SAMPLES : 1;
        ScenePicture small = ScenePicture.empty(meter.width(), meter.height());
        boolean isWhole = tiles.draw(meter.divide(TimedTiles.LARGEST), interrupted, tile -> {
            DrawRequest request = DrawRequest.ofPixels(scene, meter.width(), meter.height(), tile, samples);
            small.put(draw(request.coarsest()).reduced(samples), tile.x(), tile.y());
        });
        return isWhole ? OptionalDouble.of(LinearPicture.exposure(small.linear())) : OptionalDouble.empty();
    }

    static List<DrawRequest> meterParts(Scene scene, int width, int height) {
        return Stream.concat(
                        meterParts(scene, meter(width, height, METER_SIDE)),
                        scene.lightsAround().stream()
                                .flatMap(lit -> meterParts(lit, meter(width, height, AROUND_SIDE))))
                .toList();
    }

    private static Stream<DrawRequest> meterParts(Scene scene, Tile meter) {
        return SceneSession.parts(scene, meter.width(), meter.height(), PixelSamples.uniform(TABLE_SAMPLES)).stream()
                .map(DrawRequest::coarsest);
    }

    private static Tile meter(int width, int height, int side) {
        double scale = side / (double) Math.max(width, height);
        return Tile.whole((int) Math.max(1, Math.round(scale * width)), (int) Math.max(1, Math.round(scale * height)));
    }

    /** Returns the sessions of each look, the look's first object as key. */
    private Map<Integer, List<SceneSession>> looks() {
        return sessions.stream()
                .collect(Collectors.groupingBy(
                        session -> session.data().look(), LinkedHashMap::new, Collectors.toList()));
    }

    /** Returns the index of each light; of an environment, whose lights are many, no index, which stands for all together. */
    private static Stream<OptionalInt> lightByLight(Scene scene) {
        if (scene.hasEnvironment()) {
            return Stream.of(OptionalInt.empty());
        }
        int lights = LightList.of(scene, Optional.empty()).count();
        return IntStream.range(0, lights).mapToObj(OptionalInt::of);
    }

    private static ScenePicture underOneLight(List<SceneSession> parts, DrawRequest request) {
        ScenePicture light = light(parts, request, SceneSession::draw);
        return request.scene().hasBody() ? over(parts, body(parts, request), light, request) : light;
    }

    /**
     * Draws a preview: few samples of diffracted light, interpolated, over the body in full resolution.
     *
     * @param stride every stride-th pixel of every stride-th row has a sample; a power of two
     * @param white luminance to which brighter samples are dimmed, so that interpolation does not spread a glint
     * @param interrupted polled before each tile
     * @return empty if interrupted
     */
    public Optional<ScenePicture> coarse(
            Scene scene,
            int width,
            int height,
            int stride,
            double white,
            TimedTiles tiles,
            BooleanSupplier interrupted) {
        int columns = SceneBlocks.ceilDiv(width, stride);
        int rows = SceneBlocks.ceilDiv(height, stride);
        List<ScenePicture> looks = new ArrayList<>();
        for (Map.Entry<Integer, List<SceneSession>> look : looks().entrySet()) {
            List<SceneSession> parts = look.getValue();
            Scene own = scene.at(look.getKey());
            List<ScenePicture> lit = new ArrayList<>();
            for (OptionalInt alone : lightByLight(own).toList()) {
                ScenePicture light = ScenePicture.empty(columns, rows);
                boolean isWhole = tiles.draw(Tile.whole(columns, rows).divide(TimedTiles.LARGEST), interrupted, few -> {
                    int x = stride * few.x();
                    int y = stride * few.y();
                    int right = Math.min(x + stride * few.width(), width);
                    int bottom = Math.min(y + stride * few.height(), height);
                    Tile tile = new Tile(x, y, right - x, bottom - y);
                    var request = new DrawRequest(
                            own, width, height, tile, 1, stride, stride, false, Optional.empty(), alone);
                    light.put(light(parts, request, PartSum::drawResident), few.x(), few.y());
                });
                if (!isWhole) {
                    return Optional.empty();
                }
                DrawRequest whole = DrawRequest.ofPixels(own, width, height, Tile.whole(width, height), 1)
                        .under(alone);
                ScenePicture body = body(parts, whole);
                lit.add(over(parts, body, light.enlarged(stride, body, white), whole));
            }
            looks.add(ScenePicture.sum(lit));
        }
        return Optional.of(ScenePicture.joined(looks));
    }

    /** Draws from resident tiles, from those of the coarsest level alone where one is missing. */
    private static ScenePicture drawResident(SceneSession session, DrawRequest request) {
        ScenePicture part = session.drawResident(request);
        return PackedShading.isMissing(part.rgba()) ? session.drawResident(request.coarsest()) : part;
    }

    private static ScenePicture light(
            List<SceneSession> parts,
            DrawRequest request,
            BiFunction<SceneSession, DrawRequest, ScenePicture> drawing) {
        DrawRequest diffracted = request.with(request.scene().withoutBody());
        ScenePicture light = ScenePicture.empty(request.columns(request.tile()), request.rows(request.tile()));
        parts.forEach(session -> add(drawing.apply(session, diffracted), light));
        return light;
    }

    private static ScenePicture body(List<SceneSession> parts, DrawRequest request) {
        return parts.get(0).draw(request.with(request.scene().with(SceneSettings.DIFFRACTION, 0.0)));
    }

    /** A missing color adds no diffracted light. All parts have the same coverage, except that a missing color has -1 instead of 1. */
    private static void add(ScenePicture part, ScenePicture sum) {
        for (int i = 0; i < sum.rgba().length; i++) {
            sum.rgba()[i] = i % 4 == 3 ? Math.abs(part.rgba()[i]) : sum.rgba()[i] + part.rgba()[i];
        }
    }

    /** Hides the body by the diffracted light, relative to white: that of one light, or of all of an environment. */
    private static ScenePicture over(
            List<SceneSession> parts, ScenePicture body, ScenePicture light, DrawRequest request) {
        Scene scene = request.scene();
        double intensity = parts.get(0).lights(request).white();
        // With Fresnel's reflectance as opacity the shader has already attenuated the body.
        boolean byLight = scene.bodyAlpha() == BodyAlpha.LIGHT;
        double share = byLight ? 1 : 1 - scene.ambient();
        float[] rgba = light.rgba().clone();
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double alpha = byLight && intensity > 0 ? Math.min(1, rgba[pixel + 1] / intensity) : 0;
            for (int c = 0; c < 3; c++) {
                rgba[pixel + c] = (float) (share * rgba[pixel + c] + (1 - alpha) * body.rgba()[pixel + c]);
            }
            rgba[pixel + 3] = body.rgba()[pixel + 3];
        }
        return new ScenePicture(light.width(), light.height(), rgba);
    }
}
