package sunbeam.app.render;

import java.util.Map;
import java.util.Optional;
import jrtr.Tile;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.RenderContext.Faces;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.VertexBuffer;
import jrtr.scene.Light;
import jrtr.scene.PlacedMesh;
import jrtr.scene.View;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.render.UploadedScene.SkinTextures;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.optics.Direction;

/**
 * Point of the skin under a pixel and its tangent frame, with relief and the patch's rotation. Unit vectors.
 *
 * @param position meters, world space
 * @param region index of the point's patch in the scene
 * @param center center of the mesh, about which a scene's orientation turns it, meters, world space
 * @param tangent world space, as bitangent and normal
 * @param wi towards the light, tangent frame; z is negative if the light is behind the skin
 * @param wr towards the viewer, tangent frame; z may be negative where relief turns the normal away
 */
public record Pick(
        Vector3fc position,
        int region,
        Vector3fc center,
        Vector3fc tangent,
        Vector3fc bitangent,
        Vector3fc normal,
        Direction wi,
        Direction wr) {

    /** Draws the pixel (shaders/pick.frag). */
    static final class Picking implements AutoCloseable {
        private static final int IMAGES = 6;

        private final RenderContext context;
        private final ShaderProgram program;
        private final FloatTarget target;

        Picking(RenderContext context) {
            this.context = context;
            this.program = context.createMeshProgram(Shaders.library().load("pick.frag"));
            this.target = Resource.orClose(
                    () -> context.createFloatTarget("pick", new FloatTarget.Spec(1, 1, IMAGES, true)), program::close);
        }

        Optional<Pick> pick(Scene scene, VertexBuffer mesh, SkinTextures body, View.Area pixel) {
            double rotation = scene.get(SceneSettings.ROTATE_PATCH);
            PlacedMesh placed = body.placed(mesh, scene.orientation(), program, rotation, Faces.BOTH, Map.of());
            Light.apply(Framing.lights(scene), program);
            placed.draw(context, Framing.view(scene.view(), mesh.bounds()), pixel, target, Tile.whole(1, 1));
            float[][] values = new float[IMAGES][];
            for (int i = 0; i < IMAGES; i++) {
                values[i] = target.read(i);
            }
            if (values[0][3] == 0) {
                return Optional.empty();
            }
            return Optional.of(new Pick(
                    vector(values[0]),
                    scene.patches().region((int) values[0][3] - 1),
                    mesh.bounds().center(),
                    vector(values[1]),
                    vector(values[2]),
                    vector(values[3]),
                    direction(values[4]),
                    direction(values[5])));
        }

        private static Vector3f vector(float[] rgba) {
            return new Vector3f(rgba[0], rgba[1], rgba[2]);
        }

        private static Direction direction(float[] rgba) {
            return new Direction(rgba[0], rgba[1], rgba[2]);
        }

        @Override
        public void close() {
            target.close();
            program.close();
        }
    }
}
