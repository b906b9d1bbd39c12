package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.patch.PatchException;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.setting.SettingException;

/** What only the loading of a scene's patch and plan finds wrong. */
class SceneMistakesTest {
    private static final String SCENE = """
            {
              "mesh": "plane",
              "patch": %s,
              "camera": { "position": ["0 cm", "0 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"], "up": [0, 1, 0] },
              "light": { "direction": [0, 0, 1] },
              "texture": "none",
              "plan": {
                "method": %s
              },
              "weights": { "diffraction": 1 }
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void makeImage() throws IOException {
        BufferedImage ramp = new BufferedImage(8, 8, BufferedImage.TYPE_BYTE_GRAY);
        for (int x = 0; x < 8; x++) {
            for (int y = 0; y < 8; y++) {
                ramp.getRaster().setSample(x, y, 0, 36 * x);
            }
        }
        ImageIO.write(ramp, "png", folder.resolve("scan.png").toFile());
    }

    private Scene read(String patch, String method) throws IOException {
        return SceneReader.read(Files.writeString(folder.resolve("scene.json"), SCENE.formatted(patch, method)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    "scan.png"                               | "full" | line 3 | patch       | add for example width 65um and maxHeight 375nm
                    {"file": "scan.png", "width": "65 um"}   | "full" | line 3 | patch.maxHeight | add for example maxHeight 375nm
                    {"file": "scan.png", "width": "1 um", "maxHeight": "1 mm"} | "full" | line 3 | patch.maxHeight | absurd
                    {"file": "scan.png", "width": "50 nm", "maxHeight": "1 nm"} | "full" | line 3 | patch.width | 100 nm
                    {"file": "blaze", "width": "65 um"}      | "full" | line 3 | patch.width | leave it out
                    {"file": "blaze", "channel": "red"}      | "full" | line 3 | patch.channel | no scan or image
                    "elaphe-like"                            | "gem"  | line 7 | plan.spacing | is needed
                    "blaze"                                  | "full", "anchor": "floor" | line 8 | plan.anchor | radius
                    """)
    void mistakesNameFileLineAndKeyAndNoOption(String patch, String method, String line, String key, String words) {
        assertThatThrownBy(() -> PlaneScenes.load(read(patch, method), folder))
                .isInstanceOfAny(PatchException.class, SettingException.class)
                .hasMessageStartingWith(folder.resolve("scene.json") + ", " + line + ": ")
                .hasMessageContainingAll("\"" + key + "\":", words)
                .satisfies(failure -> assertThat(failure.getMessage()).doesNotContain("--", "\n"));
    }

    @Test
    void aPatchFromElsewhereIsNotTheFilesMistake() throws IOException {
        Scene scene = read("\"blaze\"", "\"full\"")
                .withPatch(PatchRequest.of(folder.resolve("scan.png").toString()));
        assertThatThrownBy(() -> PlaneScenes.load(scene, folder))
                .isInstanceOf(PatchException.class)
                .hasMessageStartingWith("width is missing")
                .hasMessageContaining("max height")
                .satisfies(failure -> assertThat(failure.getMessage()).doesNotContain("scene.json"));
    }

    @Test
    void whereItIsWrittenIsNoPartOfAScene() throws IOException {
        Scene scene = read("\"blaze\"", "\"full\"");
        Path copy = Files.copy(folder.resolve("scene.json"), folder.resolve("copy.json"));
        assertThat(SceneReader.read(copy)).isEqualTo(scene).hasSameHashCodeAs(scene);
    }
}
