package sunbeam.app.scene;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.setting.Choices;

/** Compares scenes by the data that they need in memory: meshes, textures and tables of their objects. */
public final class SceneSharing {
    private SceneSharing() {}

    /** True for one object, not an equal one: unchanged parts keep their objects, and comparing meshes or texels takes long. */
    public static boolean isSame(Object part, Object other) {
        return part == other;
    }

    /** True if another scene needs no other parts: meshes, textures, tables, and looks. */
    public static boolean sharesParts(Scene scene, Scene other) {
        return sharesData(scene, other) && scene.looks().equals(other.looks());
    }

    /** True if another scene needs no other meshes, textures or tables. */
    public static boolean sharesData(Scene scene, Scene other) {
        List<SceneObject> objects = scene.objects();
        return objects.size() == other.objects().size()
                && scene.method().method().equals(other.method().method())
                && scene.get(SceneSettings.ENVIRONMENT).equals(other.get(SceneSettings.ENVIRONMENT))
                && IntStream.range(0, objects.size())
                        .allMatch(i -> isSame(objects.get(i), other.objects().get(i))
                                || sharesObject(scene.at(i), other.at(i)));
    }

    private static boolean sharesObject(Scene scene, Scene other) {
        return sharesShape(scene, other)
                && scene.patches().equals(other.patches())
                && scene.get(SceneSettings.TEXTURE).equals(other.get(SceneSettings.TEXTURE))
                && scene.effectiveScales() == other.effectiveScales()
                && sharesDirections(scene, other)
                && scene.tabulatedSlopes() == other.tabulatedSlopes()
                && sharesReflectance(scene, other);
    }

    /** True if the current objects have the same mesh and place. */
    private static boolean sharesShape(Scene scene, Scene other) {
        return scene.mesh().equals(other.mesh()) && scene.placement().equals(other.placement());
    }

    private static boolean sharesDirections(Scene scene, Scene other) {
        return scene.get(SceneSettings.ORIENTATION_MAP).equals(other.get(SceneSettings.ORIENTATION_MAP));
    }

    /** True if a point of the current object's mesh is in both scenes, with the same direction of its patch. */
    public static boolean sharesPoints(Scene scene, Scene other) {
        return sharesShape(scene, other)
                && sharesDirections(scene, other)
                && scene.patches().map().equals(other.patches().map());
    }

    /** True if tables of both have the same factors: those do not depend on a constant index, unless energy is conserved. */
    public static boolean sharesReflectance(Scene scene, Scene other) {
        SkinIndex index = scene.get(SceneSettings.INDEX);
        SkinIndex otherIndex = other.get(SceneSettings.INDEX);
        boolean areConstant = !index.isByWavelength() && !otherIndex.isByWavelength();
        return scene.effectiveEnergy() == other.effectiveEnergy()
                && (index.equals(otherIndex) || (scene.effectiveEnergy() == Energy.SCALAR && areConstant));
    }

    /** Returns a scene with another's meshes, textures, tables and environment, and with its weights if the looks differ. */
    public static Scene withPartsOf(Scene other, Scene scene) {
        if (scene.objects().size() == other.objects().size()) {
            List<SceneObject> mixed = IntStream.range(0, scene.objects().size())
                    .mapToObj(i -> objectWithPartsOf(other.at(i), scene.at(i)))
                    .toList();
            Scene drawn = scene.withMethod(other.method())
                    .with(SceneSettings.ENVIRONMENT, other.get(SceneSettings.ENVIRONMENT))
                    .withObjects(mixed)
                    .at(scene.current());
            if (drawn.looks().equals(other.looks())) {
                return drawn;
            }
        }
        return other.withView(scene.view())
                .withOrientation(scene.orientation())
                .withLight(scene.light())
                .withFillLights(scene.fillLights());
    }

    private static SceneObject objectWithPartsOf(Scene other, Scene scene) {
        Choices parts = other.settings().only(SceneSettings.PARTS);
        Choices shared = sharesReflectance(scene, other) ? parts.without(SceneSettings.INDEX) : parts;
        return new SceneObject(shared.over(scene.settings()), other.patches(), other.placement());
    }
}
