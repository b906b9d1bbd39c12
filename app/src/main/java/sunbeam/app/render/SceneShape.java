package sunbeam.app.render;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import jrtr.VertexData.BoundingSphere;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.units.Lengths;

/**
 * Data of a scene without its diffraction, which takes longer to load.
 *
 * @param things one for each object, or each part of its mesh
 * @param whole all meshes at their places in the model
 * @param sky visible share of the sky from all vertices of the whole; computed on first use
 * @param environment light from all directions; empty for a scene with lights of its own
 */
public record SceneShape(
        List<Thing> things, Mesh whole, Supplier<SkyVisibility> sky, Optional<RadianceMap> environment) {
    // Each mesh may have two million; the copies of all fit a heap of 2 GB.
    private static final long MOST_VERTICES = 6_000_000;

    /**
     * Mesh with its textures. Objects with equal ones share them, and parts of a file that places its mesh several times.
     *
     * @param object index of the thing's object
     * @param toModel from the mesh's space to the model's
     */
    public record Thing(int object, MeshSource.Part part, Body body, Matrix4fc toModel) {
        public Mesh mesh() {
            return part.mesh();
        }
    }

    /** Returns a sphere around the model; scenes turn about its center. */
    public BoundingSphere bounds() {
        return whole.toVertexData().bounds();
    }

    /** Loads a scene's meshes and textures, reusing those of another scene with equal settings; {@code previous} may be null. */
    static SceneShape load(Scene scene, SceneShape previous, Scene before, BlobCache cache, Consumer<String> warning) {
        Map<MeshSource, List<MeshSource.Part>> meshes = new HashMap<>();
        Map<List<Object>, Body> bodies = new HashMap<>();
        if (previous != null) {
            previous.things.stream()
                    .collect(Collectors.groupingBy(Thing::object))
                    .forEach((i, own) -> {
                        meshes.put(
                                before.at(i).mesh(),
                                own.stream().map(Thing::part).toList());
                        bodies.put(inputsOfBody(before.at(i)), own.get(0).body());
                    });
        }
        List<Thing> things = new ArrayList<>();
        long vertices = 0;
        for (Scene object : scene.perObject()) {
            List<MeshSource.Part> parts = meshes.computeIfAbsent(
                    object.mesh(), source -> load(source, warning).parts());
            vertices += parts.stream().mapToLong(part -> part.mesh().vertices()).sum();
            InputException.refuseIf(
                    scene.objects().size() > 1 && vertices > MOST_VERTICES,
                    "the scene's objects have more than " + MOST_VERTICES
                            + " vertices together; simplify their meshes");
            Body body = bodies.computeIfAbsent(inputsOfBody(object), inputs -> body(object, cache));
            List<MeshSource.Part> placed = inModel(object, parts);
            for (int i = 0; i < parts.size(); i++) {
                things.add(new Thing(
                        object.current(), parts.get(i), body, placed.get(i).place()));
            }
        }
        boolean sharesEnvironment =
                previous != null && before.get(SceneSettings.ENVIRONMENT).equals(scene.get(SceneSettings.ENVIRONMENT));
        Optional<RadianceMap> environment = sharesEnvironment ? previous.environment : environment(scene);
        List<MeshSource.Part> inModel = inModel(things);
        // Arrays of meshes are compared as objects.
        if (previous != null && inModel.equals(inModel(previous.things))) {
            return new SceneShape(things, previous.whole, previous.sky, environment);
        }
        Mesh whole = Mesh.joined(inModel);
        Supplier<SkyVisibility> computed = () -> SkyVisibility.of(whole, cache);
        Supplier<SkyVisibility> sky = scene.occludesSky() ? BackgroundTask.start(computed)::get : computed;
        return new SceneShape(things, whole, sky, environment);
    }

    private static Optional<RadianceMap> environment(Scene scene) {
        return scene.hasEnvironment()
                ? Optional.of(RadianceMap.load(scene.get(SceneSettings.ENVIRONMENT)))
                : Optional.empty();
    }

    /** Loads all meshes of a scene, at their places in the model, without textures. */
    public static Mesh wholeMesh(Scene scene, Consumer<String> warning) {
        return Mesh.joined(scene.perObject().stream()
                .flatMap(object -> inModel(object, load(object.mesh(), warning).parts()).stream())
                .toList());
    }

    /** Returns the parts of an object's mesh at its place in the model. */
    private static List<MeshSource.Part> inModel(Scene object, List<MeshSource.Part> parts) {
        Mesh mesh = Mesh.joined(parts);
        double longest = Math.max(mesh.side(0), Math.max(mesh.side(1), mesh.side(2)));
        Matrix4f toModel = object.placement().toModel(mesh.toVertexData().bounds(), longest);
        InputException.refuseIf(
                !MeshSource.isInvertible(toModel.determinant3x3()),
                "an object's size is more than 1e12 times larger or smaller than its mesh, "
                        + object.mesh().name() + ", of " + Lengths.rounded(longest, 3));
        return parts.stream()
                .map(part -> new MeshSource.Part(part.mesh(), toModel.mul(part.place(), new Matrix4f())))
                .toList();
    }

    private static List<MeshSource.Part> inModel(List<Thing> things) {
        return things.stream()
                .map(thing -> new MeshSource.Part(thing.mesh(), thing.toModel))
                .toList();
    }

    private static MeshSource.Loaded load(MeshSource source, Consumer<String> warning) {
        MeshSource.Loaded read = source.load();
        read.warnings().forEach(warning);
        return read;
    }

    private static List<Object> inputsOfBody(Scene object) {
        return List.of(
                object.get(SceneSettings.TEXTURE),
                object.effectiveScales(),
                object.get(SceneSettings.ORIENTATION_MAP),
                object.patches().map(),
                object.patches().colors());
    }

    private static Body body(Scene object, BlobCache cache) {
        PatchAtlas atlas = object.patches();
        return Body.load(
                object.get(SceneSettings.TEXTURE),
                object.effectiveScales(),
                object.get(SceneSettings.ORIENTATION_MAP),
                Body.patches(atlas.map(), atlas.colors()),
                cache);
    }
}
