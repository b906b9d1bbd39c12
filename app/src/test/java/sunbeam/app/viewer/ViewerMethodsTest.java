package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.Scenes;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

class ViewerMethodsTest {
    @Test
    void aSceneWhoseColoursAreMadeForEachPictureIsRefusedInOneLine() {
        Scene scene = Scenes.load("elaphe")
                .withMethod(new SceneMethod(Choices.none().with(Methods.METHOD, TableMethod.TYPE)));
        assertThatThrownBy(() -> LoadedScene.load(null, scene, null))
                .isInstanceOf(SettingException.class)
                .hasMessageContaining("for the viewer use full, nmm, pq or gem");
    }

    @Test
    void onlyMethodsThatItDrawsWithAreOffered() {
        assertThat(MethodChoice.ALL).noneMatch(choice -> choice.toString().startsWith("table"));
        assertThat(MethodChoice.ALL).anyMatch(choice -> choice.toString().equals("full"));
    }
}
