package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import javax.imageio.ImageIO;
import org.joml.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.files.input.JsonVariants;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.scene.mesh.MeshSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

class SceneFileTest {
    private static final String SCENE = """
            {
              "mesh": "snake",
              "patch": "elaphe-like",
              "camera": { "position": ["10 cm", "-20 cm", "15 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
              "light": { "direction": [0, 0, 2] },
              "texture": "elaphe",
              "plan": { "tolerance": 0.01 },
              "rotatePatch": "30 deg",
              "exposure": 2,
              "weights": { "diffraction": 20 }
            }
            """;

    @TempDir
    private Path folder;

    private Path write(String text) throws IOException {
        return Files.writeString(folder.resolve("scene.json"), text);
    }

    private void assertRefused(String text, String... words) throws IOException {
        Path file = write(text);
        assertThatThrownBy(() -> Scenes.read(file))
                .isInstanceOfAny(InputException.class, SettingException.class)
                .hasMessageStartingWith(file.toString())
                .hasMessageContainingAll(words)
                .satisfies(failure -> assertThat(failure.getMessage()).doesNotContain("\n"));
    }

    /** Replaces each value of a scene by null and by each kind of value. */
    @Test
    void anyKindOfValueIsReadOrRefusedAnywhere() throws IOException {
        String rich = SCENE.replace("\"exposure\"", "\"fillLights\": [{ \"direction\": [0, 1, 1] }], \"exposure\"")
                .replace("\"elaphe-like\"", "{ \"patch\": \"elaphe-like\" }");
        for (String json : JsonVariants.of(rich)) {
            Path file = write(json);
            try {
                Scenes.read(file);
            } catch (InputException | SettingException refused) {
                assertThat(refused).hasMessageStartingWith(file + ", line 1: ");
            }
        }
    }

    @Test
    void keysSetTheirValues() throws IOException {
        Scene scene = Scenes.read(write(SCENE));
        assertThat(scene.view().camera().centerOfProjection().y()).isEqualTo(-0.2f);
        assertThat(scene.light().towards().z()).isEqualTo(1);
        assertThat(scene.get(SceneSettings.ROTATE_PATCH)).isEqualTo(Math.toRadians(30));
        assertThat(scene.method().get(TOLERANCE)).isEqualTo(0.01);
        assertThat(scene.method().get(AVERAGE)).as("a mesh's default").isEqualTo(Average.ENSEMBLE);
        assertThat(scene.get(SceneSettings.TEXTURE_WEIGHT)).isEqualTo(1);
    }

    private static String with(String objects) {
        return SCENE.replace("\"exposure\"", "\"objects\": [" + objects.strip() + "], \"exposure\"");
    }

    @Test
    void anObjectHasFromTheSceneWhatItLacks() throws IOException {
        Scene scene = Scenes.read(write(with("""
                { "mesh": "disc", "patch": "disc", "position": ["1 cm", "0 m", "2 mm"], "size": "5 cm" },
                { "orientation": [0, 0, 1, 0], "weights": { "diffraction": 3 }, "rotatePatch": "10 deg" }
                """)));

        assertThat(scene.objects()).hasSize(2);
        assertThat(scene.mesh()).isEqualTo(MeshSource.of("disc"));
        assertThat(scene.get(SceneSettings.DIFFRACTION)).as("the scene's").isEqualTo(20);
        assertThat(scene.placement().position()).isEqualTo(new Vector3f(0.01f, 0, 0.002f));
        assertThat(scene.placement().size()).hasValue(0.05);
        Scene second = scene.at(1);
        assertThat(second.mesh()).isEqualTo(MeshSource.of("snake"));
        assertThat(second.patch().patch()).isEqualTo("elaphe-like");
        assertThat(second.get(SceneSettings.DIFFRACTION)).isEqualTo(3);
        assertThat(second.get(SceneSettings.ROTATE_PATCH)).isEqualTo(Math.toRadians(10));
        assertThat(second.placement().orientation().z()).isEqualTo(1);
        assertThat(second.at(0)).isEqualTo(scene);
        assertThat(second.get(SceneSettings.EXPOSURE)).isEqualTo(scene.get(SceneSettings.EXPOSURE));

        Path copy = folder.resolve("copy.json");
        SceneWriter.write(copy, Overwrite.REFUSE, second);
        assertThat(Scenes.read(copy)).isEqualTo(scene);
        assertThat(SceneWriter.describe(second)).isEqualTo(SceneWriter.describe(scene));
    }

    @Test
    void aChangeOfEachObjectChangesAll() throws IOException {
        Scene scene = Scenes.read(write(with("{ \"mesh\": \"disc\" }, { \"roughness\": \"1 deg\" }")));
        Choices rough = Choices.none().with(SceneSettings.ROUGHNESS, 0.05);

        assertThat(scene.each(object -> object.with(rough)).objects())
                .allMatch(object -> object.settings().get(SceneSettings.ROUGHNESS) == 0.05);
    }

    @Test
    void wrongObjectsAreRefused() throws IOException {
        String many = String.join(",", Collections.nCopies(SceneObject.MOST, "{}"));
        assertThat(Scenes.read(write(with(many))).objects()).hasSize(SceneObject.MOST);
        assertRefused(with(many + ", {}"), "objects", "at most 64");
        assertRefused(with(""), "objects", "is empty; give 1 to 64 objects");
        assertRefused(with("{ \"size\": \"0 m\" }"), "objects.size", "give 1 nm to 1e6 m");
        assertRefused(with("{ \"size\": 3 }"), "objects.size", "unit");
        assertRefused(with("{ \"position\": [\"1 m\", \"2 m\"] }"), "objects.position", "3 values");
        assertRefused(with("{ \"orientation\": [1, 1, 1, 1] }"), "objects.orientation", "unit quaternion");
        assertRefused(with("{ \"sise\": \"1 m\" }"), "objects.sise", "unknown key");
        assertRefused(with("{ \"patch\": 3 }"), "objects.patch");
        assertRefused(with("{ \"ground\": \"#ffffff\" }"), "objects.ground", "unknown key");
        assertRefused(with("{}").replace("\"mesh\": \"snake\",", ""), "mesh", "missing");
    }

    @Test
    void aMeshFilesUnitIsKeptWithIt() throws IOException {
        Files.writeString(folder.resolve("square.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Scene scene = Scenes.read(write(SCENE.replace("\"snake\",", "\"square.obj\", \"meshUnit\": \"mm\",")));
        Path copy = folder.resolve("copy.json");

        SceneWriter.write(copy, Overwrite.REFUSE, scene);

        assertThat(scene.mesh().unit()).isEqualTo(MeshSource.Unit.MM);
        assertThat(Scenes.read(copy).mesh()).isEqualTo(scene.mesh());
        Choices other = Choices.none().with(SceneSettings.MESH, "sphere");
        assertThat(scene.with(other).mesh()).as("the unit is of one file").isEqualTo(MeshSource.of("sphere"));
        assertRefused(
                SCENE.replace("\"snake\",", "\"snake\", \"meshUnit\": \"ell\","), "meshUnit", "m, cm, mm, um, in");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    "mesh"               | "mush"             | line 1  | mesh          | missing, and "mush" is unknown
                    "light"              | "lights"           | line 1  | light         | missing, and "lights" is unknown
                    "rotatePatch"        | "rotatepatch"      | line 8  | rotatepatch   | unknown key
                    "30 deg"             | 30                 | line 8  | rotatePatch   | unit
                    "diffraction": 20    | "diffraction": -1  | line 10 | weights.diffraction | out of range
                    "diffraction": 20    | "difraction": 20   | line 10 | weights.difraction | known are
                    "elaphe",            | "no.png",          | line 6  | texture       | no file
                    "elaphe",            | "../x.png",        | line 6  | texture       | folder
                    "tolerance": 0.01    | "method": "magic"  | line 7  | plan.method   | magic
                    "tolerance": 0.01    | "method": "reference" | line 7 | plan.method | full, table, nmm, pq, gem
                    "tolerance": 0.01    | "preset": "thesis"  | line 7  | plan.preset   | or use method full
                    "tolerance": 0.01    | "method": "full", "tolerance": 0.01, "preset": "thesis" | line 7 | plan.tolerance | preset thesis
                    "elaphe-like"        | {"file": "blaze", "width": "5 pm"} | line 3 | patch.width | 1 nm to 1 m
                    "exposure": 2        | "exposure": "two"  | line 9  | exposure      | auto
                    "exposure": 2        | "exposure": -1     | line 9  | exposure      | -1 is out of range; give auto, or a number above 0 to 1e9
                    [0, 0, 2]            | [0, 0, 0]          | line 5  | light.direction | no direction
                    [0, 0, 2]            | [0, 0]             | line 5  | light.direction | 3 values
                    "0 m", "0 m", "0 m"  | "10 cm", "-20 cm", "15 cm" | line 4 | "camera": | differ
                    "lookAt":            | "up": [10, -20, 15], "lookAt": | line 4 | "camera": | up must not lie along the line of sight
                    "snake"              | null               | line 2  | mesh          | text
                    "camera": {          | "camera": { "fieldOfView": "1e-300 deg", | line 4 | camera.fieldOfView | out of range
                    [0, 0, 2]            | [0, 0, 2], "angularDiameter": "40 deg" | line 5 | angularDiameter | 40 deg is out of range; give 0 deg to 15 deg
                    "exposure": 2        | "exposure": 2, "fillLights": [{ "direction": [0, 0, 0] }] | line 9 | fillLights | no direction
                    "exposure": 2        | "exposure": 2, "fillLights": { "direction": [0, 0, 1] } | line 9 | fillLights | must be a list
                    "exposure": 2        | "exposure": 2, "fillLights": [{ "direction": [0, 0, 1], "color": 1 }] | line 9 | fillLights | color
                    "exposure": 2        | "exposure": 2, "fillLights": [{}, {}, {}, {}, {}, {}, {}, {}] | line 9 | fillLights | at most 7
                    "elaphe-like"        | { "map": "../m.png", "#ff0000": "blaze" } | line 3 | patch.map | ../m.png
                    "elaphe-like"        | { "map": "none.png", "#ff0000": "blaze" } | line 3 | patch.map | is no file
                    "elaphe-like"        | { "map": "m.png" } | line 3 | patch | has 0 patches beside its map
                    "elaphe-like"        | { "map": "m.png", "red": "blaze" } | line 3 | patch | is no color
                    "elaphe-like"        | { "map": "m.png", "#ff0000": "blaze", "#FF0000": "disc" } | line 3 | patch | gives #ff0000 two patches
                    "elaphe-like"        | { "map": "m.png", "#ff0000": "no-such" } | line 3 | patch.#ff0000 | no-such
                    "elaphe-like"        | { "map": "m.png", "#ff0000": 3 } | line 3 | patch.#ff0000 | must be an object
                    """)
    void mistakesNameLineAndKey(String found, String replacement, String line, String key, String words)
            throws IOException {
        Files.createFile(folder.resolve("m.png"));
        assertThat(SCENE).contains(found);
        assertRefused(SCENE.replace(found, replacement), line + ":", key, words);
    }

    @Test
    void brokenFilesAreNoScenes() throws IOException {
        assertRefused(SCENE.replace("\"snake\",", "\"snake\""), "line 3", "no valid JSON");
        assertRefused(SCENE + "{}", "line 12", "follows");
        assertRefused("[]", "object");
        assertRefused(SCENE.replace("\"exposure\"", "\"mesh\""), "line 9", "the key \"mesh\" stands twice");
        assertThatThrownBy(() -> Scenes.read(folder.resolve("none.json")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("no such file");
    }

    @Test
    void linksMayNotLeadOut() throws IOException {
        Path outside = Files.createTempFile("sunbeam", ".png");
        try {
            Files.createSymbolicLink(folder.resolve("link.png"), outside);
            assertRefused(SCENE.replace("\"elaphe\",", "\"link.png\","), "line 6", "texture", "leads out");
        } finally {
            Files.delete(outside);
        }
    }

    @ParameterizedTest
    @MethodSource("sunbeam.app.scene.Scenes#builtIn")
    void builtInScenesAreReadAndWrittenAlikeAndHaveASmallPicture(String name) throws IOException {
        Scene scene = Scenes.load(name);
        Path file = folder.resolve(name + ".json");
        SceneWriter.write(file, Overwrite.REFUSE, scene);
        assertThat(Scenes.read(file)).isEqualTo(scene);
        assertThat(scene.get(SceneSettings.TITLE)).isNotEmpty();
        BufferedImage picture = ImageIO.read(Scenes.picture(name));
        assertThat(new int[] {picture.getWidth(), picture.getHeight()}).containsExactly(48, 36);
    }

    @Test
    void filesAreWrittenRelativeToTheScene() throws IOException {
        Files.createDirectory(folder.resolve("textures"));
        Path texture = Files.write(folder.resolve("textures/skin.png"), new byte[1]);
        String patches = "{ \"map\": \"textures/skin.png\", \"#0000ff\": \"blaze\", \"#ff0000\": \"disc\" }";
        String lights = """
                "fillLights": [{ "direction": [0.5, 0.1, 0.6], "intensity": 0.4, "angularDiameter": "12 deg" },
                { "direction": [0, 1, 1] }], "orientationMap": "textures/skin.png", "exposure"\
                """;
        String text = SCENE.replace("\"elaphe\"", "\"textures/skin.png\"")
                .replace("\"elaphe-like\"", patches)
                .replace("\"exposure\"", lights);
        Scene scene = Scenes.read(write(text));
        assertThat(scene.patches().regions()).hasSize(2);
        assertThat(scene.fillLights()).hasSize(2);
        assertThat(Path.of(scene.get(SceneSettings.ORIENTATION_MAP))).isEqualTo(texture.toAbsolutePath());
        assertThat(Path.of(scene.get(SceneSettings.TEXTURE))).isEqualTo(texture.toAbsolutePath());

        Path copy = folder.resolve("copy.json");
        SceneWriter.write(copy, Overwrite.REFUSE, scene);
        assertThat(copy).content().contains("\"textures/skin.png\"").doesNotContain(folder.toString());
        assertThat(Scenes.read(copy)).isEqualTo(scene);

        Path elsewhere = folder.resolve("textures/elsewhere.json");
        Scene moved =
                scene.with(SceneSettings.TEXTURE, folder.resolve("scene.json").toString());
        assertThatThrownBy(() -> SceneWriter.write(elsewhere, Overwrite.REFUSE, moved))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("copy it there");
    }

    /** With an environment the scene needs no light of its own. */
    @Test
    void anEnvironmentIsReadAndWritten() throws IOException {
        Files.write(folder.resolve("room.hdr"), new byte[1]);
        String object = "\"environment\": { \"file\": \"room.hdr\", \"rotation\": \"30 deg\", \"intensity\": 2,"
                + " \"lights\": 300 }, \"exposure\"";
        String withoutLight = SCENE.replaceAll("\"light\": \\{[^}]*},?", "").replace("\"exposure\"", object);
        Scene scene = Scenes.read(write(withoutLight));
        assertThat(scene.hasEnvironment()).isTrue();
        assertThat(scene.get(SceneSettings.ENVIRONMENT_ROTATION)).isEqualTo(Math.toRadians(30));
        assertThat(scene.get(SceneSettings.ENVIRONMENT_LIGHTS)).hasValue(300);
        Path copy = folder.resolve("copy.json");
        SceneWriter.write(copy, Overwrite.REFUSE, scene);
        assertThat(copy).content().contains("\"room.hdr\"").doesNotContain(folder.toString());
        assertThat(Scenes.read(copy)).isEqualTo(scene);

        String named = SCENE.replace("\"exposure\"", "\"environment\": \"overcast\", \"exposure\"");
        assertThat(Scenes.read(write(named)).get(SceneSettings.ENVIRONMENT)).isEqualTo("overcast");
        String wrong = SCENE.replace("\"exposure\"", "\"environment\": \"cellar\", \"exposure\"");
        assertThatThrownBy(() -> Scenes.read(write(wrong))).hasMessageContaining("window, overcast, sun, sky, none");
    }
}
