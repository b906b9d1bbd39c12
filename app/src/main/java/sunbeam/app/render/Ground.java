package sunbeam.app.render;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import jrtr.BoundingSphere;
import jrtr.Filter;
import jrtr.FloatFormat;
import jrtr.FloatTargetSpec;
import jrtr.FloatTextureSpec;
import jrtr.Tile;
import jrtr.gl.Binding;
import jrtr.gl.FloatTarget;
import jrtr.gl.FloatTexture;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.scene.LightUniforms;
import jrtr.scene.ViewRays;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.gpu.KeptTarget;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.SkyVisibility;

/** The plane on which a mesh lies (shaders/ground.frag): it turns with it, and hides the background where the mesh is not. */
final class Ground implements AutoCloseable {
    private static final int CHANNELS = 4;
    // Along a side of what one sample stands for while something moves.
    private static final int MOVING_PIXELS = 2;

    // Tells the ground from the mesh, whose opacity is 1.
    private static final float MOST_OPAQUE = Math.nextDown(1f);

    private final RenderContext context;
    private final double height;
    private final FloatTexture sky;
    private final KeptTarget target;
    private final KeptTarget movingTarget;
    private final ShaderProgram program;
    // Compiled when something moves for the first time.
    private Optional<ShaderProgram> moving = Optional.empty();

    private Ground(RenderContext context, double height, FloatTexture sky, ShaderProgram program) {
        this.context = context;
        this.height = height;
        this.sky = sky;
        this.program = program;
        this.target = new KeptTarget(context, "ground", FloatTargetSpec.Format.RGBA32F, false);
        this.movingTarget = new KeptTarget(context, "moving ground", FloatTargetSpec.Format.RGBA8, false);
    }

    /** Of a mesh whose lowest point has this height, and whose ground sees so much of the sky. */
    static Ground create(RenderContext context, double height, SkyVisibility seen) {
        int side = SkyVisibility.GROUND_SIDE;
        FloatTexture sky = context.createFloatTexture(
                "sky above the ground",
                FloatTextureSpec.flat(side, side, FloatFormat.R32F).with(Filter.LINEAR));
        try {
            sky.upload(seen.ofGround());
            return new Ground(context, height, sky, program(context, 0));
        } catch (RuntimeException failure) {
            sky.close();
            throw failure;
        }
    }

    private static ShaderProgram program(RenderContext context, int screen) {
        return context.createFullScreenProgram(
                Shaders.library().load("ground.frag", Map.of("SCREEN", Integer.toString(screen))));
    }

    /**
     * Puts the ground where a part of a block shows no mesh. All samples of a pixel have the same, since it is smooth.
     *
     * @param pixels {@link ScenePicture#rgba} of each stride-th pixel of each stride-th row, top row first
     * @param block its width and height
     * @param samples of the mesh along a side of what will be one pixel
     */
    void under(float[] pixels, Scene scene, SkinGeometry geometry, Tile block, Tile part, int stride, int samples) {
        FloatTarget drawn =
                target.of(SceneSession.few(block.width(), samples), SceneSession.few(block.height(), samples));
        set(program, scene, geometry, geometry.viewRays(block));
        program.set("viewPixels", (float) samples);
        int left = part.x() / samples;
        int right = (part.x() + part.width() - 1) / samples;
        // Counted from below, as shaders do.
        int highest = block.height() - 1 - part.y();
        int top = highest / samples;
        int bottom = (highest - part.height() + 1) / samples;
        Tile seen = new Tile(left, drawn.spec().height() - 1 - top, right - left + 1, top - bottom + 1);
        context.drawFullScreen(program, textures(geometry), drawn, seen);
        float[] ground = drawn.read(0, seen);
        int columns = SceneSession.few(part.width(), stride);
        for (int i = 0; i < pixels.length; i += CHANNELS) {
            if (pixels[i + 3] == 0) {
                int x = (part.x() + stride * (i / CHANNELS % columns)) / samples - left;
                int y = top - (highest - stride * (i / CHANNELS / columns)) / samples;
                int from = CHANNELS * (y * seen.width() + x);
                System.arraycopy(ground, from, pixels, i, CHANNELS);
                pixels[i + 3] = Math.min(pixels[i + 3], MOST_OPAQUE);
            }
        }
    }

    /** Draws it as a screen shows it, to a whole block, which the mesh then covers; a sample for four pixels, since it is smooth. */
    void move(FloatTarget block, Scene scene, SkinGeometry geometry, ViewRays rays, double exposure) {
        if (moving.isEmpty()) {
            moving = Optional.of(program(context, 1));
        }
        ShaderProgram screen = moving.get();
        set(screen, scene, geometry, rays);
        screen.set("exposure", (float) exposure);
        screen.set("toneStart", (float) scene.display(exposure).tone().start());
        double[] behind = scene.get(SceneSettings.BACKGROUND).light();
        screen.set("behind", new Vector3f((float) behind[0], (float) behind[1], (float) behind[2]));
        screen.set("viewPixels", (float) MOVING_PIXELS);
        FloatTarget drawn = movingTarget.of(
                SceneSession.few(block.spec().width(), MOVING_PIXELS),
                SceneSession.few(block.spec().height(), MOVING_PIXELS));
        Tile whole = Tile.whole(drawn.spec().width(), drawn.spec().height());
        context.drawFullScreen(screen, textures(geometry), drawn, whole);
        block.fill(drawn);
    }

    private List<Binding> textures(SkinGeometry geometry) {
        return List.of(new Binding("groundSky", sky), geometry.shadows().binding());
    }

    private void set(ShaderProgram to, Scene scene, SkinGeometry geometry, ViewRays rays) {
        BoundingSphere bounds = geometry.mesh().bounds();
        Matrix4f toWorld = SceneGraphs.toWorld(scene.orientation(), bounds);
        float reach = (float) SkyVisibility.GROUND_REACH * bounds.radius();
        Vector3fc center = bounds.center();
        rays.applyTo(to);
        to.set("eye", scene.view().camera().centerOfProjection());
        to.set("groundMiddle", toWorld.transformPosition(new Vector3f(center.x(), center.y(), (float) height)));
        to.set("groundAcross", toWorld.transformDirection(new Vector3f(reach, 0, 0)));
        to.set("groundAlong", toWorld.transformDirection(new Vector3f(0, reach, 0)));
        to.set("groundNormal", toWorld.transformDirection(new Vector3f(0, 0, 1)));
        double[] color = scene.around().ground().orElseThrow().light();
        to.set("groundColor", new Vector3f((float) color[0], (float) color[1], (float) color[2]));
        to.set("ambientWeight", (float) scene.blend().ambient());
        to.set("diffuseWeight", (float) scene.blend().diffuse());
        LightUniforms.of(SceneGraphs.lights(scene)).applyTo(to);
        geometry.shadows().applyTo(to, scene.around().shadows());
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
