package sunbeam.app.scene;

import java.util.ArrayList;
import java.util.List;
import jrtr.FloatTargetSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.Opening;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.LightUniforms;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.precompute.method.LevelBakers;

/** How a skin's pixels look into levels of colors (shaders/footprints.frag), and the tiles that they look into. */
final class SkinFootprints implements AutoCloseable {
    private static final List<String> SAMPLERS =
            List.of("footprintCenters", "footprintMajorAxes", "footprintMinorAxes", "footprintEdges");
    private static final int CHANNELS = 4;
    // Along the major axis of what a pixel sees.
    private static final int MOST_PLACES = 32;

    private final RenderContext context;
    private final LevelTiles tiles;
    private final ShaderProgram program;
    private final FloatTarget target;

    SkinFootprints(RenderContext context, LevelBakers sources) {
        this.context = context;
        this.tiles = new LevelTiles(context, sources);
        this.program = Opening.orClose(
                () -> context.createFullScreenProgram(Shaders.library().load("footprints.frag")), tiles::close);
        FloatTargetSpec spec = new FloatTargetSpec(Packing.COLUMNS, Packing.ROWS, SAMPLERS.size(), false);
        this.target =
                Opening.orClose(() -> context.createFloatTarget("footprints", spec), program::close, tiles::close);
        setLevels(program);
    }

    /** Tells a program that finds footprints how wide levels are. */
    void setLevels(ShaderProgram looking) {
        double variance = Math.pow(tiles.table().finestSigma(), 2);
        looking.set("finestVariance", (float) variance);
        looking.set("perFinestVariance", (float) (1 / variance));
        looking.set("pointVariance", (float) Math.pow(tiles.table().sigma(), 2));
        looking.set("tabulatedSlopeVariance", (float) Math.pow(tiles.table().slopeDeviation(), 2));
        int ofPoints = tiles.table().ofPoints();
        looking.set("pointLevels", (float) ofPoints);
        looking.set("levels", tiles.table().levels().size() - ofPoints);
    }

    /** Tells such a program of what relief its levels do not have. */
    void setSlopes(ShaderProgram looking, Scene scene) {
        looking.set(
                "slopeVariance", tiles.table().slopeDeviation() > 0 ? 0 : (float) Math.pow(scene.slopeDeviation(), 2));
    }

    /**
     * Finds how some texels of a block look.
     *
     * @param stride pixels along a side of what each texel stands for
     * @param samplesAcross of the mesh along a side of a pixel
     * @param sources which, as {@link SkinSurface#shade} has them
     * @param used part of the target that they take
     */
    void find(Scene scene, GeometryBuffer buffer, int stride, int samplesAcross, FloatTexture sources, Tile used) {
        LightUniforms.of(SceneGraphs.lights(scene)).applyTo(program);
        setSlopes(program, scene);
        program.set("stride", (float) stride);
        program.set("samplesAcross", (float) samplesAcross);
        program.set("mostPlaces", (float) MOST_PLACES);
        List<Binding> textures = new ArrayList<>(buffer.bindings());
        textures.add(new Binding("sources", sources));
        context.drawFullScreen(program, textures, target, used);
    }

    /** Notes into which tiles those texels look that were found last. */
    void note(Packing packing, Tile used) {
        float[] places = target.read(0, used);
        float[] wide = target.read(1, used);
        float[] narrow = target.read(2, used);
        float[] edges = target.read(3, used);
        tiles.note(places, wide, narrow, edges, packing.count(), i -> CHANNELS * packing.read(i));
    }

    LevelTiles tiles() {
        return tiles;
    }

    /** What shaders/method/table_levels.glsl reads beside the levels' settings, for the texels that were found last. */
    List<Binding> bindings() {
        List<Binding> bindings = new ArrayList<>(tiles.bindings());
        for (int i = 0; i < SAMPLERS.size(); i++) {
            bindings.add(new Binding(SAMPLERS.get(i), target.texture(i)));
        }
        return bindings;
    }

    /** Whether one of these texels was lit by a tile that does not exist (shaders/skin.frag). */
    static boolean isMissing(float[] lit) {
        for (int alpha = CHANNELS - 1; alpha < lit.length; alpha += CHANNELS) {
            if (lit[alpha] < 0) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void close() {
        target.close();
        program.close();
        tiles.close();
    }
}
