package sunbeam.app.render;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.render.SkinSurface.CachedTarget;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.SkyVisibility;

/** The plane on which the model lies (shaders/ground.frag). It turns with the model and hides the background. */
final class Ground implements AutoCloseable {
    private static final int CHANNELS = 4;
    // In pixels, of the squares of a moving picture with one sample.
    private static final int MOVING_PIXELS = 2;

    // Distinguishes the ground from the mesh, whose opacity is 1.
    private static final float MOST_OPAQUE = Math.nextDown(1f);

    private final RenderContext context;
    private final BoundingSphere bounds;
    private final double height;
    private final FloatTexture sky;
    private final CachedTarget target = new CachedTarget();
    private final CachedTarget movingTarget = new CachedTarget();
    private final ShaderProgram program;
    private Optional<ShaderProgram> moving = Optional.empty();

    /**
     * @param bounds sphere around the model, model space
     * @param height height of the model's lowest point in meters
     * @param seen the ground's visible share of the sky
     */
    Ground(RenderContext context, BoundingSphere bounds, double height, SkyVisibility seen) {
        int side = SkyVisibility.GROUND_SIDE;
        this.context = context;
        this.bounds = bounds;
        this.height = height;
        this.sky = context.createFloatTexture(
                "sky above the ground",
                FloatTexture.Spec.flat(side, side, FloatTexture.Format.R32F).with(FloatTexture.Filter.LINEAR));
        this.program = Resource.orClose(
                () -> {
                    sky.upload(seen.ofGround());
                    return program(context, "0");
                },
                sky::close);
    }

    private static ShaderProgram program(RenderContext context, String screen) {
        return context.createFullScreenProgram(Shaders.library().load("ground.frag", Map.of("SCREEN", screen)));
    }

    /**
     * Draws the ground into those samples of a part of a block that show no mesh, equal ones in a pixel, since it is smooth.
     *
     * @param pixels {@link ScenePicture#rgba} of the piece's drawn samples, top row first; changed
     */
    void fillUncovered(
            float[] pixels,
            DrawRequest request,
            SkinGeometry geometry,
            LightList lights,
            LightTexture inMemory,
            SceneBlocks.Piece piece) {
        Tile block = piece.block();
        Tile part = piece.inBlock();
        int samples = request.samples();
        FloatTarget drawn = target.of(context, "ground", spec(block, samples, FloatTarget.Format.RGBA32F));
        set(program, request.scene(), geometry, lights, inMemory, block);
        program.set("viewPixels", (float) samples);
        int left = part.x() / samples;
        int right = (part.x() + part.width() - 1) / samples;
        int highest = block.height() - 1 - part.y();
        int top = highest / samples;
        int bottom = (highest - part.height() + 1) / samples;
        Tile seen = new Tile(left, drawn.spec().height() - 1 - top, right - left + 1, top - bottom + 1);
        context.drawFullScreen(program, textures(inMemory), drawn, seen);
        float[] ground = drawn.read(0, seen);
        int i = 0;
        for (int row = 0; row < request.rows(part); row++) {
            int y = request.down() * row;
            int from = CHANNELS * (top - (highest - y) / samples) * seen.width();
            for (int column = 0; column < request.columns(part); column++, i += CHANNELS) {
                int x = request.x(column, row);
                if (pixels[i + 3] == 0 && request.draws(piece.x() + x, piece.y() + y)) {
                    int at = from + CHANNELS * ((part.x() + x) / samples - left);
                    for (int c = 0; c < 3; c++) {
                        pixels[i + c] = ground[at + c];
                    }
                    pixels[i + 3] = Math.min(ground[at + 3], MOST_OPAQUE);
                }
            }
        }
    }

    /** Draws the ground in sRGB into a whole block of a moving picture; the mesh is drawn over it. */
    void fillMovingBlock(
            FloatTarget picture,
            Scene scene,
            SkinGeometry geometry,
            LightList list,
            LightTexture lights,
            Tile block,
            double exposure) {
        if (moving.isEmpty()) {
            moving = Optional.of(program(context, "1"));
        }
        ShaderProgram screen = moving.get();
        set(screen, scene, geometry, list, lights, block);
        screen.set("exposure", (float) exposure);
        screen.set("toneStart", (float) scene.display(exposure).tone().start());
        double[] behind = scene.background().light();
        screen.set("behind", new Vector3f((float) behind[0], (float) behind[1], (float) behind[2]));
        screen.set("viewPixels", (float) MOVING_PIXELS);
        FloatTarget drawn =
                movingTarget.of(context, "moving ground", spec(block, MOVING_PIXELS, FloatTarget.Format.RGBA8));
        Tile whole = Tile.whole(drawn.spec().width(), drawn.spec().height());
        context.drawFullScreen(screen, textures(lights), drawn, whole);
        picture.fill(drawn);
    }

    /** @param pixels side of a square of the block that has one color */
    private static FloatTarget.Spec spec(Tile block, int pixels, FloatTarget.Format format) {
        int width = SceneBlocks.ceilDiv(block.width(), pixels);
        return new FloatTarget.Spec(width, SceneBlocks.ceilDiv(block.height(), pixels), 1, false, format);
    }

    private Map<String, Texture> textures(LightTexture lights) {
        Map<String, Texture> textures = new HashMap<>(lights.textures());
        textures.putAll(lights.surroundings());
        textures.put("groundSky", sky);
        return textures;
    }

    private void set(
            ShaderProgram to, Scene scene, SkinGeometry geometry, LightList lights, LightTexture inMemory, Tile block) {
        Map<String, Vector3f> placed = place(scene, bounds, height);
        geometry.applyRaysTo(to, block);
        to.set("eye", scene.view().camera().centerOfProjection());
        placed.forEach(to::set);
        to.set("showsGround", scene.ground().isPresent() ? 1f : 0f);
        to.set("showsEnvironment", scene.showsEnvironment() ? 1f : 0f);
        to.set("skyWeight", (float) lights.skyWeight());
        SkinSurface.setSky(to, scene);
        to.set("horizonColor", inMemory.horizon().mul((float) lights.skyWeight(), new Vector3f()));
        to.set("ambientWeight", (float) scene.ambient());
        to.set("diffuseWeight", scene.get(SceneSettings.DIFFUSE).floatValue());
        Vector3f ambient = new Vector3f();
        lights.all().forEach(light -> ambient.add(light.radiance()));
        to.set("groundAmbient", ambient);
        float[] direct = new float[3 * LightList.MOST_GROUPS];
        for (int i = 0; i < lights.groups().size(); i++) {
            Vector3f lit = lights.groups().get(i).onPlane(placed.get("groundNormal"));
            for (int c = 0; c < 3; c++) {
                direct[3 * i + c] = lit.get(c);
            }
        }
        to.set("groundLights", direct);
        to.set("lightGroups", lights.groups().size());
    }

    /** Returns the uniforms of the ground's place in world space, and its color. */
    static Map<String, Vector3f> place(Scene scene, BoundingSphere bounds, double height) {
        Matrix4fc toWorld = SceneGraph.modelToWorld(scene.orientation(), bounds.center());
        float reach = (float) SkyVisibility.GROUND_REACH * bounds.radius();
        Vector3fc center = bounds.center();
        double[] color = scene.ground().orElse(scene.background()).light();
        return Map.of(
                "groundMiddle", toWorld.transformPosition(new Vector3f(center.x(), center.y(), (float) height)),
                "groundAcross", toWorld.transformDirection(new Vector3f(reach, 0, 0)),
                "groundAlong", toWorld.transformDirection(new Vector3f(0, reach, 0)),
                "groundNormal", toWorld.transformDirection(new Vector3f(0, 0, 1)),
                "groundColor", new Vector3f((float) color[0], (float) color[1], (float) color[2]));
    }

    @Override
    public void close() {
        target.close();
        movingTarget.close();
        moving.ifPresent(ShaderProgram::close);
        program.close();
        sky.close();
    }
}
