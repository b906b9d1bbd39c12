package sunbeam.app.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
import jrtr.scene.Light;
import jrtr.scene.Material;
import jrtr.scene.RenderPass;
import jrtr.scene.Shape;
import jrtr.scene.TransformGroup;
import jrtr.scene.View;
import org.joml.Vector3f;
import sunbeam.app.gpu.Shaders;
import sunbeam.app.render.GeometryBuffer.Layout;
import sunbeam.app.render.SceneShape.Thing;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.app.scene.texture.ScaleRelief;
import sunbeam.app.scene.texture.Scales;
import sunbeam.precompute.optics.Direction;

/** A scene without its diffraction in graphics memory: meshes, textures, and what is drawn of them. A scene's sessions share it. */
final class UploadedScene implements AutoCloseable {
    private final RenderContext context;
    private final LightTexture lights;
    private final Picking picking;
    private final Map<Layout, GeometryBuffer.Cache> buffers = new EnumMap<>(Layout.class);
    private List<Integer> looks = List.of();
    private Meshes meshes;
    private List<SkinTextures> bodies = List.of();

    /** Has no scene until {@link #upload}. */
    UploadedScene(RenderContext context) {
        this.context = context;
        this.lights = new LightTexture(context);
        this.picking = Resource.orClose(() -> Picking.in(context), lights::close);
    }

    /** Returns the ground if the scene's current look draws it: the blend shows the body's own color, not diffraction alone. */
    Optional<Ground> ground(Scene scene) {
        return scene.drawsGround() ? meshes.ground() : Optional.empty();
    }

    /** Light from all directions; empty for a scene with lights of its own. */
    Optional<RadianceMap> environment() {
        return meshes.shape.environment();
    }

    /** Geometry of a scene with the uploaded meshes. */
    SkinGeometry geometry(Scene scene, int width, int height) {
        GraphSceneManager graph = graph(scene);
        var view = new Viewpoint(graph.camera().orElseThrow(), scene.view().verticalFieldOfView());
        return new SkinGeometry(graph.items(), view, width, height);
    }

    /** Uploads lights and draws their shadow maps; moving pictures have coarser ones. */
    LightTexture lights(SkinGeometry geometry, LightList list, boolean moves) {
        lights.update(list, geometry.items(), moves);
        lights.surround(list, environment());
        return lights;
    }

    private GraphSceneManager graph(Scene scene) {
        List<TransformGroup> model = new ArrayList<>();
        for (int i = 0; i < bodies.size(); i++) {
            Thing thing = meshes.shape.things().get(i);
            double rotation = scene.objects().get(thing.object()).settings().get(SceneSettings.ROTATE_PATCH);
            Material material = bodies.get(i)
                    .material()
                    .turned(rotation)
                    .with("firstPatch", SceneData.patchNumber(looks.get(thing.object()), 0))
                    .with("objectNumber", thing.object());
            model.add(new TransformGroup(
                    thing.toModel(),
                    new Shape(meshes.buffers.get(i), thing.mesh().closed(), material)));
        }
        return SceneGraph.of(scene, meshes.bounds.center(), model);
    }

    /** Returns a block's geometry; valid until the next call. */
    GeometryBuffer drawn(Layout layout, SkinGeometry geometry, Tile block) {
        return buffers.computeIfAbsent(layout, absent -> new GeometryBuffer.Cache(context, layout))
                .of(geometry, block);
    }

    /** See {@link SceneSession#pick}. */
    Optional<Pick> pick(Scene scene, View.Area pixel) {
        return picking.pick(this, scene, pixel);
    }

    /** Uploads what differs; a failure leaves the old scene. */
    void upload(Scene scene, SceneShape shape) {
        boolean keepsMeshes = meshes != null
                && SceneSharing.isSame(meshes.shape.whole(), shape.whole())
                && (meshes.ground().isPresent() || !scene.occludesSky());
        Meshes nextMeshes = keepsMeshes ? meshes.with(shape) : Meshes.upload(context, scene, shape);
        IdentityHashMap<Body, SkinTextures> all = new IdentityHashMap<>();
        bodies.forEach(body -> all.put(body.body, body));
        Set<SkinTextures> made = new HashSet<>();
        List<SkinTextures> nextBodies = Resource.orClose(
                () -> shape.things().stream()
                        .map(thing -> all.computeIfAbsent(thing.body(), body -> {
                            SkinTextures textures = new SkinTextures(context, body);
                            made.add(textures);
                            return textures;
                        }))
                        .toList(),
                () -> made.forEach(SkinTextures::close),
                () -> closeUnless(keepsMeshes, nextMeshes));
        bodies.stream().filter(body -> !nextBodies.contains(body)).forEach(SkinTextures::close);
        closeUnless(keepsMeshes, meshes);
        meshes = nextMeshes;
        bodies = nextBodies;
        looks = scene.looks();
    }

    private static void closeUnless(boolean isKept, Meshes meshes) {
        if (!isKept && meshes != null) {
            meshes.close();
        }
    }

    @Override
    public void close() {
        buffers.values().forEach(GeometryBuffer.Cache::close);
        bodies.forEach(SkinTextures::close);
        closeUnless(false, meshes);
        picking.close();
        lights.close();
    }

    /**
     * Meshes of a scene.
     *
     * @param buffers one for each thing; equal meshes share one unless they have the visible share of the sky per vertex
     * @param bounds sphere around the model, model space
     * @param ground ground below the model; present if the meshes have the visible share of the sky per vertex
     */
    private record Meshes(SceneShape shape, List<VertexBuffer> buffers, BoundingSphere bounds, Optional<Ground> ground)
            implements AutoCloseable {

        /** May wait for the visible share of the sky. */
        static Meshes upload(RenderContext context, Scene scene, SceneShape shape) {
            List<VertexBuffer> buffers = new ArrayList<>();
            try {
                return scene.occludesSky() ? underSky(context, shape, buffers) : withoutSky(context, shape, buffers);
            } catch (RuntimeException | Error failure) {
                buffers.forEach(VertexBuffer::close);
                throw failure;
            }
        }

        private static Meshes withoutSky(RenderContext context, SceneShape shape, List<VertexBuffer> buffers) {
            IdentityHashMap<Mesh, VertexBuffer> shared = new IdentityHashMap<>();
            for (Thing thing : shape.things()) {
                buffers.add(shared.computeIfAbsent(
                        thing.mesh(), mesh -> context.createVertexBuffer("mesh", mesh.toVertexData())));
            }
            return new Meshes(shape, List.copyOf(buffers), shape.bounds(), Optional.empty());
        }

        private static Meshes underSky(RenderContext context, SceneShape shape, List<VertexBuffer> buffers) {
            SkyVisibility seen = shape.sky().get();
            int first = 0;
            for (Thing thing : shape.things()) {
                int next = first + thing.mesh().vertices();
                float[] sky = Arrays.copyOfRange(seen.ofVertices(), first, next);
                buffers.add(context.createVertexBuffer("mesh", thing.mesh().toVertexData(sky)));
                first = next;
            }
            double height = SkyVisibility.ground(shape.whole());
            Ground ground = new Ground(context, shape.bounds(), height, seen);
            return new Meshes(shape, List.copyOf(buffers), shape.bounds(), Optional.of(ground));
        }

        Meshes with(SceneShape other) {
            return new Meshes(other, buffers, bounds, ground);
        }

        @Override
        public void close() {
            ground.ifPresent(Ground::close);
            buffers.forEach(VertexBuffer::close);
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
            return new Material(Map.copyOf(uploaded), scales(body));
        }

        static Map<String, Float> scales(Body body) {
            boolean hasScales = body.scales() != Scales.NONE;
            return Map.of(
                    "reliefPerUnit", (float) (body.scales().perUnit() / ScaleRelief.SCALES_ALONG),
                    "reliefBegin", (float) (hasScales ? ScaleRelief.BEGIN : 0),
                    "reliefSteepest", (float) (hasScales ? ScaleRelief.STEEPEST : 0),
                    "reliefLightest", (float) ScaleRelief.LIGHTEST);
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
            SkinGeometry geometry = uploaded.geometry(scene, pixel.pictureWidth(), pixel.pictureHeight());
            List<Light> lights = LightList.moving(scene, uploaded.environment()).all();
            Light.apply(lights.subList(0, 1), program);
            new RenderPass(context, program, Map.of(), false)
                    .draw(geometry.items(), geometry.sight(), pixel, target, Tile.whole(1, 1));
            float[] point = target.read(0);
            if (point[3] == 0) {
                return Optional.empty();
            }
            float[] tangent = target.read(1);
            float[] wi = target.read(4);
            float[] wr = target.read(5);
            return Optional.of(new Pick(
                    new Vector3f(point),
                    (int) tangent[3],
                    (int) point[3] - 1,
                    uploaded.meshes.bounds.center(),
                    new Vector3f(tangent),
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
