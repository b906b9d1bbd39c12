package sunbeam.app.render;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import jrtr.VertexData.BoundingSphere;
import jrtr.scene.Light;
import org.joml.Matrix3f;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.joml.Vector3fc;
import sunbeam.app.render.SceneShape.Thing;
import sunbeam.app.render.UploadedScene.SkinTextures;
import sunbeam.app.scene.Energy;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Viewpoint;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.BodyTexture;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MethodSettings;

/**
 * A scene of one object and one patch for a web page that draws it with the shaders of pictures.
 *
 * @param fields camera, lights, mesh and values of uniforms, by name
 * @param columns the mesh and the ground's visible share of the sky: columns of integers (see {@link Columns})
 * @param textures by the shaders' samplers
 */
public record WebScene(Map<String, Object> fields, byte[] columns, Map<String, BodyTexture> textures) {
    /** Largest step of a column's values. */
    private static final int STEPS = 65535;

    private static final int SIGNED_STEPS = 32767;
    // Texels of the surroundings along a side, and steps of a unit of their radiance.
    private static final int SKY_SIDE = 128;
    private static final int SKY_STEPS = 4096;

    /** Refuses what a page cannot draw; the message names the key of the scene and a remedy. */
    public static void check(Scene scene, String name) {
        refuseIf(
                scene.objects().size() > 1,
                name,
                "objects: " + scene.objects().size() + " of them, and a page holds one; make a scene of each");
        refuseIf(
                !scene.patches().isOne(),
                name,
                "patch: a map of " + scene.patches().regions().size()
                        + " patches, and a page holds one; give one patch");
        refuseIf(scene.hasEnvironment(), name, "environment: a page has lights; give light in its place");
        refuseIf(
                scene.get(SceneSettings.INDEX).isByWavelength(),
                name,
                "index: a file by wavelength, and a page has one table; give a number");
        refuseIf(
                scene.effectiveEnergy() != Energy.SCALAR,
                name,
                "energy: a page has no divisor by direction of light; give scalar");
        refuseIf(scene.method().isThesis(), name, "preset: a page draws no preset; leave thesis out");
        refuseIf(
                !scene.method().isTable() || scene.method().get(MethodSettings.AVERAGE) != Average.ENSEMBLE,
                name,
                "method: a page draws method table with average ensemble; leave others out");
        refuseIf(
                scene.display(1).primaries() != Primaries.SRGB
                        || scene.display(1).tone() == Tone.GAMMA,
                name,
                "tone or primaries: a page shows srgb with compress or clip; leave others out");
    }

    private static void refuseIf(boolean isUnusable, String name, String problem) {
        InputException.refuseIf(isUnusable, "scene " + name + " has no page: " + problem);
    }

    /**
     * Returns the data of a part, the only one of its scene.
     *
     * @param exposure factor of linear XYZ
     */
    public static WebScene of(SceneData data, double exposure) {
        Scene scene = data.scene();
        SceneShape shape = data.shape();
        InputException.refuseIf(
                shape.things().size() > 1,
                "mesh " + scene.mesh().name() + " places a mesh several times, and a page holds one; join them");
        Thing thing = shape.things().get(0);
        BoundingSphere bounds = shape.bounds();
        SkyVisibility sky = scene.occludesSky() ? shape.sky().get() : null;
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("exposure", exposure);
        fields.put("eye", list(scene.view().camera().centerOfProjection()));
        fields.put("lookAt", list(scene.view().camera().lookAtPoint()));
        fields.put("up", list(scene.view().camera().up()));
        fields.put("fieldOfView", scene.view().verticalFieldOfView());
        fields.put("leastAspect", Viewpoint.LEAST_ASPECT);
        fields.put("center", list(bounds.center()));
        fields.put("radius", bounds.radius());
        LightList lights = LightList.of(scene, Optional.empty());
        fields.put(
                "groups",
                lights.groups().stream()
                        .map(group -> Map.of(
                                "penumbra",
                                group.penumbra(),
                                "lights",
                                group.lights().stream().map(WebScene::light).toList()))
                        .toList());
        fields.put("hasGround", scene.drawsGround());
        Columns columns = new Columns();
        fields.put("mesh", columns.add(thing.mesh(), sky));
        fields.put("groundSide", sky == null ? 0 : SkyVisibility.GROUND_SIDE);
        if (sky != null) {
            columns.add(sky.ofGround().length, i -> STEPS * sky.ofGround()[i]);
        }
        fields.put("skySide", SKY_SIDE);
        float[] surroundings = LightTexture.octahedron(RadianceMap.sky(), SKY_SIDE);
        for (int c = 0; c < 3; c++) {
            int channel = c;
            columns.add(SKY_SIDE * SKY_SIDE, i -> SKY_STEPS * surroundings[4 * i + channel]);
        }
        fields.put("skySteps", SKY_STEPS);
        fields.put("uniforms", uniforms(data, thing, lights));
        Map<String, BodyTexture> textures = Map.of(
                "bodyTexture", thing.body().colors(),
                "skinRelief", thing.body().relief(),
                "patchDirections", thing.body().directions());
        return new WebScene(fields, columns.toBytes(), textures);
    }

    private static Map<String, Object> light(Light light) {
        return Map.of(
                "towards", list(light.towards()), "color", list(light.radiance()), "deviation", light.deviation());
    }

    private static Map<String, Object> uniforms(SceneData data, Thing thing, LightList lights) {
        Scene scene = data.scene();
        SceneShape shape = data.shape();
        Map<String, Object> uniforms = new LinkedHashMap<>();
        double mirror = new CoherenceWindow(GaussianArea.windowOf(
                                scene.method().seeing(data.patch()).choices())
                        .sigmaMeters())
                .mirrorRadiance();
        uniforms.putAll(SkinSurface.blend(scene, mirror, lights));
        uniforms.putAll(SkinSurface.reflection(scene));
        uniforms.putAll(SkinTextures.scales(thing.body()));
        uniforms.put("skyTurn", List.of(1, 0));
        uniforms.put("isEnvironment", 0);
        uniforms.put("showsGround", 1);
        uniforms.put("showsEnvironment", 0);
        uniforms.put("horizonColor", list(RadianceMap.sky().horizon().mul((float) lights.skyWeight())));
        double turn = scene.get(SceneSettings.ROTATE_PATCH);
        uniforms.put("tangentCosine", Math.cos(turn));
        uniforms.put("tangentSine", Math.sin(turn));
        uniforms.put("tabulatedSlopeVariance", Math.pow(scene.tabulatedSlopes(), 2));
        uniforms.put(
                "toneStart",
                scene.display(1).tone() == Tone.CLIP
                        ? 1e30
                        : scene.display(1).tone().start());
        uniforms.put("behind", scene.background().light());
        Matrix4f toWorld = new Matrix4f(SceneGraph.modelToWorld(
                        scene.orientation(), shape.bounds().center()))
                .mul(thing.toModel());
        uniforms.put("modelToWorld", toWorld.get(new float[16]));
        uniforms.put("normalToWorld", toWorld.normal(new Matrix3f()).get(new float[9]));
        uniforms.put("mirror", toWorld.determinant() < 0 ? -1 : 1);
        if (scene.drawsGround()) {
            Ground.place(scene, shape.bounds(), SkyVisibility.ground(shape.whole()))
                    .forEach((name, vector) -> uniforms.put(name, list(vector)));
        }
        return uniforms;
    }

    private static List<Float> list(Vector3fc vector) {
        return List.of(vector.x(), vector.y(), vector.z());
    }

    /**
     * Columns of integers. Each is written as differences from the value before (the first from 0), in four planes of bytes, lowest first;
     * even numbers stand for differences of 0 and more, odd ones for negative ones.
     */
    private static final class Columns {
        private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        void add(int count, IntToDoubleFunction value) {
            byte[] planes = new byte[Integer.BYTES * count];
            int last = 0;
            for (int i = 0; i < count; i++) {
                int next = (int) Math.round(value.applyAsDouble(i));
                int step = next - last;
                int code = (step << 1) ^ (step >> 31);
                for (int plane = 0; plane < Integer.BYTES; plane++) {
                    planes[plane * count + i] = (byte) (code >> (Byte.SIZE * plane));
                }
                last = next;
            }
            bytes.writeBytes(planes);
        }

        /** Adds vertices (position, normal, tangent, texture coordinate, sky with the sign of the frame) and indices, and describes them. */
        Map<String, Object> add(Mesh mesh, SkyVisibility sky) {
            int count = mesh.vertices();
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("vertices", count);
            fields.put("indices", mesh.indices().length);
            fields.put("positions", addRanges(mesh.positions(), 3));
            addDirections(mesh.normals(), 3);
            addDirections(mesh.tangents(), 4);
            fields.put("textureCoordinates", addRanges(mesh.textureCoordinates(), 2));
            add(
                    count,
                    i -> mesh.tangents()[4 * i + 3]
                            * (sky == null ? SIGNED_STEPS : Math.max(1, SIGNED_STEPS * sky.ofVertices()[i])));
            add(mesh.indices().length, i -> mesh.indices()[i]);
            return fields;
        }

        /** Adds {@code size} columns of values in steps of their ranges, and returns the least value and the step of each. */
        private List<double[]> addRanges(float[] values, int size) {
            List<double[]> ranges = new ArrayList<>();
            for (int c = 0; c < size; c++) {
                int component = c;
                var ends = IntStream.range(0, values.length / size)
                        .mapToDouble(i -> values[size * i + component])
                        .summaryStatistics();
                double step = Math.max(ends.getMax() - ends.getMin(), 1e-30) / STEPS;
                add(values.length / size, i -> (values[size * i + component] - ends.getMin()) / step);
                ranges.add(new double[] {ends.getMin(), step});
            }
            return ranges;
        }

        /** Adds directions as two columns, by onOctahedron of shaders/include/packed_surface.glsl. */
        private void addDirections(float[] values, int size) {
            double[][] square = new double[2][values.length / size];
            for (int i = 0; i < square[0].length; i++) {
                Vector3f on = new Vector3f(values[size * i], values[size * i + 1], values[size * i + 2]);
                on.div(Math.max(Math.abs(on.x) + Math.abs(on.y) + Math.abs(on.z), 1e-30f));
                square[0][i] = on.z < 0 ? Math.copySign(1 - Math.abs(on.y), on.x) : on.x;
                square[1][i] = on.z < 0 ? Math.copySign(1 - Math.abs(on.x), on.y) : on.y;
            }
            Arrays.stream(square).forEach(axis -> add(axis.length, i -> SIGNED_STEPS * axis[i]));
        }

        byte[] toBytes() {
            return bytes.toByteArray();
        }
    }
}
