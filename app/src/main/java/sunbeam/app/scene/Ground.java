package sunbeam.app.scene;

import java.util.ArrayList;
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
import sunbeam.app.scene.mesh.SkyVisibility;

/** The plane on which a mesh lies (shaders/ground.frag): it turns with it, and is seen where the mesh is not. */
final class Ground implements AutoCloseable {
    private static final int CHANNELS = 4;

    private final RenderContext context;
    private final double height;
    private final FloatTexture sky;
    private final KeptTarget target;
    private final ShaderProgram program;
    // Compiled when something moves for the first time.
    private Optional<ShaderProgram> moving = Optional.empty();

    private Ground(RenderContext context, double height, FloatTexture sky, ShaderProgram program) {
        this.context = context;
        this.height = height;
        this.sky = sky;
        this.program = program;
        this.target = new KeptTarget(context, "ground", FloatTargetSpec.Format.RGBA32F);
    }

    /**
     * Of a mesh.
     *
     * @param height of its lowest point
     * @param seen how much of the sky its ground sees
     */
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
     * Puts the ground where a part of a block shows no mesh.
     *
     * @param pixels X, Y, Z and coverage of each stride-th pixel of each stride-th row, top row first
     * @param block its width and height
     */
    void under(float[] pixels, Scene scene, SkinGeometry geometry, Tile block, Tile part, int stride) {
        FloatTarget drawn = target.of(block.width(), block.height());
        set(program, scene, geometry, geometry.viewRays(block), Shadows.MANY_TAPS);
        context.drawFullScreen(program, textures(geometry), drawn, part);
        float[] ground = drawn.read(0, part);
        int columns = SceneSession.few(part.width(), stride);
        for (int i = 0; i < pixels.length; i += CHANNELS) {
            if (pixels[i + 3] == 0) {
                int x = stride * (i / CHANNELS % columns);
                int y = stride * (i / CHANNELS / columns);
                System.arraycopy(ground, CHANNELS * (y * part.width() + x), pixels, i, CHANNELS - 1);
            }
        }
    }

    /** Draws it as a screen shows it, to a whole block, which the mesh then covers. */
    void move(
            FloatTarget block,
            Scene scene,
            SkinGeometry geometry,
            ViewRays rays,
            GeometryBuffer buffer,
            double exposure) {
        if (moving.isEmpty()) {
            moving = Optional.of(program(context, 1));
        }
        ShaderProgram screen = moving.get();
        set(screen, scene, geometry, rays, Shadows.FEW_TAPS);
        screen.set("exposure", (float) exposure);
        screen.set("toneStart", (float) scene.display(exposure).tone().start());
        double[] behind = scene.background().light();
        screen.set("behind", new Vector3f((float) behind[0], (float) behind[1], (float) behind[2]));
        List<Binding> textures = new ArrayList<>(textures(geometry));
        textures.addAll(buffer.bindings());
        context.drawFullScreen(
                screen,
                textures,
                block,
                Tile.whole(block.spec().width(), block.spec().height()));
    }

    private List<Binding> textures(SkinGeometry geometry) {
        return List.of(new Binding("groundSky", sky), geometry.shadows().binding());
    }

    private void set(ShaderProgram to, Scene scene, SkinGeometry geometry, ViewRays rays, int taps) {
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
        geometry.shadows().applyTo(to, scene.around().shadows() ? taps : 0);
    }

    @Override
    public void close() {
        target.close();
        moving.ifPresent(ShaderProgram::close);
        program.close();
        sky.close();
    }
}
