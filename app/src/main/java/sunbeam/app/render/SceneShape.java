package sunbeam.app.render;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import jrtr.VertexData.BoundingSphere;
import org.joml.Matrix4fc;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.scene.PatchAtlas;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.SceneSharing;
import sunbeam.app.scene.environment.RadianceMap;
import sunbeam.app.scene.mesh.Mesh;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.app.scene.mesh.SkyVisibility;
import sunbeam.app.scene.texture.Body;
import sunbeam.app.work.BackgroundTask;
import sunbeam.precompute.files.InputException;

/**
 * Data of a scene without its diffraction, which takes longer to load.
 *
 * @param things one for each object
 * @param whole all meshes at their places in the model
 * @param sky visible share of the sky from all vertices of the whole; computed on first use
 * @param environment light from all directions; empty for a scene with lights of its own
 */
public record SceneShape(
        List<Thing> things, Mesh whole, Supplier<SkyVisibility> sky, Optional<RadianceMap> environment) {
    // Each mesh may have two million; the copies of all fit a heap of 2 GB.
    private static final long MOST_VERTICES = 6_000_000;

    /**
     * Mesh with its textures. Objects with equal ones share them.
     *
     * @param toModel from the mesh's space to the model's
     */
    public record Thing(Mesh mesh, Body body, Matrix4fc toModel) {}

    /** Returns a sphere around the model; scenes turn about its center. */
    public BoundingSphere bounds() {
        return whole.toVertexData().bounds();
    }

    /** Loads a scene's meshes and textures, reusing those of another scene with equal settings; {@code previous} may be null. */
    static SceneShape load(Scene scene, SceneShape previous, Scene before, BlobCache cache, Consumer<String> warning) {
        Map<MeshSource, Mesh> meshes = new HashMap<>();
        Map<List<Object>, Body> bodies = new HashMap<>();
        for (int i = 0; previous != null && i < previous.things.size(); i++) {
            meshes.put(before.at(i).mesh(), previous.things.get(i).mesh());
            bodies.put(inputsOfBody(before.at(i)), previous.things.get(i).body());
        }
        List<Thing> things = new ArrayList<>();
        long vertices = 0;
        for (Scene object : scene.perObject()) {
            Mesh mesh = meshes.computeIfAbsent(object.mesh(), source -> mesh(source, warning));
            vertices += mesh.vertices();
            InputException.refuseIf(
                    scene.objects().size() > 1 && vertices > MOST_VERTICES,
                    "the scene's objects have more than " + MOST_VERTICES
                            + " vertices together; simplify their meshes");
            Body body = bodies.computeIfAbsent(inputsOfBody(object), inputs -> body(object, cache));
            things.add(new Thing(mesh, body, place(object, mesh)));
        }
        boolean sharesEnvironment =
                previous != null && before.get(SceneSettings.ENVIRONMENT).equals(scene.get(SceneSettings.ENVIRONMENT));
        Optional<RadianceMap> environment = sharesEnvironment ? previous.environment : environment(scene);
        if (previous != null && sharesPlaces(things, previous.things)) {
            return new SceneShape(things, previous.whole, previous.sky, environment);
        }
        Mesh whole = Mesh.joined(
                things.stream().map(Thing::mesh).toList(),
                things.stream().map(Thing::toModel).toList());
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
        List<Mesh> meshes = new ArrayList<>();
        List<Matrix4fc> places = new ArrayList<>();
        for (Scene object : scene.perObject()) {
            Mesh mesh = mesh(object.mesh(), warning);
            meshes.add(mesh);
            places.add(place(object, mesh));
        }
        return Mesh.joined(meshes, places);
    }

    private static Matrix4fc place(Scene object, Mesh mesh) {
        double longest = Math.max(mesh.side(0), Math.max(mesh.side(1), mesh.side(2)));
        return object.placement().toModel(mesh.toVertexData().bounds(), longest);
    }

    /** Compares meshes as objects: comparing triangles would take as long as loading them. */
    private static boolean sharesPlaces(List<Thing> things, List<Thing> others) {
        boolean isSame = things.size() == others.size();
        for (int i = 0; isSame && i < things.size(); i++) {
            isSame = SceneSharing.isSame(things.get(i).mesh, others.get(i).mesh)
                    && things.get(i).toModel.equals(others.get(i).toModel);
        }
        return isSame;
    }

    private static Mesh mesh(MeshSource source, Consumer<String> warning) {
        MeshSource.Loaded read = source.load();
        read.warnings().forEach(warning);
        return read.mesh();
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
