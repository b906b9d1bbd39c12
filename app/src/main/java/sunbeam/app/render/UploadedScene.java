package sunbeam.app.render;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import jrtr.Tile;
import jrtr.VertexData.BoundingSphere;
import jrtr.gl.FloatTarget;
import jrtr.gl.ImageTexture;
import jrtr.gl.ImageTexture.Encoding;
import jrtr.gl.RenderContext;
import jrtr.gl.Resource;
import jrtr.gl.ShaderProgram;
import jrtr.gl.VertexBuffer;
import jrtr.scene.GraphSceneManager;
import jrtr.scene.Material;
import jrtr.scene.RenderPass;
import jrtr.scene.Shape;
import jrtr.scene.View;
import org.joml.Vector3f;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.render.GeometryBuffer.SkinGeometry;
import sunbeam.app.render.SceneLoader.SceneShape;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.Scene.Viewpoint;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.mesh.SnakeBody;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.Body.Scales;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.ScaleRelief;
import sunbeam.precompute.optics.Direction;

/** A scene in graphics memory: mesh, textures, and the method with its tables. */
final class UploadedScene implements AutoCloseable {
    private final RenderContext context;
    private final LightTexture lights;
    private SceneData data;
    private UploadedMesh mesh;
    private SkinTextures body;
    private SkinSurface skin;

    /** Has no scene until {@link #upload} or {@link #update}. */
    UploadedScene(RenderContext context) {
        this.context = context;
        this.lights = new LightTexture(context);
    }

    SceneData data() {
        return data;
    }

    /** Returns the ground if the blend shows the body's own color, not diffraction alone. */
    Optional<Ground> ground(Scene scene) {
        return scene.ground().isPresent() && scene.hasBody() ? mesh.ground() : Optional.empty();
    }

    SkinSurface skin() {
        return skin;
    }

    /** Geometry of a scene with the uploaded meshes. */
    SkinGeometry geometry(Scene scene, int width, int height) {
        GraphSceneManager graph = graph(scene);
        BoundingSphere bounds = graph.bounds().orElseThrow();
        return new SkinGeometry(graph.items(), bounds, viewpoint(scene, graph), width, height);
    }

    /** Uploads lights and draws their shadow maps; moving pictures have coarser ones. */
    LightTexture lights(SkinGeometry geometry, LightList list, boolean moves) {
        lights.update(list, new LightTexture.Casters(geometry.items(), geometry.bounds()), moves);
        return lights;
    }

    private GraphSceneManager graph(Scene scene) {
        Shape shape = new Shape(
                mesh.buffer(), mesh.mesh().closed(), body.material().turned(scene.get(SceneSettings.ROTATE_PATCH)));
        return SceneGraph.of(scene, mesh.buffer().bounds().center(), List.of(shape));
    }

    private static Viewpoint viewpoint(Scene scene, GraphSceneManager graph) {
        return new Viewpoint(graph.camera().orElseThrow(), scene.view().verticalFieldOfView());
    }

    /** Uploads a scene without its diffraction, for moving pictures of the body. */
    void upload(Scene scene, SceneShape shape) {
        replace(scene, shape, shape.bodies().get(0), () -> new SkinSurface(context, Optional.empty()));
    }

    void update(SceneData next) {
        boolean sharesMethod = data != null && next.sharesMethod(data);
        Supplier<SkinSurface> surface = () -> sharesMethod ? skin : new SkinSurface(context, Optional.of(next));
        replace(next.scene(), next.shape(), next.body(), surface);
        data = next;
    }

    /** Uploads what differs; a failure leaves the old scene. */
    @SuppressWarnings("ReferenceEquality") // comparing triangles and texels would take as long as uploading them
    private void replace(Scene scene, SceneShape shape, Body wanted, Supplier<SkinSurface> surface) {
        boolean keepsMesh =
                mesh != null && mesh.mesh() == shape.mesh() && (mesh.ground().isPresent() || !scene.occludesSky());
        UploadedMesh nextMesh = keepsMesh ? mesh : UploadedMesh.upload(context, scene, shape);
        Runnable closeMesh = () -> closeUnlessSame(nextMesh, mesh, UploadedMesh::close);
        SkinTextures nextBody = Resource.orClose(
                () -> body != null && body.body == wanted ? body : new SkinTextures(context, wanted), closeMesh);
        SkinSurface nextSkin =
                Resource.orClose(surface, closeMesh, () -> closeUnlessSame(nextBody, body, SkinTextures::close));
        closeUnlessSame(mesh, nextMesh, UploadedMesh::close);
        closeUnlessSame(body, nextBody, SkinTextures::close);
        closeUnlessSame(skin, nextSkin, SkinSurface::close);
        mesh = nextMesh;
        body = nextBody;
        skin = nextSkin;
    }

    private static <T> void closeUnlessSame(T part, T other, Consumer<T> closing) {
        if (part != null && part != other) {
            closing.accept(part);
        }
    }

    @Override
    public void close() {
        closeUnlessSame(skin, null, SkinSurface::close);
        closeUnlessSame(body, null, SkinTextures::close);
        closeUnlessSame(mesh, null, UploadedMesh::close);
        lights.close();
    }

    /** @param ground ground below the mesh; present if the mesh has the visible share of the sky per vertex */
    private record UploadedMesh(Mesh mesh, VertexBuffer buffer, Optional<Ground> ground) implements AutoCloseable {

        /** May wait for the visible share of the sky. */
        static UploadedMesh upload(RenderContext context, Scene scene, SceneShape shape) {
            Mesh mesh = shape.mesh();
            if (!scene.occludesSky()) {
                return new UploadedMesh(
                        mesh, context.createVertexBuffer("mesh", mesh.toVertexData()), Optional.empty());
            }
            SkyVisibility seen = shape.sky().get();
            VertexBuffer buffer = context.createVertexBuffer("mesh", mesh.toVertexData(seen.ofVertices()));
            Ground ground =
                    Resource.orClose(() -> new Ground(context, SkyVisibility.ground(mesh), seen), buffer::close);
            return new UploadedMesh(mesh, buffer, Optional.of(ground));
        }

        @Override
        public void close() {
            ground.ifPresent(Ground::close);
            buffer.close();
        }
    }

    /** Textures of a mesh's surface in graphics memory (shaders/include/relief.glsl). */
    static final class SkinTextures implements AutoCloseable {
        private final Body body;
        // Keys are the shaders' samplers.
        private final Map<String, ImageTexture> uploaded = new HashMap<>();

        SkinTextures(RenderContext context, Body body) {
            this.body = body;
            try {
                upload(context, "bodyTexture", "body", body.colors(), Encoding.SRGB);
                upload(context, "skinRelief", "relief", body.relief(), Encoding.LINEAR);
                upload(context, "patchDirections", "directions", body.directions(), Encoding.LINEAR);
                upload(context, "patchMap", "patches", body.patches(), Encoding.LINEAR);
            } catch (RuntimeException | Error failure) {
                close();
                throw failure;
            }
        }

        private void upload(
                RenderContext context, String sampler, String label, BodyTexture texture, Encoding encoding) {
            uploaded.put(
                    sampler,
                    context.createImageTexture(label, texture.width(), texture.height(), texture.rgba(), encoding));
        }

        Material material() {
            boolean hasScales = body.scales() != Scales.NONE;
            double scalesPerUnit =
                    hasScales ? SnakeBody.scalesPerUnit(body.scales().rows()) : 0;
            return new Material(
                    Map.copyOf(uploaded),
                    Map.of(
                            "reliefPerUnit", (float) (scalesPerUnit / ScaleRelief.SCALES_ALONG),
                            "reliefBegin", (float) (hasScales ? ScaleRelief.BEGIN : 0),
                            "reliefSteepest", (float) (hasScales ? ScaleRelief.STEEPEST : 0),
                            "reliefLightest", (float) ScaleRelief.LIGHTEST,
                            "patchColor", (float) body.patchColor()));
        }

        @Override
        public void close() {
            uploaded.values().forEach(ImageTexture::close);
        }
    }

    /** Draws the point under a pixel (shaders/pick.frag). */
    record Picking(RenderContext context, ShaderProgram program, FloatTarget target) implements AutoCloseable {
        private static final FloatTarget.Spec SPEC = new FloatTarget.Spec(1, 1, 6, true);

        static Picking in(RenderContext context) {
            ShaderProgram program = context.createMeshProgram(Shaders.library().load("pick.frag"));
            FloatTarget target = Resource.orClose(() -> context.createFloatTarget("pick", SPEC), program::close);
            return new Picking(context, program, target);
        }

        Optional<Pick> pick(UploadedScene uploaded, Scene scene, View.Area pixel) {
            GraphSceneManager graph = uploaded.graph(scene);
            BoundingSphere bounds = graph.bounds().orElseThrow();
            SkinSurface.setLights(program, scene);
            View view = SkinGeometry.view(viewpoint(scene, graph), bounds);
            new RenderPass(context, program, Map.of(), false)
                    .draw(graph.items(), view, pixel, target, Tile.whole(1, 1));
            float[] point = target.read(0);
            if (point[3] == 0) {
                return Optional.empty();
            }
            float[] wi = target.read(4);
            float[] wr = target.read(5);
            return Optional.of(new Pick(
                    new Vector3f(point),
                    scene.patches().region((int) point[3] - 1),
                    bounds.center(),
                    new Vector3f(target.read(1)),
                    new Vector3f(target.read(2)),
                    new Vector3f(target.read(3)),
                    new Direction(wi[0], wi[1], wi[2]),
                    new Direction(wr[0], wr[1], wr[2])));
        }

        @Override
        public void close() {
            target.close();
            program.close();
        }
    }
}
