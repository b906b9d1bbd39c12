package sunbeam.app.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.Opening;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.LightUniforms;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.Footprints;
import sunbeam.app.gpu.colors.LevelTiles;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.BodyAlpha;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.RefractiveIndex;

/** A diffraction method on a mesh: its tables and the program shaders/skin.frag with it compiled in. */
final class SkinSurface implements AutoCloseable {
    // Of each point: few of the slopes meet a sharp order. Pictures of many points are what others are compared with.
    private static final int LEAST_SLOPES = 16;
    private static final int SLOPES_PER_SAMPLE_ACROSS = 6;

    // Along a footprint's major axis.
    private static final int MOST_TAPS = 8;

    private final UploadedTables method;
    // Radiance of a mirror under the window in that of sunlight; 1 of what no mirror is the measure of.
    private final double mirror;
    private final ShaderProgram program;
    private final Optional<LevelTiles> levels;
    private final Optional<SkinPart> part;
    // Compiled when something moves for the first time.
    private MovingSkin moving;

    private SkinSurface(
            UploadedTables method,
            double mirror,
            ShaderProgram program,
            Optional<LevelTiles> levels,
            Optional<SkinPart> part) {
        this.method = method;
        this.mirror = mirror;
        this.program = program;
        this.levels = levels;
        this.part = part;
    }

    static SkinSurface create(RenderContext context, SceneData data) {
        UploadedTables method = UploadedTables.upload(context, data.tables());
        String colorLevels = data.levels().isPresent() ? "1" : "0";
        ShaderProgram program =
                Opening.orClose(() -> method.program("skin.frag", Map.of("COLOR_LEVELS", colorLevels)), method::close);
        Optional<LevelTiles> levels = Opening.orClose(
                () -> data.levels().map(sources -> new LevelTiles(context, sources)), program::close, method::close);
        boolean isNormalizedToMirror = data.scene().method().method().isNormalizedToMirror();
        double mirror = isNormalizedToMirror ? new CoherenceWindow(method.windowSigma()).mirrorRadiance() : 1;
        return new SkinSurface(method, mirror, program, levels, data.part());
    }

    /** The tables, which others in this context may draw with for as long as the surface is there. */
    UploadedTables method() {
        return method;
    }

    /** The tiles of its color table, whose colors are means over footprints; empty for methods that see points. */
    Optional<LevelTiles> levels() {
        return levels;
    }

    /** Of how many draws a picture is the mean: methods that see points have one slope of fine relief in each. */
    int draws(Scene scene, int samplesAcross) {
        return levels.isEmpty() && scene.slopeDeviation() > 0
                ? Math.max(LEAST_SLOPES, SLOPES_PER_SAMPLE_ACROSS * samplesAcross)
                : 1;
    }

    /**
     * Lights texels of a block: image 0 of the target is linear XYZ and coverage; images 1 and 2 are the {@link Footprints} where there are
     * {@link #levels}.
     *
     * @param sources which, by {@link GeometryBuffer#texel}; -1 for none
     * @param target as large as the sources; undefined where there is none
     * @param tile part of the target
     * @param pass what is drawn of them
     */
    void shade(
            RenderContext context,
            Scene scene,
            GeometryBuffer buffer,
            FloatTexture sources,
            FloatTarget target,
            Tile tile,
            ShadingPass pass) {
        setLight(program, scene);
        List<Binding> textures = new ArrayList<>(method.bindings());
        textures.addAll(buffer.bindings());
        if (levels.isPresent()) {
            FootprintUniforms.apply(program, levels.get().table(), scene, MOST_TAPS, pass.samplesAcross());
            program.set("stride", (float) pass.stride());
            program.set("lookUps", pass.hasColors() ? 1 : 0);
            textures.addAll(levels.get().bindings());
        } else {
            program.set("slopeDeviation", (float) scene.slopeDeviation());
            program.set("slopeDraw", pass.draw());
        }
        textures.add(new Binding("sources", sources));
        context.drawFullScreen(program, textures, target, tile);
    }

    /** Draws a block of a picture of what moves (see {@link MovingSkin}). */
    int[] move(
            RenderContext context,
            Scene scene,
            Optional<Ground> ground,
            SkinGeometry geometry,
            GeometryBuffer buffer,
            Tile block,
            double exposure) {
        int lights = SceneGraphs.lights(scene).size();
        if (moving == null || moving.lights() != lights) {
            closeMoving();
            moving = new MovingSkin(context, method, levels.orElseThrow(), lights);
        }
        setLight(moving.program(), scene);
        return moving.draw(scene, ground, geometry, buffer, block, method.bindings(), exposure);
    }

    /** What jrtr/lights.glsl and include/blend.glsl ask for. */
    private void setLight(ShaderProgram program, Scene scene) {
        LightUniforms.of(SceneGraphs.lights(scene)).applyTo(program);
        Blend blend = scene.blend();
        program.set("diffractionWeight", (float) (blend.diffraction() * mirror));
        program.set("textureWeight", (float) blend.texture());
        program.set("diffuseWeight", (float) blend.diffuse());
        program.set("skyWeight", (float) (blend.hasBody() ? scene.around().sky() : 0));
        program.set("ambientWeight", (float) blend.ambient());
        program.set("fresnelAlpha", scene.bodyAlpha() == BodyAlpha.FRESNEL ? 1f : 0f);
        setReflection(program, scene);
    }

    /** An index that is the same at all wavelengths weights directions alone; otherwise the tables are of a part. */
    private void setReflection(ShaderProgram program, Scene scene) {
        if (part.isPresent()) {
            ReflectionPart reflection = part.get().reflection();
            program.set("mirrorWeight", (float) reflection.constant());
            program.set("grazingWeight", (float) reflection.schlick());
            return;
        }
        RefractiveIndex index = scene.get(SceneSettings.INDEX).constant().orElseThrow();
        double normal = index.reflectance(CieTable.MINIMUM_WAVELENGTH);
        program.set("mirrorWeight", 1f);
        program.set("grazingWeight", (float) ((1 - normal) / normal));
    }

    private void closeMoving() {
        if (moving != null) {
            moving.close();
            moving = null;
        }
    }

    @Override
    public void close() {
        closeMoving();
        levels.ifPresent(LevelTiles::close);
        program.close();
        method.close();
    }
}
