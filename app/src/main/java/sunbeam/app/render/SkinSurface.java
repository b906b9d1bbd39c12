package sunbeam.app.render;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.scene.Light;
import sunbeam.app.gpu.UploadedTables;
import sunbeam.app.gpu.colors.Footprints;
import sunbeam.app.gpu.colors.VirtualTexture;
import sunbeam.app.render.PackedShading.Part;
import sunbeam.app.render.SceneData.ReflectanceComponent;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSettings.BodyAlpha;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.ShaderTables;

/** A diffraction method on a mesh: the method's tables, and shaders/skin.frag compiled with the method. */
final class SkinSurface implements AutoCloseable {
    // Each draw has one random slope of fine relief: at least LEAST_SLOPES draws, else SLOPES_PER_SAMPLE_ACROSS per
    // sample along a pixel's side. Few slopes meet a sharp order, and these pictures are the reference for method
    // table.
    private static final int LEAST_SLOPES = 16;
    // Draws of an environment's lights.
    private static final int LEAST_LIGHTS = 64;
    private static final int SLOPES_PER_SAMPLE_ACROSS = 6;

    private static final int MOST_TAPS = 8;
    // Software renderers have time for one tap along the major axis; a coarser level then blurs it, too.
    private static final int MOVING_SOFTWARE_TAPS = 1;
    private static final int MOVING_HARDWARE_TAPS = 4;

    // Each sample of a square of 2 x 2 has its quarter of many lights.
    static final int LIGHT_STRIDE = 4;
    // Rounds levels up, so that lights of neighboring regions leave no ripples between them.
    private static final float MANY_ROUNDING = 0.85f;

    // Share of the diffracted light that stands in, spread evenly, for missing colors: the median of what built-in
    // scenes send to their cameras; the rest stays near the mirror's direction.
    private static final double EVEN_SHARE = 0.2;

    // Relative radiance of a surface that spreads a mirror's light evenly, at 550 nm under sunlight's window:
    // (wavelength / (2 pi sigma))^2.
    private static final double EVEN_RADIANCE = Math.pow(
            550e-9
                    * CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH)
                            .sigmaFrequency(),
            2);

    private final RenderContext context;
    private final UploadedTables method;
    // Radiance of a mirror under the coherence window, relative to sunlight; 1 for methods not normalized to a mirror.
    private final double diffractionScale;
    private final Optional<VirtualTexture> texture;
    private final Optional<ReflectanceComponent> component;
    // Keys are defines.
    private final Map<Map<String, String>, ShaderProgram> programs = new HashMap<>();
    // Keys are numbers of lights.
    private final Map<Integer, ShaderProgram> movingPrograms = new HashMap<>();
    private final CachedTarget movingTarget = new CachedTarget();

    /** @param data empty for a surface without diffraction, which draws moving pictures alone */
    SkinSurface(RenderContext context, Optional<SceneData> data) {
        this.context = context;
        this.method = UploadedTables.upload(
                context, data.map(SceneData::tables).orElseGet(() -> new ShaderTables.Builder("none").build(0, 0)));
        this.texture = Resource.orClose(
                () -> data.flatMap(SceneData::bakers).map(bakers -> new VirtualTexture(context, bakers)),
                method::close);
        this.component = data.flatMap(SceneData::reflectanceComponent);
        double sigma = method.tables().windowSigma();
        this.diffractionScale = data.map(found -> found.scene().method().method())
                .map(found -> found.isNormalizedToMirror() ? new CoherenceWindow(sigma).mirrorRadiance() : 1)
                .orElse(1.0);
    }

    /** Callers may use the tables in this context until the surface is closed. */
    UploadedTables method() {
        return method;
    }

    /** Empty for methods that evaluate points. */
    Optional<VirtualTexture> virtualTexture() {
        return texture;
    }

    /** Number of draws whose mean is the picture: each has one slope of fine relief and one direction of a wide light. */
    int draws(Scene scene, LightList lights, int samplesAcross) {
        if (texture.isPresent() || !(scene.slopeDeviation() > 0 || lights.areWide() || lights.areDrawn())) {
            return 1;
        }
        int least = lights.areDrawn() ? LEAST_LIGHTS : LEAST_SLOPES;
        return Math.max(least, SLOPES_PER_SAMPLE_ACROSS * samplesAcross);
    }

    /** Number of lights that a pass draws: footprints read tables quickly, points may need all steps of loops that a driver allows. */
    int lightsPerPass(LightList lights) {
        return texture.isPresent() || lights.areDrawn() ? LightList.MOST : 1;
    }

    /**
     * Shades texels of a block. Image 0 of the target gets linear XYZ and coverage; with a {@link #virtualTexture} images 1 and 2 get
     * centers and axes of {@link Footprints}.
     *
     * @param sources texel to shade of each target pixel, as by {@link GeometryBuffer#texel}; -1 for none
     * @param target as large as the sources; undefined at pixels without source
     * @param firstLight first of the lights that are drawn
     * @param lastLight light after the last
     * @param draw index below {@link #draws}; without colors, 0 for the footprint's own level, 1 for the next
     * @param hasColors false to write footprints only
     */
    void shade(
            Part part,
            FloatTexture sources,
            FloatTarget target,
            Tile tile,
            int firstLight,
            int lastLight,
            int draw,
            boolean hasColors) {
        DrawRequest request = part.request();
        Scene scene = request.scene();
        boolean areMany =
                texture.isPresent() && part.lights().areMany() && !part.lights().areFinest();
        boolean areShared = areMany && part.lights().areShared() && hasColors && request.samples() % 2 == 0;
        ShaderProgram program =
                programs.computeIfAbsent(defines(areMany, areShared), defines -> method.program("skin.frag", defines));
        setBlend(program, scene, part.lights());
        program.set("drawnPatch", (float)
                SceneData.patchNumber(part.data().look(), part.data().region()));
        program.set("firstLight", firstLight);
        program.set("lastLight", lastLight);
        program.set("lightGroups", part.lights().groups().size());
        program.set("lightsAreDrawn", part.lights().areDrawn() ? 1 : 0);
        program.set("targetToWorld", part.geometry().blockToWorld(part.piece().block()));
        Map<String, Texture> textures = new HashMap<>(method.textures());
        textures.putAll(part.buffer().textures());
        textures.put("depths", part.buffer().attributes().depth());
        textures.putAll(part.inMemory().textures());
        textures.putAll(part.inMemory().surroundings());
        if (texture.isPresent()) {
            ColorTable table = texture.get().table();
            setFootprints(program, table, scene);
            program.set("leastLevel", request.isCoarsest() ? table.levels().size() - 1f : 0);
            program.set("mostTaps", (float) MOST_TAPS);
            program.set("levelRounding", areMany ? MANY_ROUNDING : 0);
            program.set("samplesAcross", (float) Math.max(1, request.samples() / request.footprintScale()));
            program.set("footprintScale", (float) request.footprintScale());
            program.set("lookUps", hasColors ? 1 : 0);
            program.set("nextLevel", (float) (hasColors ? 0 : draw));
            textures.putAll(texture.get().textures());
        } else {
            program.set("slopeDeviation", (float) scene.slopeDeviation());
            program.set("slopeDraw", draw);
        }
        textures.put("sources", sources);
        context.drawFullScreen(program, textures, target, tile);
    }

    /** Errors of linear interpolation along w have either sign under many lights, and cancel. */
    private Map<String, String> defines(boolean areMany, boolean areShared) {
        Map<String, String> defines = new HashMap<>();
        defines.put("COLOR_LEVELS", texture.isPresent() ? "1" : "0");
        defines.put("LIGHT_STRIDE", areShared ? LIGHT_STRIDE + "" : "1");
        if (areMany) {
            defines.put("SLICE_TAPS", "2");
        }
        return defines;
    }

    /** Sets the uniforms of shaders/include/footprint.glsl. Fine relief widens footprints unless the table's levels include it. */
    private static void setFootprints(ShaderProgram program, ColorTable table, Scene scene) {
        program.set("finestVariance", (float) Math.pow(table.finestSigma(), 2));
        program.set("pointVariance", (float) Math.pow(table.sigma(), 2));
        program.set("tabulatedSlopeVariance", (float) Math.pow(table.slopeDeviation(), 2));
        program.set("slopeVariance", table.slopeDeviation() > 0 ? 0 : (float) Math.pow(scene.slopeDeviation(), 2));
        program.set("pointLevels", (float) table.pointLevelCount());
        program.set("levels", table.levels().size() - table.pointLevelCount());
        program.set("lightOverlap", scene.hasEnvironment() ? (float) Math.pow(LightList.OVERLAP, 2) : 1);
    }

    /**
     * Draws a block of a moving picture in sRGB (shaders/moving.frag): few taps per pixel in resident tiles.
     *
     * @param buffer geometry in {@link GeometryBuffer.Layout#MOVING}
     * @return pixels as 0xRRGGBB, top row first; the highest byte is 255 less the level that stands in for a finer one, if a tile is missing
     */
    int[] drawMoving(
            Scene scene,
            Optional<Ground> ground,
            SkinGeometry geometry,
            LightList list,
            LightTexture inMemory,
            GeometryBuffer buffer,
            Tile block,
            double exposure,
            int leastLevel) {
        List<Light> lights = list.all().subList(0, Math.min(Light.MOST, list.count()));
        int taps = context.info().software() ? MOVING_SOFTWARE_TAPS : MOVING_HARDWARE_TAPS;
        ShaderProgram moving = movingPrograms.computeIfAbsent(
                lights.size(),
                count -> method.program("moving.frag", Map.of("MOST_TAPS", taps + "", "LIGHTS", count + "")));
        Light.apply(lights, moving);
        setBlend(moving, scene, list);
        float[] variances = Floats.of(lights.size(), i -> Math.pow(lights.get(i).deviation(), 2));
        moving.set("lightVariances", variances);
        Map<String, Texture> textures = new HashMap<>(method.textures());
        boolean isEven = scene.method().method().isNormalizedToMirror();
        moving.set("evenLight", isEven ? (float) (EVEN_SHARE * EVEN_RADIANCE / diffractionScale) : 0);
        moving.set("usableLevels", (float) texture.filter(tiles -> tiles.coarsestShare() == 1)
                .map(tiles -> tiles.table().levels().size())
                .orElse(0));
        texture.ifPresent(tiles -> {
            setFootprints(moving, tiles.table(), scene);
            moving.set("leastLevel", (float) leastLevel);
            moving.set("mostTaps", (float) taps);
            moving.set("levelRounding", 0f);
            moving.set("samplesAcross", 1f);
            textures.putAll(tiles.textures());
        });
        geometry.applyRaysTo(moving, block);
        moving.set("targetToWorld", geometry.blockToWorld(block));
        moving.set("exposure", (float) exposure);
        moving.set("toneStart", (float) scene.display(exposure).tone().start());
        textures.putAll(buffer.textures());
        textures.put("depths", buffer.attributes().depth());
        textures.putAll(inMemory.textures());
        textures.putAll(inMemory.surroundings());
        Tile whole = Tile.whole(block.width(), block.height());
        moving.set("perPicture", 1f / block.width(), 1f / block.height());
        var spec = new FloatTarget.Spec(block.width(), block.height(), 1, true, FloatTarget.Format.RGBA8);
        FloatTarget target = movingTarget.of(context, "moving", spec);
        if (ground.isPresent()) {
            ground.get().fillMovingBlock(target, scene, geometry, list, inMemory, block, exposure);
        } else {
            int rgb = scene.background().rgb();
            target.clear(whole, (rgb >> 16) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f, 1);
        }
        target.copyDepthFrom(buffer.attributes());
        context.drawCovered(moving, textures, target, whole);
        return target.readColors(0, whole);
    }

    private void setBlend(ShaderProgram program, Scene scene, LightList lights) {
        blend(scene, diffractionScale, lights).forEach(program::set);
        setSky(program, scene);
        Optional<ReflectionPart> part = component.map(ReflectanceComponent::reflection);
        part.map(SkinSurface::reflection).orElseGet(() -> reflection(scene)).forEach(program::set);
    }

    /** For include/sky.glsl. */
    static void setSky(ShaderProgram program, Scene scene) {
        double turn = scene.hasEnvironment() ? scene.get(SceneSettings.ENVIRONMENT_ROTATION) : 0;
        program.set("skyTurn", (float) Math.cos(turn), (float) Math.sin(turn));
        program.set("isEnvironment", scene.hasEnvironment() ? 1f : 0f);
    }

    /** Returns the uniforms of include/blend.glsl, and the weight of include/sky.glsl. */
    static Map<String, Float> blend(Scene scene, double diffractionScale, LightList lights) {
        return Map.of(
                "diffractionWeight",
                (float) (scene.get(SceneSettings.DIFFRACTION) * diffractionScale),
                "textureWeight",
                scene.get(SceneSettings.TEXTURE_WEIGHT).floatValue(),
                "diffuseWeight",
                scene.get(SceneSettings.DIFFUSE).floatValue(),
                "skyWeight",
                (float) (scene.hasBody() ? lights.skyWeight() : 0),
                "ambientWeight",
                (float) scene.ambient(),
                "fresnelAlpha",
                scene.bodyAlpha() == BodyAlpha.FRESNEL ? 1f : 0f,
                "unlitTexture",
                scene.bodyAlpha() == BodyAlpha.DRAFT ? 1f : 0f);
    }

    /** Returns the uniforms of include/fresnel.glsl for an index that is the same at all wavelengths. */
    static Map<String, Float> reflection(Scene scene) {
        RefractiveIndex index = scene.get(SceneSettings.INDEX).constant().orElseThrow();
        double normal = index.reflectance(CieTable.MINIMUM_WAVELENGTH);
        return Map.of("mirrorWeight", 1f, "grazingWeight", (float) ((1 - normal) / normal));
    }

    private static Map<String, Float> reflection(ReflectionPart part) {
        return Map.of("mirrorWeight", (float) part.constant(), "grazingWeight", (float) part.schlick());
    }

    @Override
    public void close() {
        movingTarget.close();
        movingPrograms.values().forEach(ShaderProgram::close);
        texture.ifPresent(VirtualTexture::close);
        programs.values().forEach(ShaderProgram::close);
        method.close();
    }

    /** A render target that is reused while its size and format stay the same. */
    static final class CachedTarget implements AutoCloseable {
        private FloatTarget target;

        /** Valid until a call with another size or format. Contains the last draw, if any. */
        FloatTarget of(RenderContext context, String label, FloatTarget.Spec spec) {
            if (target == null || !target.spec().equals(spec)) {
                close();
                target = context.createFloatTarget(label, spec);
            }
            return target;
        }

        @Override
        public void close() {
            if (target != null) {
                target.close();
                target = null;
            }
        }
    }
}
