package jrtr.scene;

import java.util.List;
import java.util.Map;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/** Node of a scene graph. A node in several groups is drawn once for each. */
public sealed interface Node {
    /** Nodes with the affine matrix M (copied) from their coordinates v to the parent's, {@code M * v}. */
    record Group(Matrix4fc toParent, List<Node> children) implements Node {
        public Group {
            toParent = new Matrix4f(toParent);
            children = List.copyOf(children);
            boolean affine = toParent.m03() == 0 && toParent.m13() == 0 && toParent.m23() == 0 && toParent.m33() == 1;
            if (!affine || !toParent.isFinite() || toParent.determinant3x3() == 0) {
                throw new IllegalArgumentException(
                        "a group's transformation must be affine, finite and invertible, not " + toParent);
            }
        }

        public Group(Matrix4fc toParent, Node... children) {
            this(toParent, List.of(children));
        }

        public Group(Node... children) {
            this(new Matrix4f(), children);
        }
    }

    /**
     * Triangles with their material. Owns neither vertices nor program nor textures, which several shapes may share. The engine's own
     * uniforms (mesh.vert.glsl, jrtr/surface.glsl) are set by {@link SceneGraph#draw}; the shape sets all others.
     */
    record Shape(
            VertexBuffer vertices,
            ShaderProgram program,
            Map<String, Texture> textures,
            Map<String, Float> uniforms,
            RenderContext.Faces faces)
            implements Node {
        public Shape {
            textures = Map.copyOf(textures);
            uniforms = Map.copyOf(uniforms);
        }

        /** Uniforms of jrtr/tangent_frame.glsl: rotation about the normal, counter-clockwise seen from outside. */
        public static Map<String, Float> tangentsTurned(double radians) {
            return Map.of("tangentCosine", (float) Math.cos(radians), "tangentSine", (float) Math.sin(radians));
        }
    }

    /**
     * Parallel rays, as from the sun.
     *
     * @param towards direction from the scene to the light; normalized
     * @param radiance linear color in the unit of the application's shaders; copied
     */
    record Light(Vector3fc towards, Vector3fc radiance) implements Node {
        /** Maximum number of lights in a scene, MAX_LIGHTS of jrtr/lights.glsl. */
        public static final int MOST = 8;

        public Light {
            float length = towards.length();
            if (!(length > 0) || Float.isInfinite(length)) {
                throw new IllegalArgumentException("light's direction (" + towards.x() + ", " + towards.y() + ", "
                        + towards.z() + ") must have a finite length above 0");
            }
            towards = towards.div(length, new Vector3f());
            radiance = new Vector3f(radiance);
        }

        public Light transformed(Matrix4fc transformation) {
            return new Light(transformation.transformDirection(towards, new Vector3f()), radiance);
        }

        /** Sets the uniforms of jrtr/lights.glsl, as far as the program uses them. */
        public static void apply(List<Light> lights, ShaderProgram program) {
            if (lights.size() > MOST) {
                throw new IllegalArgumentException(
                        "the scene has " + lights.size() + " lights, but shaders take at most " + MOST);
            }
            float[] directions = new float[3 * MOST];
            float[] radiances = new float[3 * MOST];
            for (int i = 0; i < lights.size(); i++) {
                for (int c = 0; c < 3; c++) {
                    directions[3 * i + c] = lights.get(i).towards.get(c);
                    radiances[3 * i + c] = lights.get(i).radiance.get(c);
                }
            }
            if (program.isActive("lightCount")) {
                program.set("lightCount", lights.size());
            }
            if (program.isActive("lightDirections")) {
                program.set("lightDirections", directions);
            }
            if (program.isActive("lightRadiances")) {
                program.set("lightRadiances", radiances);
            }
        }
    }
}
