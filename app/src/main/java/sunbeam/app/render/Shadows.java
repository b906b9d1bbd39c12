package sunbeam.app.render;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import jrtr.scene.PlacedMesh;
import jrtr.scene.View;
import jrtr.scene.View.Camera;
import org.joml.Matrix4f;
import org.joml.Quaternionfc;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.gpu.Shaders;

/** Shadow maps of a mesh under its first light (shaders/include/shadow.glsl). Belongs to its context's thread. */
final class Shadows implements AutoCloseable {
    // In texels, for still pictures and for moving ones, which may draw the map for each frame.
    private static final int SIDE = 1024;
    private static final int MOVING_SIDE = 320;
    // In radii of the mesh; the light's rays are parallel within a degree.
    private static final float DISTANCE = 60;
    private static final float MARGIN = 1.02f;
    // In texels along the normal, so that a surface does not shade itself.
    private static final float LIFT = 2;

    private final RenderContext context;
    private final Matrix4f worldToShadow = new Matrix4f();
    private View view;
    private float lift;
    private final FloatTarget noShadows;
    private final Map<Integer, FloatTarget> maps = new HashMap<>();
    private Optional<ShaderProgram> program = Optional.empty();
    // Keys are sides of the map.
    private final Map<Integer, Key> shown = new HashMap<>();
    private int side;

    private static FloatTarget.Spec spec(int side) {
        return new FloatTarget.Spec(side, side, 1, true, FloatTarget.Format.RGBA8);
    }

    private record Key(VertexBuffer mesh, Quaternionfc orientation, Vector3fc towards) {}

    Shadows(RenderContext context) {
        this.context = context;
        this.noShadows = context.createFloatTarget("no shadows", spec(1));
    }

    /** Draws the map unless it is up to date; moving pictures have a coarser one. */
    void draw(VertexBuffer mesh, boolean closed, Quaternionfc orientation, Vector3fc towards, boolean moves) {
        side = moves ? MOVING_SIDE : SIDE;
        Key key = new Key(mesh, orientation, towards);
        placeLight(mesh, towards);
        if (key.equals(shown.get(side))) {
            return;
        }
        FloatTarget map = maps.computeIfAbsent(side, texels -> context.createFloatTarget("shadows", spec(texels)));
        if (program.isEmpty()) {
            program = Optional.of(context.createMeshProgram(Shaders.library().load("shadow.frag")));
        }
        Faces faces = closed ? Faces.FRONT : Faces.BOTH;
        Matrix4f toWorld = Framing.toWorld(orientation, mesh.bounds());
        new PlacedMesh(mesh, toWorld, program.get(), Map.of(), faces)
                .draw(context, view, View.Area.whole(side, side), map, Tile.whole(side, side));
        shown.put(side, key);
    }

    private void placeLight(VertexBuffer mesh, Vector3fc towards) {
        BoundingSphere bounds = mesh.bounds();
        float distance = DISTANCE * bounds.radius();
        float reach = MARGIN * bounds.radius();
        Vector3f eye = new Vector3f(bounds.center()).fma(distance, towards);
        Vector3f up = Math.abs(towards.z()) < 0.9f ? new Vector3f(0, 0, 1) : new Vector3f(1, 0, 0);
        float angle = (float) (2 * Math.atan(reach / (distance - reach)));
        view = new View(new Camera(eye, bounds.center(), up), angle, 0, distance - reach, distance + reach);
        worldToShadow.set(view.worldToClip(View.Area.whole(side, side)));
        lift = LIFT * 2 * reach / side;
    }

    Map<String, Texture> textures() {
        return Map.of("shadowMap", maps.getOrDefault(side, noShadows).depth());
    }

    void applyTo(ShaderProgram lit, boolean on) {
        lit.set("worldToShadow", worldToShadow);
        lit.set("shadowed", on ? 1 : 0);
        lit.set("shadowLift", lift);
    }

    @Override
    public void close() {
        noShadows.close();
        maps.values().forEach(FloatTarget::close);
        program.ifPresent(ShaderProgram::close);
    }
}
