package jrtr.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.gl.Texture;
import jrtr.gl.VertexBuffer;
import org.joml.FrustumIntersection;
import org.joml.Matrix3f;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.joml.Vector3f;
import org.joml.Vector3fc;

/** Scene graph, by its root, with its view. */
public record SceneGraph(Node root, View view) {
    /** Factor on bounding radii, because the frustum's planes from float matrices err by a few 1e-6. */
    private static final float CULLING_RADIUS_FACTOR = 1.001f;

    /** @param modelToWorld affine, copied */
    record ShapeInstance(Node.Shape shape, Matrix4fc modelToWorld) {
        ShapeInstance {
            modelToWorld = new Matrix4f(modelToWorld);
        }

        BoundingSphere bounds() {
            return shape.vertices().bounds().transformed(modelToWorld);
        }
    }

    List<ShapeInstance> shapes() {
        List<ShapeInstance> shapes = new ArrayList<>();
        collect(root, new Matrix4f(), shapes, new ArrayList<>());
        return shapes;
    }

    List<Node.Light> lights() {
        List<Node.Light> lights = new ArrayList<>();
        collect(root, new Matrix4f(), new ArrayList<>(), lights);
        return lights;
    }

    private static void collect(Node node, Matrix4fc toWorld, List<ShapeInstance> shapes, List<Node.Light> lights) {
        if (node instanceof Node.Group group) {
            Matrix4f childToWorld = toWorld.mul(group.toParent(), new Matrix4f());
            group.children().forEach(child -> collect(child, childToWorld, shapes, lights));
        } else if (node instanceof Node.Shape shape) {
            shapes.add(new ShapeInstance(shape, toWorld));
        } else if (node instanceof Node.Light light) {
            lights.add(light.transformed(toWorld));
        }
    }

    /**
     * Clears the tile to zeros and draws the scene there; no pixel outside is touched. Tiles that cover the target give the same picture as
     * one draw, bit for bit. Pixels without a shape stay zero.
     *
     * @param area part of the picture that the target, which has depth, shows; it has the target's size in pixels
     * @throws IllegalArgumentException if the scene has more than {@link Node.Light#MOST} lights
     */
    public void draw(RenderContext context, View.Area area, FloatTarget target, Tile tile) {
        if (area.part().width() != target.spec().width()
                || area.part().height() != target.spec().height()) {
            throw new IllegalArgumentException("target '" + target.label() + "' of "
                    + target.spec().width() + " x " + target.spec().height() + " cannot show " + area.part());
        }
        List<Node.Light> lights = lights();
        target.clear(tile, 0, 0, 0, 0);
        Matrix4f worldToClip = view.worldToClip(area);
        for (ShapeInstance instance : visible(area.within(tile))) {
            Node.Shape shape = instance.shape();
            ShaderProgram program = shape.program();
            Matrix4fc modelToWorld = instance.modelToWorld();
            program.set("modelToWorld", modelToWorld);
            // The inverse transpose keeps normals orthogonal to the surface under any scaling.
            program.set("normalToWorld", modelToWorld.normal(new Matrix3f()));
            program.set("mirror", modelToWorld.determinant3x3() < 0 ? -1f : 1f);
            program.set("worldToClip", worldToClip);
            if (program.isActive("eyePosition")) {
                program.set("eyePosition", view.camera().centerOfProjection());
            }
            Node.Light.apply(lights, program);
            shape.uniforms().forEach((name, value) -> program.set(name, value.floatValue()));
            context.draw(program, shape.textures(), shape.vertices(), shape.faces(), target, tile);
        }
    }

    /** Returns the shapes that intersect the frustum, nearest first, so that the depth test rejects most of the hidden fragments. */
    private List<ShapeInstance> visible(View.Area area) {
        FrustumIntersection planes = new FrustumIntersection(view.worldToClip(area));
        Matrix4f worldToCamera = view.camera().worldToCamera();
        return shapes().stream()
                .filter(item -> planes.testSphere(
                        item.bounds().center(),
                        CULLING_RADIUS_FACTOR * item.bounds().radius()))
                .sorted(Comparator.comparingDouble(item -> nearestDepth(worldToCamera, item.bounds())))
                .toList();
    }

    private static float nearestDepth(Matrix4f worldToCamera, BoundingSphere bounds) {
        Vector3f center = worldToCamera.transformPosition(bounds.center(), new Vector3f());
        return -center.z() - bounds.radius();
    }

    /** Node of a scene graph. A node in several groups is drawn once for each. */
    public sealed interface Node {
        /** Nodes with the affine matrix M (copied) from their coordinates v to the parent's, {@code M * v}. */
        record Group(Matrix4fc toParent, List<Node> children) implements Node {
            public Group {
                toParent = new Matrix4f(toParent);
                children = List.copyOf(children);
                boolean affine =
                        toParent.m03() == 0 && toParent.m13() == 0 && toParent.m23() == 0 && toParent.m33() == 1;
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
}
