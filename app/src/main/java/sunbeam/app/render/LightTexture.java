package sunbeam.app.render;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.scene.Light;
import jrtr.scene.RenderItem;
import jrtr.scene.RenderPass;
import jrtr.scene.View;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import org.joml.Vector4f;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.render.LightList.Group;
import sunbeam.app.scene.environment.RadianceMap;

/** Lights and shadow maps in graphics memory (shaders/include/light_list.glsl, shadow.glsl). Belongs to its context's thread. */
final class LightTexture implements AutoCloseable {
    private static final int ROWS = 9;
    private static final int CHANNELS = 4;
    // Rows of the texture, as in the shader.
    private static final int TOWARDS = 0;
    private static final int COLOR = 1;
    private static final int STRETCH = 2;
    private static final int LIGHTS = 3;
    private static final int TILE = 4;
    private static final int MATRIX = 5;

    // In texels, sides of the image of all maps: for still pictures, and for moving ones, which may draw each frame.
    private static final int SIDE = 1024;
    private static final int MANY_SIDE = 2048;
    private static final int MOVING_SIDE = 320;
    // In texels, and points along a texel's side.
    private static final int SKY_SIDE = 256;
    private static final int SKY_POINTS = 3;
    // In radii of the mesh; the light's rays are parallel within a degree.
    private static final float DISTANCE = 60;
    // In texels along the normal, so that a surface does not shade itself.
    private static final float LIFT = 2;
    // Distance of near and far plane from the mesh's center, in its radii; above 1, so that rounding clips nothing.
    private static final float MARGIN = 1.02f;

    private final RenderContext context;
    private final FloatTexture sky;
    private final FloatTarget noShadows;
    private final ShaderProgram program;
    // Keys are sides.
    private final Map<Integer, FloatTarget> maps = new HashMap<>();
    private final Map<Integer, Casting> drawn = new HashMap<>();
    private FloatTexture texture;
    private float[] texels;
    private Shown shown;
    private Optional<RadianceMap> shownSky = Optional.empty();
    private Vector3f horizon = new Vector3f();

    /** Input of the maps: equal inputs draw equal maps. */
    private record Casting(List<RenderItem> items, List<Vector3fc> directions) {}

    private record Shown(List<RenderItem> items, LightList lights, int side) {}

    LightTexture(RenderContext context) {
        this.context = context;
        enlarge(LightList.MOST);
        this.sky = Resource.orClose(
                () -> context.createFloatTexture(
                        "sky",
                        FloatTexture.Spec.flat(SKY_SIDE, SKY_SIDE, FloatTexture.Format.RGBA32F)
                                .with(FloatTexture.Filter.LINEAR)),
                texture::close);
        this.noShadows =
                Resource.orClose(() -> context.createFloatTarget("no shadows", spec(1)), texture::close, sky::close);
        this.program = Resource.orClose(
                () -> context.createMeshProgram(Shaders.library().load("shadow.frag")),
                texture::close,
                sky::close,
                noShadows::close);
        sky.upload(new float[CHANNELS * SKY_SIDE * SKY_SIDE]);
    }

    private void enlarge(int columns) {
        FloatTexture larger = context.createFloatTexture(
                "lights", FloatTexture.Spec.flat(columns, ROWS, FloatTexture.Format.RGBA32F));
        if (texture != null) {
            texture.close();
        }
        texture = larger;
        texels = new float[CHANNELS * ROWS * columns];
    }

    private static FloatTarget.Spec spec(int side) {
        return new FloatTarget.Spec(side, side, 1, true, FloatTarget.Format.RGBA8);
    }

    /** Uploads lights and draws their maps unless both are up to date; moving pictures have coarser maps. */
    void update(LightList lights, List<RenderItem> items, boolean moves) {
        List<Group> shadowed =
                lights.groups().stream().filter(Group::hasShadows).toList();
        int side = moves ? MOVING_SIDE : shadowed.size() > 1 ? MANY_SIDE : SIDE;
        Shown wanted = new Shown(items, lights, side);
        if (wanted.equals(shown)) {
            return;
        }
        List<Vector3fc> directions = shadowed.stream().map(Group::middle).toList();
        Casting casting = new Casting(items, directions);
        BoundingSphere bounds = items.stream()
                .map(RenderItem::bounds)
                .reduce(BoundingSphere::with)
                .orElseThrow();
        int across = (int) Math.ceil(Math.sqrt(directions.size()));
        if (!directions.isEmpty() && !casting.equals(drawn.get(side))) {
            FloatTarget map = maps.computeIfAbsent(side, all -> context.createFloatTarget("shadows", spec(all)));
            for (int i = 0; i < directions.size(); i++) {
                draw(items, view(bounds, directions.get(i)), map, across, i);
            }
            drawn.put(side, casting);
        }
        upload(lights, bounds, side, across);
        shown = wanted;
    }

    /** Uploads the surroundings that gloss mirrors, unless the weight is 0. */
    void surround(LightList lights, Optional<RadianceMap> environment) {
        if (lights.skyWeight() == 0) {
            return;
        }
        RadianceMap map = environment.orElseGet(RadianceMap::sky);
        if (shownSky.filter(old -> old.equals(map)).isPresent()) {
            return;
        }
        sky.upload(octahedron(map, SKY_SIDE));
        horizon = map.horizon();
        shownSky = Optional.of(map);
    }

    /** Returns RGBA of a map on the square of include/octahedron.glsl, by rows. */
    static float[] octahedron(RadianceMap map, int side) {
        float[] rgba = new float[CHANNELS * side * side];
        IntStream.range(0, side * side).parallel().forEach(i -> {
            Vector3f mean = new Vector3f();
            for (int point = 0; point < SKY_POINTS * SKY_POINTS; point++) {
                int row = i / side;
                int down = point / SKY_POINTS;
                double x = i % side + (point % SKY_POINTS + 0.5) / SKY_POINTS;
                double y = row + (down + 0.5) / SKY_POINTS;
                mean.add(map.radiance(fromOctahedron(2 * x / side - 1, 2 * y / side - 1)));
            }
            for (int c = 0; c < 3; c++) {
                rgba[CHANNELS * i + c] = mean.get(c) / (SKY_POINTS * SKY_POINTS);
            }
        });
        return rgba;
    }

    /** Is the mapping of include/octahedron.glsl. */
    private static Vector3f fromOctahedron(double x, double y) {
        double z = 1 - Math.abs(x) - Math.abs(y);
        double foldedX = z < 0 ? Math.copySign(1 - Math.abs(y), x) : x;
        double foldedY = z < 0 ? Math.copySign(1 - Math.abs(x), y) : y;
        return new Vector3f((float) foldedX, (float) foldedY, (float) z);
    }

    /** Linear Rec. 709 of the surroundings at the horizon. */
    Vector3f horizon() {
        return horizon;
    }

    private void draw(List<RenderItem> items, View view, FloatTarget map, int across, int number) {
        int side = map.spec().width() / across;
        int x = number % across * side;
        int y = number / across * side;
        View.Area area = new View.Area(
                side, side, new Tile(-x, -y, map.spec().width(), map.spec().height()));
        new RenderPass(context, program, Map.of(), true).draw(items, view, area, map, new Tile(x, y, side, side));
    }

    private static View view(BoundingSphere bounds, Vector3fc towards) {
        float distance = DISTANCE * bounds.radius();
        float reach = MARGIN * bounds.radius();
        Vector3f eye = new Vector3f(bounds.center()).fma(distance, towards);
        Vector3f up = Math.abs(towards.z()) < 0.9f ? new Vector3f(0, 0, 1) : new Vector3f(1, 0, 0);
        float angle = (float) (2 * Math.atan(reach / (distance - reach)));
        return new View(new Camera(eye, bounds.center(), up), angle, 0, distance - reach, distance + reach);
    }

    private void upload(LightList lights, BoundingSphere bounds, int side, int across) {
        List<Light> all = lights.all();
        if (all.size() > texels.length / (CHANNELS * ROWS)) {
            enlarge(all.size());
        }
        for (int i = 0; i < all.size(); i++) {
            Light light = all.get(i);
            put(TOWARDS, i, light.towards(), Math.pow(light.deviation(), 2));
            put(COLOR, i, light.radiance(), 0);
            put(STRETCH, i, light.stretch(), 0);
        }
        int first = 0;
        int map = 0;
        for (int i = 0; i < lights.groups().size(); i++) {
            Group group = lights.groups().get(i);
            int end = first + group.lights().size();
            put(LIGHTS, i, first, end, 0, 0);
            if (group.hasShadows()) {
                int texelsAcross = side / across;
                float lift = LIFT * 2 * MARGIN * bounds.radius() / texelsAcross;
                put(LIGHTS, i, first, end, 1, lift);
                double share = (double) texelsAcross / side;
                put(TILE, i, share * (map % across), 1 - share * (map / across + 1), share, group.penumbra());
                View.Area area = View.Area.whole(texelsAcross, texelsAcross);
                Matrix4f toClip = view(bounds, group.middle()).worldToClip(area);
                for (int column = 0; column < CHANNELS; column++) {
                    Vector4f values = toClip.getColumn(column, new Vector4f());
                    put(MATRIX + column, i, values.x, values.y, values.z, values.w);
                }
                map++;
            }
            first = end;
        }
        texture.upload(texels);
    }

    private void put(int row, int column, Vector3fc vector, double fourth) {
        put(row, column, vector.x(), vector.y(), vector.z(), fourth);
    }

    private void put(int row, int column, double... values) {
        for (int c = 0; c < CHANNELS; c++) {
            texels[(texels.length / ROWS) * row + CHANNELS * column + c] = (float) values[c];
        }
    }

    /** Returns the textures of include/light_list.glsl and include/shadow.glsl, by sampler. */
    Map<String, Texture> textures() {
        FloatTarget map = maps.getOrDefault(shown.side(), noShadows);
        return Map.of("lightList", texture, "shadowMap", map.depth());
    }

    /** Returns the texture of include/sky.glsl, by sampler. */
    Map<String, Texture> surroundings() {
        return Map.of("skyMap", sky);
    }

    @Override
    public void close() {
        texture.close();
        sky.close();
        noShadows.close();
        program.close();
        maps.values().forEach(FloatTarget::close);
    }
}
